// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/key/key_file.hpp>

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <wm3d/core/descriptor.hpp>
#include <wm3d/core/error.hpp>

#include "sodium.hpp"

namespace wm3d::key {

namespace {

constexpr std::size_t size_limit = 65536; // far above any key file, far below a mesh named by mistake

/// A text that is wiped at the end of its scope.
struct WipedText {
    std::string text;
    ~WipedText() { wipe(text); }
};

[[noreturn]] void fail_to_read(const std::filesystem::path& path) {
    throw InputError(fmt::format("{}: the key file can't be read: {}", path.string(), std::strerror(errno)),
                     ErrorCode::unreadable_input);
}

} // namespace

Key Key::load(const std::filesystem::path& path, const AskPassphrase& ask) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    struct stat status {};
    if (!file.valid() || ::fstat(file.get(), &status) != 0)
        fail_to_read(path);
    if (S_ISDIR(status.st_mode))
        throw InputError(fmt::format("{}: this is a folder; name a key file", path.string()),
                         ErrorCode::unreadable_input);
    WipedText buffer{
        std::string(size_limit, '\0')}; // full-sized from the start, so that no copy is left behind
    std::size_t length = 0;
    while (length < size_limit) {
        const ssize_t got = ::read(file.get(), buffer.text.data() + length, size_limit - length);
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
    if (!write_all(file.get(), content.text) || ::fsync(file.get()) != 0 || !file.close()) {
        const int reason = errno;
        ::unlink(path.c_str());
        throw OutputError(
            fmt::format("{}: the key file can't be written: {}", path.string(), std::strerror(reason)));
    }
    sync_folder_of(path);
}

} // namespace wm3d::key
