// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <wm3d/core/descriptor.hpp>
#include <wm3d/core/error.hpp>
#include <wm3d/io/file.hpp>

#include "temporary_file.hpp"

namespace wm3d::io {

namespace {

/// Files that may be held open until all of them are written.
constexpr std::size_t most_open = 100;

/// Permissions of the file that is about to be replaced; nothing if there is none.
std::optional<unsigned> check_existing(const std::filesystem::path& path, const WriteOptions& options) {
    struct stat status {};
    if (!options.overwrite && ::lstat(path.c_str(), &status) == 0 && S_ISLNK(status.st_mode) &&
        ::stat(path.c_str(), &status) != 0) // it leads nowhere, but it is there
        throw OutputError(fmt::format("{}: the file exists; --overwrite replaces it", path.string()),
                          ErrorCode::output_exists);
    if (::stat(path.c_str(), &status) != 0)
        return std::nullopt;
    if (S_ISDIR(status.st_mode))
        throw OutputError(fmt::format("{}: this is a folder; name a file", path.string()));
    if (!S_ISREG(status.st_mode)) // a device, a pipe: its name must not go to a file
        throw OutputError(fmt::format(
            "{}: this is no regular file; write to '-' and let the shell redirect it", path.string()));
    if (!options.overwrite)
        throw OutputError(fmt::format("{}: the file exists; --overwrite replaces it", path.string()),
                          ErrorCode::output_exists);
    return status.st_mode & 0777;
}

} // namespace

void require_writable(const std::filesystem::path& path, const WriteOptions& options) {
    check_existing(path, options);
    std::error_code ignored;
    const std::filesystem::path folder = path.parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder, ignored))
        throw OutputError(
            fmt::format("{}: there is no folder {}; create it first", path.string(), folder.string()));
}

struct FileSet::Impl {
    WriteOptions options;
    std::vector<TemporaryFile> files;
};

FileSet::FileSet(const WriteOptions& options) : impl_(std::make_unique<Impl>()) {
    impl_->options = options;
}
FileSet::FileSet(FileSet&&) noexcept = default;
FileSet& FileSet::operator=(FileSet&&) noexcept = default;
FileSet::~FileSet() = default;

void FileSet::add(const std::filesystem::path& path, std::string_view bytes) {
    for (const TemporaryFile& file : impl_->files)
        if (file.target().lexically_normal() == path.lexically_normal())
            throw OutputError(
                fmt::format("{}: two outputs have this name; give each its own", path.string()));
    TemporaryOptions options;
    options.mode = check_existing(path, impl_->options);
    if (impl_->options.private_to_owner)
        options.mode = 0600;
    options.unnamed = impl_->files.size() < most_open;
    impl_->files.emplace_back(path, bytes, options);
}

void FileSet::commit() {
    std::vector<TemporaryFile> files = std::move(impl_->files);
    impl_->files.clear();
    using Existing = TemporaryFile::Existing;
    std::size_t done = 0;
    try {
        for (; done < files.size(); ++done)
            files[done].commit(!impl_->options.overwrite  ? Existing::refuse
                               : done + 1 == files.size() ? Existing::replace // nothing can fail after it
                                                          : Existing::keep);
    } catch (...) {
        while (done > 0)
            files[--done].roll_back();
        throw;
    }
    for (const TemporaryFile& file : files)
        sync_folder_of(file.target());
}

} // namespace wm3d::io
