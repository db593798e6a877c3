// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Telling a caller how far long work has come.
#pragma once

#include <functional>
#include <string_view>

namespace wm3d {

/// Called now and then with the name of the stage and the part of it that is done (0 to 1). Never called
/// from two threads at once. An empty function is allowed everywhere and means silence.
using Progress = std::function<void(std::string_view stage, double done)>;

inline void notify(const Progress& progress, std::string_view stage, double done) {
    if (progress)
        progress(stage, done);
}

} // namespace wm3d
