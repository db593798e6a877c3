// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Files by the numbers that POSIX gives them. What goes wrong is in errno; callers have the words.
#pragma once

#include <filesystem>
#include <string_view>
#include <utility>

#include <unistd.h>

namespace wm3d {

/// A file descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int fd = -1) : fd_(fd) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(fd_, other.fd_);
        return *this;
    }

    bool valid() const { return fd_ >= 0; }
    int get() const { return fd_; }
    /// Closes now.
    /// \return  false if the system then says that a write was lost
    bool close() {
        const int fd = std::exchange(fd_, -1);
        return fd < 0 || ::close(fd) == 0;
    }

private:
    int fd_;
};

/// Writes all bytes, in as many parts as it takes.
/// \return  false if the system refuses some
bool write_all(int fd, std::string_view bytes);

/// The folder that a file is in.
std::filesystem::path folder_of(const std::filesystem::path& file);

/// Makes the name of a new file survive a power cut; file systems that can't are left alone.
void sync_folder_of(const std::filesystem::path& file);

} // namespace wm3d
