// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Damage by name: the attacks that a mark is to survive.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <wm3d/study/trials.hpp>

namespace wm3d::study {

struct NamedDamage {
    std::string name; ///< as attack::to_string writes it; "none" without one
    Damage damage;
};

/// Reads attacks joined by commas, "noise:0.3,simplify:90"; each may be a chain joined by '+'. A comma before
/// something that is no attack's name separates values of the attack before it, as in "crop:30,cap=yes".
/// \throw ParameterError  if an attack is unknown, or if this build has none
std::vector<NamedDamage> parse_damages(std::string_view text);

} // namespace wm3d::study
