// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/message.hpp>

#include <cmath>
#include <set>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>

using namespace wm3d;
using namespace wm3d::payload;

namespace {

Bits bits_of(std::string_view text) {
    Bits bits;
    for (const char c : text)
        for (int k = 7; k >= 0; --k)
            bits.push_back(static_cast<unsigned char>(c) >> k & 1);
    return bits;
}

} // namespace

TEST_CASE("texts and digits are told apart and keep what was written") {
    CHECK(parse_message("Ann & Co") == Message{Message::Kind::text, "Ann & Co"});
    CHECK(parse_message("0xC0ffEE") == Message{Message::Kind::hex, "c0ffee"});
    CHECK(parse_message("0X00") == Message{Message::Kind::hex, "00"});
    CHECK(to_argument(parse_message("0xC0FFEE")) == "0xc0ffee");
    CHECK(to_argument(parse_message("\xc3\xa9t\xc3\xa9")) == "\xc3\xa9t\xc3\xa9");
}

TEST_CASE("the smallest format that holds a message is taken") {
    CHECK(format_of(parse_message("0x12345678")) == Format::bits32);
    CHECK(format_of(parse_message("0x123456789")) == Format::bits64);
    CHECK(format_of(parse_message("12345678")) == Format::bits64);
    CHECK(format_of(parse_message("123456789")) == Format::bits128);
    CHECK(format_of(parse_message("0x0123456789abcdef0")) == Format::bits128);
}

TEST_CASE("what no mark carries is refused") {
    for (const char* bad : {"", "0x", "0xfg", "seventeen letters", "0x0123456789abcdef0123456789abcdef0",
                            "a\nb", "\x7f", "\xff", "\xc3", "\xc0\xaf", "\xed\xa0\x80"})
        CHECK_THROWS_AS(parse_message(bad), ParameterError);
}

TEST_CASE("every message comes back from its frame, in every format that holds it") {
    for (const char* text : {"a", "ab", "abcd", "abcdefgh", "0x0", "0xf", "0x00000000", "0x123456789abcdef0",
                             "sixteen letters!", "0xffffffffffffffffffffffffffffffff"}) {
        const Message message = parse_message(text);
        for (const Format format : formats) {
            if (capacity(format) < capacity(format_of(message)))
                continue;
            const Bits frame = to_frame(message, format);
            CHECK(frame.size() == frame_size(format));
            CHECK((from_frame(frame, format) == message));
        }
    }
    CHECK(frame_size(Format::bits64) == 64 + 5 + 16);
}

TEST_CASE("a frame with up to three wrong bits, or a burst of sixteen, is no frame") {
    const Bits frame = to_frame(parse_message("0x0123456789abcdef"), Format::bits64);
    const auto broken = [&](std::initializer_list<std::size_t> places) {
        Bits bits = frame;
        for (const std::size_t place : places)
            bits[place] ^= 1;
        return from_frame(bits, Format::bits64);
    };
    for (std::size_t a = 0; a < frame.size(); ++a)
        for (std::size_t b = a; b < frame.size(); ++b)
            CHECK_FALSE((a == b ? broken({a}) : broken({a, b})).has_value());
    for (std::size_t a = 0; a + 15 < frame.size(); ++a)
        CHECK_FALSE(broken({a, a + 3, a + 7, a + 15}).has_value());
    CHECK_FALSE(from_frame(std::span(frame).first(frame.size() - 1), Format::bits64).has_value());
}

TEST_CASE("the checksum is CRC-16/CCITT-FALSE") {
    // Its check value is that of the digits 1 to 9; a frame's last bits are the checksum of all before them.
    const Bits frame = to_frame(parse_message("12345678"), Format::bits64);
    unsigned crc = 0xffff;
    const auto shift_in = [&](std::uint8_t bit) {
        const bool feedback = (crc >> 15 & 1) != bit;
        crc = (crc << 1 & 0xffff) ^ (feedback ? 0x1021u : 0u);
    };
    for (const std::uint8_t bit : bits_of("123456789"))
        shift_in(bit);
    REQUIRE(crc == 0x29b1);
    crc = 0xffff;
    for (std::size_t k = 0; k < frame.size() - 16; ++k)
        shift_in(frame[k]);
    for (std::size_t k = 0; k < 16; ++k)
        CHECK(frame[frame.size() - 16 + k] == (crc >> (15 - k) & 1));
}

TEST_CASE("the number of messages covers all texts and digits") {
    CHECK(log10_messages(Format::bits32) ==
          doctest::Approx(std::log10((std::exp2(40) - 256) / 255 + (std::exp2(36) - 16) / 15)));
    CHECK(log10_messages(Format::bits64) > 64 * std::log10(2.0));
    CHECK(log10_messages(Format::bits128) < 130 * std::log10(2.0));
}
