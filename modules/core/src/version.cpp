// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/version.hpp>

namespace wm3d {

std::string_view version() {
    return WM3D_VERSION;
}

} // namespace wm3d
