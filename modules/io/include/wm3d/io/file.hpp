// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Whole files in and out of memory.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <wm3d/io/model.hpp>

namespace wm3d::io {

/// All bytes of a file.
/// \throw InputError  if it is missing, a folder, or can't be read
std::string read_file(const std::filesystem::path& path);

struct WriteOptions {
    bool overwrite = false;        ///< replace a file that exists
    bool private_to_owner = false; ///< mode 0600 instead of what the umask leaves
};

/// Finds out before any work whether a file could be written: nothing in its way, and a folder to hold it.
/// \throw OutputError
void require_writable(const std::filesystem::path& path, const WriteOptions& options = {});

/// Writes a whole file or nothing: into a temporary file in the same folder, which is flushed to the disk and
/// then takes the name in one step.
/// \throw OutputError  if the file exists and `overwrite` is false, or can't be written
void write_file(const std::filesystem::path& path, std::string_view bytes, const WriteOptions& options = {});

/// Writes a patched file and its side files into the folder of `path`; side files first, so that the main
/// file never names one that is not there. Nothing is written where any of them exists and may not be
/// replaced. \throw OutputError  as write_file
void write_files(const std::filesystem::path& path, const PatchedFiles& files,
                 const WriteOptions& options = {});

} // namespace wm3d::io
