// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_bytes.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <wm3d/core/descriptor.hpp>
#include <wm3d/core/error.hpp>
#include <wm3d/core/fnv.hpp>

namespace wm3d::io {

namespace {

std::uint64_t digest(std::string_view bytes) {
    Fnv fnv;
    for (; !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), sizeof(std::uint64_t)))) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data(), std::min(bytes.size(), sizeof word));
        fnv.add(word);
    }
    return fnv.value();
}

/// Gives the whole pages among some bytes back to the system; they read as zeros afterwards.
void discard(std::string& bytes) {
    const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
    const auto begin = reinterpret_cast<std::uintptr_t>(bytes.data());
    const std::uintptr_t first = (begin + page - 1) / page * page,
                         last = (begin + bytes.size()) / page * page;
    if (first < last)
        ::madvise(bytes.data() + (first - begin), last - first, MADV_DONTNEED);
}

/// Fills `bytes` from the beginning of a file; whether that was all of it.
bool fill(std::string& bytes, int fd) {
    std::size_t size = 0;
    char beyond = 0;
    for (;;) {
        const bool full = size == bytes.size();
        const ssize_t got = ::read(fd, full ? &beyond : bytes.data() + size, full ? 1 : bytes.size() - size);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0 || full)
            return got == 0 && full;
        size += static_cast<std::size_t>(got);
    }
}

} // namespace

std::string_view FileBytes::here() {
    const std::lock_guard lock(guard_);
    if (gone_)
        read_again();
    return bytes_;
}

void FileBytes::let_go(std::size_t fewest) {
    const std::lock_guard lock(guard_);
    std::error_code failure;
    if (gone_ || bytes_.size() < fewest || path_.empty() ||
        !std::filesystem::is_regular_file(path_, failure)) // a pipe gives its bytes once
        return;
    digest_ = digest(bytes_);
    discard(bytes_);
    gone_ = true;
}

void FileBytes::read_again() {
    const Descriptor fd(::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (fd.get() < 0 || !fill(bytes_, fd.get()) || digest(bytes_) != digest_)
        throw InputError(
            fmt::format("{}: the file isn't what it was when it was read; leave it alone until wm3d "
                        "is done with it, and try again",
                        path_.string()),
            ErrorCode::altered_input);
    gone_ = false;
}

std::string FileBytes::take() && {
    here();
    return std::move(bytes_);
}

} // namespace wm3d::io
