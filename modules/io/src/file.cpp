// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/io/file.hpp>

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <wm3d/core/descriptor.hpp>
#include <wm3d/core/error.hpp>

namespace wm3d::io {

namespace {

[[noreturn]] void fail_reading(const std::filesystem::path& path, int error) {
    throw InputError(
        fmt::format("{}: the file can't be read: {}", path.string(), std::generic_category().message(error)),
        ErrorCode::unreadable_input);
}

std::string read_all(int fd, std::size_t expected, const std::filesystem::path& path) {
    std::string bytes(expected, '\0');
    std::size_t size = 0;
    for (;;) {
        if (size == bytes.size()) // pipes and growing files
            bytes.resize(bytes.size() + bytes.size() / 2 + 4096);
        const ssize_t got = ::read(fd, bytes.data() + size, bytes.size() - size);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            fail_reading(path, errno);
        if (got == 0)
            break;
        size += static_cast<std::size_t>(got);
    }
    bytes.resize(size);
    return bytes;
}

} // namespace

std::string read_file(const std::filesystem::path& path) {
    const Descriptor fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (fd.get() < 0)
        fail_reading(path, errno);
    struct stat status {};
    if (::fstat(fd.get(), &status) != 0)
        fail_reading(path, errno);
    if (S_ISDIR(status.st_mode))
        throw InputError(fmt::format("{}: this is a folder; name a mesh file", path.string()),
                         ErrorCode::unreadable_input);
    return read_all(fd.get(), static_cast<std::size_t>(status.st_size) + 1, path); // one more to see the end
}

void write_file(const std::filesystem::path& path, std::string_view bytes, const WriteOptions& options) {
    FileSet files(options);
    files.add(path, bytes);
    files.commit();
}

void add_files(FileSet& set, const std::filesystem::path& path, const PatchedFiles& files) {
    for (const SideFile& side : files.side_files)
        set.add(path.parent_path() / side.name, side.bytes);
    set.add(path, files.bytes);
}

void write_files(const std::filesystem::path& path, const PatchedFiles& files, const WriteOptions& options) {
    FileSet set(options);
    add_files(set, path, files);
    set.commit();
}

} // namespace wm3d::io
