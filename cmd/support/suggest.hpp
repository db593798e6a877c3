// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  "Did you mean".
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace wm3d::cmd {

/// Least number of inserted, removed, replaced and swapped neighbouring letters that turns `a` into `b`
/// (optimal string alignment distance).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name nearest to `word`, if it is near enough to be a slip of the finger: at most a third of the
/// word's letters differ (at least one, at most three). The first wins a tie.
std::optional<std::string_view> nearest_name(std::string_view word, std::span<const std::string_view> names);

} // namespace wm3d::cmd
