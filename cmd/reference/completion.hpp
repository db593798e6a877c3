// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Completion scripts of shells. Each offers the commands, the options of the command at hand, and for a
/// value the words or files that it may be.
#pragma once

#include <span>
#include <string>

#include "reference/description.hpp"

namespace wm3d::cmd::reference {

std::string bash_completion(std::span<const Page> pages);
std::string zsh_completion(std::span<const Page> pages);
std::string fish_completion(std::span<const Page> pages);

} // namespace wm3d::cmd::reference
