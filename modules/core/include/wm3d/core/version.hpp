// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Which release this is.
#pragma once

#include <string_view>

namespace wm3d {

/// The version of the library that is linked, as "1.2.3".
std::string_view version();

} // namespace wm3d
