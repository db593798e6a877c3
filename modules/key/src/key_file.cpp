// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/key/key_file.hpp>

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <wm3d/core/error.hpp>

#include "sodium.hpp"

namespace wm3d::key {

namespace {

constexpr std::size_t size_limit = 65536; // far above any key file, far below a mesh named by mistake

/// A file descriptor that is closed at the end of its scope.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0)
            ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }
    bool valid() const { return number_ >= 0; }
    /// Closes now. False if the system then reports that a write was lost.
    bool close() { return ::close(std::exchange(number_, -1)) == 0; }

private:
    int number_;
};

/// A text that is wiped at the end of its scope.
struct WipedText {
    std::string text;
    ~WipedText() { wipe(text); }
};

[[noreturn]] void fail_to_read(const std::filesystem::path& path) {
    throw InputError(fmt::format("{}: the key file can't be read: {}", path.string(), std::strerror(errno)),
                     ErrorCode::unreadable_input);
}

bool write_all(const Descriptor& file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(file.number(), text.data(), text.size());
        if (written < 0 && errno != EINTR)
            return false;
        text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
    return ::fsync(file.number()) == 0;
}

/// Makes the new name itself survive a power cut; a folder that can't be synchronised is not an error.
void synchronise_folder(const std::filesystem::path& path) {
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (descriptor.valid())
        ::fsync(descriptor.number());
}

} // namespace

Key Key::load(const std::filesystem::path& path, const AskPassphrase& ask) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    struct stat status {};
    if (!file.valid() || ::fstat(file.number(), &status) != 0)
        fail_to_read(path);
    if (S_ISDIR(status.st_mode))
        throw InputError(fmt::format("{}: this is a folder; name a key file", path.string()),
                         ErrorCode::unreadable_input);
    WipedText buffer{
        std::string(size_limit, '\0')}; // full-sized from the start, so that no copy is left behind
    std::size_t length = 0;
    while (length < size_limit) {
        const ssize_t got = ::read(file.number(), buffer.text.data() + length, size_limit - length);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            fail_to_read(path);
        if (got == 0)
            break;
        length += static_cast<std::size_t>(got);
    }
    return parse(std::string_view(buffer.text).substr(0, length), path.string(), ask);
}

void Key::save(const std::filesystem::path& path, const Passphrase* passphrase) const {
    const WipedText content{to_text(passphrase)};
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
    if (!file.valid() && errno == EEXIST)
        throw OutputError(
            fmt::format("{}: the file exists and a key is never overwritten; choose another name",
                        path.string()),
            ErrorCode::output_exists);
    if (!file.valid())
        throw OutputError(
            fmt::format("{}: the key file can't be created: {}", path.string(), std::strerror(errno)));
    if (!write_all(file, content.text) || !file.close()) {
        const int reason = errno;
        ::unlink(path.c_str());
        throw OutputError(
            fmt::format("{}: the key file can't be written: {}", path.string(), std::strerror(reason)));
    }
    synchronise_folder(path);
}

} // namespace wm3d::key
