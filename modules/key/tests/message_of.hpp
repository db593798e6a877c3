// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What an action says when it fails.
#pragma once

#include <functional>
#include <string>

#include <wm3d/core/error.hpp>

namespace wm3d::key::test {

/// The message of an error of that kind, or that there was none.
template<typename Kind>
std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Kind& error) {
        return error.what();
    }
    return "no error";
}

} // namespace wm3d::key::test
