// SPDX-License-Identifier: GPL-3.0-or-later
#include "source.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>

namespace wm3d::io {

namespace {

/// Number of the line that holds `offset`, from 1; lines end with LF, CR LF or CR.
std::size_t line_of(std::string_view bytes, std::size_t offset) {
    std::size_t line = 1;
    const std::size_t end = std::min(offset, bytes.size());
    for (std::size_t i = 0; i < end; ++i)
        if (bytes[i] == '\n' || (bytes[i] == '\r' && (i + 1 == bytes.size() || bytes[i + 1] != '\n')))
            ++line;
    return line;
}

/// A message that quotes parts of a damaged file stays one short line.
std::string plain(std::string_view message) {
    constexpr std::size_t longest = 300;
    return printable(message.substr(0, longest)) + (message.size() > longest ? "..." : "");
}

} // namespace

std::string printable(std::string_view text) {
    std::string line(text);
    for (char& c : line)
        if (c < ' ' || c > '~')
            c = '?';
    return line;
}

void Source::fail(std::string_view what) const {
    throw InputError(fmt::format("{}: {}", name, plain(what)));
}

void Source::fail_in_line(std::size_t offset, std::string_view what) const {
    throw InputError(fmt::format("{}, line {}: {}", name, line_of(bytes, offset), plain(what)));
}

void Source::fail_at_byte(std::size_t offset, std::string_view what) const {
    throw InputError(fmt::format("{}, byte {}: {}", name, offset, plain(what)));
}

} // namespace wm3d::io
