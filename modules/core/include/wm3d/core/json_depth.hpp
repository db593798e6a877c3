// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  JSON from strangers: what a library can walk without running out of stack.
#pragma once

#include <cstddef>
#include <string_view>

namespace wm3d {

/// Deepest nesting of brackets that is read. Models, receipts and logs need less than ten levels, what others
/// hang onto them hardly more.
inline constexpr std::size_t max_json_depth = 256;

/// How deep brackets nest in a JSON text, outside of its strings. The text needn't be valid.
std::size_t json_depth(std::string_view text);

/// Every JSON text that wm3d reads passes here first: libraries copy and print what they parsed by recursion,
/// and some hundred kilobytes of brackets would overflow the stack.
/// \throw InputError  if the text nests deeper than `max_json_depth`; messages call it `name`
void check_json_depth(std::string_view text, std::string_view name);

} // namespace wm3d
