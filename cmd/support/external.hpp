// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Commands that others provide: `wm3d NAME` runs the executable `wm3d-NAME`, as git and cargo do.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

namespace wm3d::cmd {

/// The first executable regular file `wm3d-NAME` in the folders of `search_path` (colon-separated, as PATH).
/// Names with a slash or a leading hyphen are never found.
std::optional<std::filesystem::path> find_external(std::string_view name, std::string_view search_path);

/// Replaces this process by `executable` with `arguments` (without its own name). Returns only by throwing.
/// \throw Error  if the system refuses
[[noreturn]] void run_external(const std::filesystem::path& executable, std::span<char* const> arguments);

} // namespace wm3d::cmd
