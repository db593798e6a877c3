// SPDX-License-Identifier: GPL-3.0-or-later
#include "temporary_file.hpp"

#include <cerrno>
#include <random>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>

namespace wm3d::io {

namespace {

[[noreturn]] void fail_writing(const std::filesystem::path& path, int error) {
    throw OutputError(fmt::format("{}: the file can't be written: {}", path.string(),
                                  std::generic_category().message(error)));
}

[[noreturn]] void fail_existing(const std::filesystem::path& path) {
    throw OutputError(fmt::format("{}: the file exists; --overwrite replaces it", path.string()),
                      ErrorCode::output_exists);
}

/// A name beside the target that nobody has yet, short whatever the target is called.
std::string fresh_name(const std::filesystem::path& target) {
    std::random_device random;
    return (folder_of(target) / fmt::format(".wm3d-{:08x}{:08x}.tmp", random(), random())).string();
}

/// The place where the system lets an open file be linked from.
std::string handle_of(int fd) {
    return fmt::format("/proc/self/fd/{}", fd);
}

/// A file without a name in the folder, if the file system has such and they can be named later.
Descriptor open_unnamed(const std::filesystem::path& folder, mode_t mode) {
#ifdef O_TMPFILE
    Descriptor file(::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, mode));
    struct stat status {};
    if (file.get() >= 0 && ::stat(handle_of(file.get()).c_str(), &status) == 0)
        return file;
#endif
    return Descriptor();
}

} // namespace

TemporaryFile::TemporaryFile(std::filesystem::path target, std::string_view bytes,
                             const TemporaryOptions& options)
    : target_(std::move(target)) {
    const mode_t mode = options.mode.value_or(0666);
    if (options.unnamed)
        file_ = open_unnamed(folder_of(target_), mode);
    if (file_.get() < 0)
        open_named(mode);
    try {
        write(bytes, options.mode);
    } catch (...) {
        if (!name_.empty())
            ::unlink(name_.c_str()); // no destructor will
        throw;
    }
}

TemporaryFile::~TemporaryFile() {
    for (const std::string& name : {name_, former_})
        if (!name.empty())
            ::unlink(name.c_str());
}

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept
    : target_(std::move(other.target_)), file_(std::move(other.file_)), name_(std::exchange(other.name_, {})),
      former_(std::exchange(other.former_, {})), can_go_back_(std::exchange(other.can_go_back_, false)) {}

void TemporaryFile::write(std::string_view bytes, std::optional<unsigned> mode) {
    if (!write_all(file_.get(), bytes) || (mode && ::fchmod(file_.get(), *mode) != 0) ||
        ::fsync(file_.get()) != 0 || (!name_.empty() && !file_.close()))
        fail_writing(target_, errno);
}

void TemporaryFile::open_named(unsigned mode) {
    do {
        name_ = fresh_name(target_);
        file_ = Descriptor(::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode));
    } while (file_.get() < 0 && errno == EEXIST);
    if (file_.get() < 0)
        fail_writing(target_, errno);
}

/// Makes the file known by a name that nobody has yet.
/// \throw OutputError
void TemporaryFile::give_name(const std::string& name) {
    const bool done = name_.empty() ? ::linkat(AT_FDCWD, handle_of(file_.get()).c_str(), AT_FDCWD,
                                               name.c_str(), AT_SYMLINK_FOLLOW) == 0
                                    : ::link(name_.c_str(), name.c_str()) == 0;
    if (done)
        return;
    if (errno == EEXIST)
        fail_existing(target_);
    // A file system without hard links: nothing keeps another from taking the name between these two steps.
    struct stat status {};
    if (name_.empty())
        fail_writing(target_, errno);
    if (::lstat(name.c_str(), &status) == 0)
        fail_existing(target_);
    if (::rename(name_.c_str(), name.c_str()) != 0)
        fail_writing(target_, errno);
    name_.clear();
}

/// Gives the file in the target's place a second name, if there is one and it can have one.
void TemporaryFile::keep_former() {
    former_ = fresh_name(target_);
    can_go_back_ = true;
    if (::link(target_.c_str(), former_.c_str()) != 0) {
        can_go_back_ = errno == ENOENT;
        former_.clear();
    }
}

void TemporaryFile::replace_target() {
    if (name_.empty()) {
        std::string name = fresh_name(target_);
        give_name(name);
        name_ = std::move(name);
    }
    if (::rename(name_.c_str(), target_.c_str()) != 0)
        fail_writing(target_, errno);
    name_.clear();
}

void TemporaryFile::commit(Existing existing) {
    if (existing == Existing::keep)
        keep_former();
    if (existing != Existing::refuse)
        return replace_target();
    give_name(target_.string());
    can_go_back_ = true;
}

void TemporaryFile::roll_back() noexcept {
    if (!std::exchange(can_go_back_, false))
        return; // what is whole in the new place is better than nothing
    if (former_.empty())
        ::unlink(target_.c_str());
    else if (::rename(former_.c_str(), target_.c_str()) == 0)
        former_.clear();
}

} // namespace wm3d::io
