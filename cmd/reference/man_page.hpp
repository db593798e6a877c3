// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Manual pages, in the man macros of troff.
#pragma once

#include <span>
#include <string>

#include "reference/description.hpp"

namespace wm3d::cmd::reference {

/// wm3d-NAME(1).
std::string man_page(const Page& page);

/// wm3d(1): the list of commands, by group.
std::string man_overview(std::span<const Command> commands);

} // namespace wm3d::cmd::reference
