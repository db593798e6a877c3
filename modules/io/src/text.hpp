// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Numbers in text: exact reading, the file's own way of writing, and patching coordinates in place.
#pragma once

#include <array>
#include <cstddef>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "document.hpp"

namespace wm3d::io {

inline bool is_blank(char c) {
    return c == ' ' || c == '\t';
}
inline bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}
inline bool is_digit(char c) {
    return static_cast<unsigned char>(c - '0') < 10;
}

/// Reads one decimal number at `begin`, rounded correctly; a leading + is allowed, nan and inf are read as
/// such.
/// \return the end of the number, or nullptr if there is none or it is out of double's range
const char* parse_number(const char* begin, const char* end, double& value);

/// Walks over words separated by blanks and line ends.
class TextScanner {
public:
    TextScanner(const Source& source, std::size_t offset) : source_(source), at_(offset) {}

    std::size_t offset() const { return at_; }
    void jump(std::size_t offset) { at_ = offset; }
    bool at_end() const { return at_ >= source_.bytes.size(); }
    const Source& source() const { return source_; }

    void skip_blanks();       ///< spaces and tabs
    void skip_space();        ///< also line ends
    void skip_line();         ///< to the start of the next line
    bool at_line_end() const; ///< at CR, LF or the end of the file
    std::string_view word();  ///< up to the next space or line end; skips space first; empty at the end
    /// Reads a finite number, skipping space first; sets `start` to where it begins.
    /// \throw InputError  naming `what` if there is none
    double number(std::string_view what, std::size_t& start);
    /// As `number`, but nan and inf are numbers too.
    double any_number(std::string_view what, std::size_t& start);
    /// Three of `any_number`.
    Vec3 any_vector(std::string_view what, std::array<std::size_t, 3>& starts);
    /// Reads a whole number >= `least`, skipping space first.
    std::int64_t integer(std::string_view what, std::int64_t least);

private:
    const Source& source_;
    std::size_t at_;
};

/// How a file spells its coordinates: plain decimals, exponents everywhere, or some of both. Learned from all
/// of its coordinates, so that equal values are always spelt alike.
class TextStyle {
public:
    void learn(std::string_view number);
    /// Learns all that `other` has learned.
    void learn(const TextStyle& other);

    /// `value` in the file's style: as many decimals as its longest coordinate has, or, if exponents occur,
    /// as many significant digits. Writes to `out` (at least 400 bytes).
    /// \return the text
    std::string_view format(double value, char* out) const;
    /// The value that format(value) reads back as.
    double round(double value) const;
    /// Distance of neighbouring values near `magnitude`.
    double step(double magnitude) const;

private:
    bool exponents() const { return with_exponent_ > 0; }
    std::size_t count_ = 0, with_exponent_ = 0;
    int decimals_ = 0;    ///< most digits after the point
    int significant_ = 1; ///< most digits after leading zeros
};

/// Where x, y and z of a slot begin.
using TextOffsets = std::array<std::size_t, 3>;

/// Coordinates as words of a text file.
class TextStore final : public CoordinateStore {
public:
    explicit TextStore(std::string_view bytes) : bytes_(bytes) {}

    void reserve(std::size_t slots) { offsets_.reserve(slots); }
    /// Adds the next slot. All of them come before anything is asked.
    void add(const TextOffsets& offsets) { offsets_.push_back(offsets); }
    void add(std::span<const TextOffsets> slots) {
        offsets_.insert(offsets_.end(), slots.begin(), slots.end());
    }
    std::size_t size() const { return offsets_.size(); }

    double step(const Welding& welding) const override;
    std::vector<Vec3> settle(const Welding& welding, std::span<const Vec3> wanted) const override;
    PatchedFiles patch(const Welding& welding, std::span<const Vec3> wanted,
                       std::string_view output_name) const override;

private:
    std::size_t end_of(std::size_t offset) const;
    /// Learned when it is first asked for: who only reads a file goes through its numbers once.
    const TextStyle& style() const;
    TextStyle learned() const;
    std::string patched(const Welding& welding, std::span<const Vec3> wanted, std::size_t begin,
                        std::size_t end) const;
    std::string_view bytes_;
    std::vector<TextOffsets> offsets_;
    mutable std::once_flag asked_; ///< for the style
    mutable TextStyle style_;
};

} // namespace wm3d::io
