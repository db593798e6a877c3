// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/io/file.hpp>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>

namespace wm3d::io {

namespace {

/// A file descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return fd_; }
    bool close() {
        const int fd = fd_;
        fd_ = -1;
        return fd < 0 || ::close(fd) == 0;
    }

private:
    int fd_;
};

[[noreturn]] void fail_reading(const std::filesystem::path& path, int error) {
    throw InputError(
        fmt::format("{}: the file can't be read: {}", path.string(), std::generic_category().message(error)));
}

[[noreturn]] void fail_writing(const std::filesystem::path& path, int error) {
    throw OutputError(fmt::format("{}: the file can't be written: {}", path.string(),
                                  std::generic_category().message(error)));
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

bool write_all(int fd, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t put = ::write(fd, bytes.data(), bytes.size());
        if (put < 0 && errno == EINTR)
            continue;
        if (put < 0)
            return false;
        bytes.remove_prefix(static_cast<std::size_t>(put));
    }
    return true;
}

/// Mode that a file made now would get.
mode_t default_mode() {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
}

void refuse_existing(const std::filesystem::path& path, const WriteOptions& options) {
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode))
        throw OutputError(fmt::format("{}: this is a folder; name a file", path.string()));
    if (!options.overwrite && ::lstat(path.c_str(), &status) == 0) // a link that leads nowhere counts
        throw OutputError(fmt::format("{}: the file exists; --overwrite replaces it", path.string()));
}

/// A temporary file in the folder of its target; removed unless it was given the target's name.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::filesystem::path& target)
        : target_(target),
          path_((target.parent_path() / fmt::format(".{}.XXXXXX", target.filename().string())).string()),
          file_(::mkstemp(path_.data())) {
        if (file_.get() < 0)
            fail_writing(target_, errno);
    }
    ~TemporaryFile() {
        if (!path_.empty())
            ::unlink(path_.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    void write(std::string_view bytes, mode_t mode) {
        if (!write_all(file_.get(), bytes) || ::fchmod(file_.get(), mode) != 0 || ::fsync(file_.get()) != 0 ||
            !file_.close())
            fail_writing(target_, errno);
    }

    /// Takes the target's name; without `overwrite`, fails if someone else took it meanwhile.
    void commit(bool overwrite) {
        if (!overwrite && ::link(path_.c_str(), target_.c_str()) == 0)
            return; // the destructor removes the first name
        if (!overwrite && errno == EEXIST)
            throw OutputError(fmt::format("{}: the file exists; --overwrite replaces it", target_.string()));
        // Replacing, or a file system without hard links.
        if (::rename(path_.c_str(), target_.c_str()) != 0)
            fail_writing(target_, errno);
        path_.clear();
    }

private:
    std::filesystem::path target_;
    std::string path_;
    Descriptor file_;
};

/// Makes a new name in a folder durable; file systems that can't are left alone.
void sync_folder(const std::filesystem::path& path) {
    const std::filesystem::path folder = path.parent_path().empty() ? "." : path.parent_path();
    const Descriptor fd(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (fd.get() >= 0)
        static_cast<void>(::fsync(fd.get()));
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
        throw InputError(fmt::format("{}: this is a folder; name a mesh file", path.string()));
    return read_all(fd.get(), static_cast<std::size_t>(status.st_size) + 1, path); // one more to see the end
}

void require_writable(const std::filesystem::path& path, const WriteOptions& options) {
    refuse_existing(path, options);
    std::error_code ignored;
    const std::filesystem::path folder = path.parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder, ignored))
        throw OutputError(
            fmt::format("{}: there is no folder {}; create it first", path.string(), folder.string()));
}

void write_file(const std::filesystem::path& path, std::string_view bytes, const WriteOptions& options) {
    refuse_existing(path, options);
    TemporaryFile file(path);
    file.write(bytes, options.private_to_owner ? 0600 : default_mode());
    file.commit(options.overwrite);
    sync_folder(path);
}

void write_files(const std::filesystem::path& path, const PatchedFiles& files, const WriteOptions& options) {
    refuse_existing(path, options);
    for (const SideFile& side : files.side_files)
        refuse_existing(path.parent_path() / side.name, options);
    for (const SideFile& side : files.side_files)
        write_file(path.parent_path() / side.name, side.bytes, options);
    write_file(path, files.bytes, options);
}

} // namespace wm3d::io
