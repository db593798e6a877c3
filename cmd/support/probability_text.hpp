// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Probabilities as sentences name them.
#pragma once

#include <string>

namespace wm3d::cmd {

/// 10^log10_p in a few characters: 0.03, or 3.1e-25 where it is small.
std::string power_of_ten(double log10_p);

} // namespace wm3d::cmd
