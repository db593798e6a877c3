// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/passphrase.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <termios.h>
#include <unistd.h>

#include <wm3d/core/error.hpp>

namespace wm3d::cmd {

namespace {

constexpr char interrupt = 3; // control-C

/// The terminal of this process, without echo as long as the object lives.
class SilentTerminal {
public:
    SilentTerminal() : file_(::open("/dev/tty", O_RDWR | O_CLOEXEC | O_NOCTTY)) {
        if (file_ < 0 || ::tcgetattr(file_, &before_) != 0)
            throw InputError(
                "there is no terminal to ask for the passphrase on; give it with --passphrase-fd");
        struct termios silent = before_;
        // Control-C ends the line instead of the process, so that the echo comes back in any case.
        silent.c_lflag &= static_cast<tcflag_t>(~(ECHO | ISIG));
        silent.c_cc[VEOL] = interrupt;
        ::tcsetattr(file_, TCSAFLUSH, &silent);
    }
    ~SilentTerminal() {
        ::tcsetattr(file_, TCSAFLUSH, &before_);
        ::close(file_);
    }
    SilentTerminal(const SilentTerminal&) = delete;
    SilentTerminal& operator=(const SilentTerminal&) = delete;
    int descriptor() const { return file_; }

private:
    int file_;
    struct termios before_ {};
};

void write_text(int descriptor, std::string_view text) {
    [[maybe_unused]] const ssize_t ignored = ::write(descriptor, text.data(), text.size());
}

/// Reads up to a line end, the end of the file, or control-C, which is kept. Never moves what it has read.
std::string read_line(int descriptor) {
    std::string line;
    line.reserve(key::Passphrase::size_limit + 2);
    char c = 0;
    while (line.size() <= key::Passphrase::size_limit) {
        const ssize_t got = ::read(descriptor, &c, 1);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            throw InputError(fmt::format("the passphrase can't be read from descriptor {}: {}", descriptor,
                                         std::strerror(errno)));
        if (got == 0 || c == '\n')
            break;
        line += c;
        if (c == interrupt)
            break;
    }
    if (line.ends_with('\r'))
        line.pop_back();
    return line;
}

} // namespace

key::Passphrase passphrase_from(int descriptor) {
    std::string line = read_line(descriptor);
    if (line.empty())
        throw InputError(fmt::format("descriptor {} has no passphrase: its first line is empty", descriptor));
    return key::Passphrase(std::move(line));
}

bool can_ask() {
    const int terminal = ::open("/dev/tty", O_RDWR | O_CLOEXEC | O_NOCTTY);
    if (terminal < 0)
        return false;
    ::close(terminal);
    return true;
}

key::Passphrase ask_passphrase(std::string_view prompt) {
    std::string line;
    {
        const SilentTerminal terminal;
        write_text(terminal.descriptor(), prompt);
        line = read_line(terminal.descriptor());
        write_text(terminal.descriptor(), "\n");
    }
    if (line.ends_with(interrupt)) {
        std::raise(SIGINT);
        line.clear();
    }
    if (line.empty())
        throw InputError("no passphrase was typed");
    return key::Passphrase(std::move(line));
}

void protect_memory() {
    const struct rlimit none { 0, 0 };
    ::setrlimit(RLIMIT_CORE, &none);
#ifdef PR_SET_DUMPABLE
    ::prctl(PR_SET_DUMPABLE, 0); // also where the system pipes its core dumps to a program
#endif
}

} // namespace wm3d::cmd
