// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A file descriptor that closes itself.
#pragma once

#include <utility>

#include <unistd.h>

namespace wm3d::io {

class Descriptor {
public:
    explicit Descriptor(int fd = -1) : fd_(fd) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(fd_, other.fd_);
        return *this;
    }

    int get() const { return fd_; }
    /// Closes now. \return  false if the system then says that a write was lost
    bool close() {
        const int fd = std::exchange(fd_, -1);
        return fd < 0 || ::close(fd) == 0;
    }

private:
    int fd_;
};

} // namespace wm3d::io
