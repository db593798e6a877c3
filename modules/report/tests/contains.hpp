// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Whether a text contains another.
#pragma once

#include <string>

namespace wm3d::report::test {

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

} // namespace wm3d::report::test
