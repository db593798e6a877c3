// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A file's bytes with the name to call it by, and the errors that say where in it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace wm3d::io {

/// Text that a file says of itself, fit for a message: one line of plain characters.
std::string printable(std::string_view text);

struct Source {
    std::string name;
    std::string_view bytes;

    /// Throws InputError "NAME: what".
    [[noreturn]] void fail(std::string_view what) const;
    /// Throws InputError "NAME, line L: what", the line being that of the byte at `offset`.
    [[noreturn]] void fail_in_line(std::size_t offset, std::string_view what) const;
    /// Throws InputError "NAME, byte B: what".
    [[noreturn]] void fail_at_byte(std::size_t offset, std::string_view what) const;
};

} // namespace wm3d::io
