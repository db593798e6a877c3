// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/streams.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <wm3d/core/descriptor.hpp>
#include <wm3d/core/error.hpp>

namespace wm3d::cmd {

void prepare_standard_streams() {
    std::signal(SIGPIPE, SIG_IGN);
    // open() takes the lowest free number. The wrong direction on purpose: using the stream stays an error.
    for (int descriptor = 0; descriptor <= 2; ++descriptor)
        if (::fcntl(descriptor, F_GETFD) == -1) [[maybe_unused]]
            const int filled = ::open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY);
}

void write_all(int descriptor, std::string_view bytes) {
    if (wm3d::write_all(descriptor, bytes))
        return;
    if (errno == EPIPE)
        throw ClosedPipe();
    throw OutputError(fmt::format("standard output can't be written: {}", std::strerror(errno)));
}

void write_message(std::string_view text) {
    [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, text.data(), text.size());
}

std::string read_standard_input() {
    std::string bytes;
    std::array<char, 1 << 16> block;
    for (;;) {
        const ssize_t count = ::read(0, block.data(), block.size());
        if (count == 0)
            return bytes;
        if (count > 0)
            bytes.append(block.data(), static_cast<std::size_t>(count));
        else if (errno != EINTR)
            throw InputError(fmt::format("standard input can't be read: {}", std::strerror(errno)));
    }
}

} // namespace wm3d::cmd
