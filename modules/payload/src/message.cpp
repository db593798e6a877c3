// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/message.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include <boost/crc.hpp>
#include <fmt/format.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/utf8.hpp>

namespace wm3d::payload {

namespace {

constexpr std::size_t checksum_bits = 16;
constexpr std::string_view digits = "0123456789abcdef";

/// Bits of one character of a kind.
constexpr std::size_t width(Message::Kind kind) {
    return kind == Message::Kind::text ? 8 : 4;
}

/// Most characters of a kind that a format holds.
constexpr std::size_t most(Message::Kind kind, Format format) {
    return capacity(format) / width(kind);
}

/// Bits that tell kind and length: texts of 1, 2, ... bytes first, then 1, 2, ... digits.
constexpr std::size_t length_bits(Format format) {
    return std::bit_width(most(Message::Kind::text, format) + most(Message::Kind::hex, format) - 1);
}

void append(Bits& bits, unsigned long value, std::size_t count) {
    for (std::size_t k = count; k-- > 0;)
        bits.push_back(value >> k & 1);
}

unsigned long number(std::span<const std::uint8_t> bits) {
    return std::accumulate(bits.begin(), bits.end(), 0ul,
                           [](unsigned long value, std::uint8_t bit) { return value << 1 | bit; });
}

unsigned long checksum(std::span<const std::uint8_t> bits) {
    boost::crc_basic<checksum_bits> crc(0x1021, 0xffff);
    for (const std::uint8_t bit : bits)
        crc.process_bit(bit != 0);
    return crc.checksum();
}

Message parse_digits(std::string_view argument) {
    Message message{Message::Kind::hex, {}};
    for (const char c : argument.substr(2))
        message.value += c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c;
    const std::size_t limit = most(Message::Kind::hex, Format::bits128);
    if (message.value.empty() || message.value.size() > limit ||
        message.value.find_first_not_of(digits) != std::string::npos)
        throw ParameterError(fmt::format(
            "the payload '{}' is no number of 1 to {} hexadecimal digits after 0x", argument, limit));
    return message;
}

} // namespace

Message parse_message(std::string_view argument) {
    if (argument.starts_with("0x") || argument.starts_with("0X"))
        return parse_digits(argument);
    const std::size_t limit = most(Message::Kind::text, Format::bits128);
    if (argument.empty() || argument.size() > limit)
        throw ParameterError(
            fmt::format("the payload has {} bytes; a mark carries a text of 1 to {}, best of at most {}",
                        argument.size(), limit, most(Message::Kind::text, Format::bits64)));
    if (!is_printable(argument))
        throw ParameterError(
            "the payload is no printable UTF-8 text; give other bytes in hexadecimal, as 0x...");
    return {Message::Kind::text, std::string(argument)};
}

std::string to_argument(const Message& message) {
    return message.kind == Message::Kind::hex ? "0x" + message.value : message.value;
}

Format format_of(const Message& message) {
    for (const Format format : formats)
        if (message.value.size() <= most(message.kind, format))
            return format;
    throw ParameterError("the payload is longer than any mark carries; at most 128 bits are possible");
}

std::size_t frame_size(Format format) {
    return length_bits(format) + capacity(format) + checksum_bits;
}

Bits to_frame(const Message& message, Format format) {
    const bool is_text = message.kind == Message::Kind::text;
    const std::size_t before = is_text ? 0 : most(Message::Kind::text, format);
    Bits bits;
    append(bits, before + message.value.size() - 1, length_bits(format));
    for (const char c : message.value)
        append(bits, is_text ? static_cast<unsigned char>(c) : digits.find(c), width(message.kind));
    bits.resize(length_bits(format) + capacity(format), 0);
    append(bits, checksum(bits), checksum_bits);
    return bits;
}

std::optional<Message> from_frame(std::span<const std::uint8_t> bits, Format format) {
    const std::size_t head = length_bits(format);
    if (bits.size() != frame_size(format) ||
        checksum(bits.first(head + capacity(format))) != number(bits.last(checksum_bits)))
        return {};
    const std::size_t code = number(bits.first(head)), texts = most(Message::Kind::text, format);
    Message message{code < texts ? Message::Kind::text : Message::Kind::hex, {}};
    const std::size_t length = code < texts ? code + 1 : code - texts + 1;
    if (length > most(message.kind, format))
        return {};
    const std::span<const std::uint8_t> body = bits.subspan(head, capacity(format));
    const std::size_t step = width(message.kind);
    for (std::size_t i = 0; i < length; ++i) {
        const unsigned long value = number(body.subspan(i * step, step));
        message.value += message.kind == Message::Kind::text ? static_cast<char>(value) : digits[value];
    }
    const bool padded =
        std::ranges::all_of(body.subspan(length * step), [](std::uint8_t b) { return b == 0; });
    if (!padded || (message.kind == Message::Kind::text && !is_printable(message.value)))
        return {};
    return message;
}

double log10_messages(Format format) {
    // Texts of 1, 2, ... bytes and numbers of 1, 2, ... digits; more than are printable, which errs on the
    // safe side.
    double count = 0;
    for (const Message::Kind kind : {Message::Kind::text, Message::Kind::hex})
        for (std::size_t length = 1; length <= most(kind, format); ++length)
            count += std::ldexp(1.0, static_cast<int>(length * width(kind)));
    return std::log10(count);
}

} // namespace wm3d::payload
