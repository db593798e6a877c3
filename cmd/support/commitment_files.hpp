// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A commitment with the files by which others can date it.
#pragma once

#include <string>

#include <wm3d/commitment/commitment.hpp>
#include <wm3d/io/file.hpp>

namespace CLI {
class App;
}

namespace wm3d::cmd {

/// Adds --commitment to a command that writes one.
void add_commitment_output(CLI::App& app, std::string& path);

/// Finds out before any work whether the files could be written. Nothing is asked of an empty path.
/// \throw OutputError
void check_commitment_target(const std::string& path, bool overwrite);

/// Adds FILE, FILE.sha256 and, where this build can make one, FILE.tsq, a time stamp request. Nothing is
/// added for an empty path.
/// \throw OutputError  as io::FileSet::add
void add_commitment_files(io::FileSet& set, const std::string& path,
                          const commitment::Commitment& commitment);

} // namespace wm3d::cmd
