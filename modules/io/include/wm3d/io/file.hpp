// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Whole files in and out of memory.
#pragma once

#include <filesystem>
#include <memory>
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

/// Several files that belong together. All of them are written whole and flushed to the disk before the first
/// takes its name; a disk that is full, or a name that can't be taken, leaves everything as it was.
class FileSet {
public:
    explicit FileSet(const WriteOptions& options = {});
    FileSet(FileSet&&) noexcept;
    FileSet& operator=(FileSet&&) noexcept;
    /// Leaves nothing of files that were not committed.
    ~FileSet();

    /// Writes a file that has no name yet.
    /// \throw OutputError  if a file of that name exists and may not be replaced, or it can't be written
    void add(const std::filesystem::path& path, std::string_view bytes);

    /// Gives the files their names, in the order in which they were added: first what others refer to.
    /// \throw OutputError  if one can't be had; then all names stand for what they stood for before
    void commit();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Adds a patched file and its side files, which go into the folder of `path`; side files first, so that the
/// main file never names one that is not there.
/// \throw OutputError as FileSet::add
void add_files(FileSet& set, const std::filesystem::path& path, const PatchedFiles& files);

/// Writes a patched file and its side files, all or none.
/// \throw OutputError  as FileSet
void write_files(const std::filesystem::path& path, const PatchedFiles& files,
                 const WriteOptions& options = {});

} // namespace wm3d::io
