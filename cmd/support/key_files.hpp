// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Key files as the commands read them.
#pragma once

#include <string>

#include <wm3d/key/key_file.hpp>

#include "support/output.hpp"

namespace wm3d::cmd {

/// Reads a key file, and warns where other users of the machine can read it too. The passphrase of a key that
/// has one comes from --passphrase-fd, or is asked for on the terminal.
/// \throw InputError  as key::Key::load
key::Key load_key(const std::string& path, Output& output);

} // namespace wm3d::cmd
