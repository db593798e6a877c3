// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A short message that a mark carries, and the bits that stand for it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wm3d::payload {

/// Room for 32, 64 or 128 bits. A message takes the smallest that holds it: each bit more costs strength.
enum class Format { bits32, bits64, bits128 };

inline constexpr std::array<Format, 3> formats{Format::bits32, Format::bits64, Format::bits128};

/// Bits of payload in a format: 32, 64 or 128.
constexpr std::size_t capacity(Format format) {
    return std::size_t{32} << static_cast<unsigned>(format);
}

/// What is carried: a text or hexadecimal digits.
struct Message {
    enum class Kind { text, hex };
    Kind kind = Kind::text;
    std::string value; ///< UTF-8 without control characters, or lower-case digits without 0x

    bool operator==(const Message&) const = default;
};

/// Reads what a user wrote: `0x` and digits of either case, or a text.
/// \throw ParameterError  if it is empty, longer than 16 bytes or 32 digits, no UTF-8 or holds control
/// characters
Message parse_message(std::string_view argument);

/// The message as a user would write it: a text as it is, digits with 0x.
std::string to_argument(const Message& message);

/// The smallest format that holds the message.
Format format_of(const Message& message);

/// A frame's bits, most significant first: kind and length, the payload padded with zeros, a CRC of 16 bits
/// (CCITT) over both.
using Bits = std::vector<std::uint8_t>;

/// Bits of a frame: capacity, length and checksum.
std::size_t frame_size(Format format);

/// \pre  the message fits the format
Bits to_frame(const Message& message, Format format);

/// The message, if checksum, length, padding and characters are those of a frame.
std::optional<Message> from_frame(std::span<const std::uint8_t> bits, Format format);

/// log10 of the number of messages of a format, each of them a hypothesis where a payload is looked for.
double log10_messages(Format format);

} // namespace wm3d::payload
