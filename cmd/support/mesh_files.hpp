// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The mesh files that a command reads and writes; "-" is standard input or output.
#pragma once

#include <string>
#include <string_view>

#include <wm3d/io.hpp>

#include "support/output.hpp"

namespace CLI {
class App;
}

namespace wm3d::cmd {

struct MeshFiles {
    std::string input;
    std::string output;
    std::string format;     ///< of "-" and of names without a known extension; empty: not given
    bool overwrite = false; ///< replace an output that exists
    bool any_size = false;  ///< lift the limits on what a small file may grow to

    io::Limits limits() const { return any_size ? io::Limits::none() : io::Limits{}; }
};

/// Adds the argument IN, --format, and --any-size, which only the error that it lifts speaks of.
void add_input(CLI::App& app, MeshFiles& files);

/// Adds -o/--output, --overwrite and --format.
void add_output(CLI::App& app, MeshFiles& files);

/// Finds out before any work whether the output could be written: a known format, no file in the way, a
/// folder to hold it, standard output not promised twice.
/// \return the format to write
/// \throw ParameterError, OutputError
io::Format check_output(const MeshFiles& files, const Output& output);

/// As `check_output`, for an output that is no mesh.
/// \throw OutputError
void check_target(const std::string& path, bool overwrite);

/// \throw InputError  if it is no mesh; ParameterError if its format isn't known
io::Model read_input(const MeshFiles& files);

/// Reads a mesh file that no --format applies to, such as a reference.
io::Model read_mesh(const std::string& path);

/// Writes the bytes of a mesh file to the output.
void write_output(const MeshFiles& files, std::string_view bytes, Output& output);

/// "standard input" for "-", else the path.
std::string display_name(const std::string& path, std::string_view stream = "standard input");

} // namespace wm3d::cmd
