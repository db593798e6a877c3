// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Where commands get the passphrase of a key from.
#pragma once

#include <string_view>

#include <wm3d/key/passphrase.hpp>

namespace wm3d::cmd {

/// The first line that can be read from a file descriptor, without its end.
/// \throw InputError  if there is none, or the descriptor isn't open
key::Passphrase passphrase_from(int descriptor);

/// Whether there is a terminal that somebody could be asked on.
bool can_ask();

/// Asks on the terminal, which doesn't show what is typed.
/// \throw InputError  if nothing is typed
key::Passphrase ask_passphrase(std::string_view prompt);

/// Keeps what this process has in memory out of core dumps and out of reach of other processes of its user.
void protect_memory();

} // namespace wm3d::cmd
