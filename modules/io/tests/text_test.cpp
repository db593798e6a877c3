// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/text.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include <doctest/doctest.h>

using namespace wm3d::io;

namespace {

double number(std::string_view text) {
    double value = std::nan("");
    return parse_number(text.data(), text.data() + text.size(), value) == nullptr ? std::nan("") : value;
}

std::string styled(std::initializer_list<std::string> seen, double value) {
    TextStyle style;
    for (const std::string& text : seen)
        style.learn(text);
    char out[400];
    return std::string(style.format(value, out));
}

} // namespace

TEST_CASE("numbers are read exactly") {
    CHECK(number("0.1") == 0.1);
    CHECK(number("+1.5e3") == 1500);
    CHECK(number("-.5") == -0.5);
    CHECK(number("81.56099999999999") == 81.56099999999999);
    CHECK(number("1e-999") == 0);
    CHECK(number("0.00000000000000000001") == 1e-20);
    CHECK(std::isnan(number("1e999")));
    // What counts is where the digits stand and the exponent together.
    const std::string zeros(400, '0');
    CHECK(std::isnan(number("1" + zeros)));
    CHECK(std::isnan(number("-1" + zeros + "e-5")));
    CHECK(number("1" + zeros + "e-395") == 1e5);
    CHECK(number("1" + zeros + "e-999") == 0);
    CHECK(number("0." + zeros + "1") == 0);
    CHECK(number("0." + zeros + "1e+5") == 0);
    CHECK(number("0." + zeros + "1e401") == 1);
    CHECK(std::isnan(number("0." + zeros + "1e999")));
    CHECK(std::isnan(number("1e99999999999999999999")));
    CHECK(number("1e-99999999999999999999") == 0);
    CHECK(std::isnan(number("+-1")));
    CHECK(std::isnan(number("x")));
    CHECK(std::isnan(number("")));
}

TEST_CASE("numbers are written as the file writes them") {
    CHECK(styled({"0.127940", "-0.002287"}, 0.1234567) == "0.123457");
    CHECK(styled({"0.5", "1", "0.125"}, 0.3) == "0.300");
    CHECK(styled({"-8.32331e-02", "1.00000e+00"}, 0.1234567) == "1.23457e-01");
    CHECK(styled({"1e-06", "15.3644"}, 15.123456) == "15.1235");
    CHECK(styled({"1", "25"}, 7.6) == "8");
}

TEST_CASE("plain decimals are read and written as the standard library does") {
    std::mt19937_64 random(1);
    for (int i = 0; i < 20000; ++i) {
        const int decimals = i % 18;
        const double size = std::ldexp(1.0, static_cast<int>(random() % 60) - 40);
        // Every other value is a half of the last decimal, as near as double comes to it.
        const double value = i % 2 == 0
                                 ? size * (static_cast<double>(random()) / 0x1p63 - 1)
                                 : (static_cast<double>(random() % 2000) - 999.5) * std::pow(10.0, -decimals);
        std::array<char, 400> text{};
        const auto end =
            std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals)
                .ptr;
        const std::string expected(text.data(), end);
        CAPTURE(expected);
        CHECK(styled({decimals == 0 ? "1" : "0." + std::string(static_cast<std::size_t>(decimals), '1')},
                     value) == expected);
        double read = 0;
        std::from_chars(expected.data(), expected.data() + expected.size(), read);
        CHECK(std::bit_cast<std::uint64_t>(number(expected)) == std::bit_cast<std::uint64_t>(read));
    }
    for (const std::string_view text :
         {"5.", "5.e1", "0x1", "1.5e", "9007199254740993", "18446744073709551616.5", "1.2.3"}) {
        CAPTURE(text);
        double expected = 0, read = 0;
        const char* const end = std::from_chars(text.data(), text.data() + text.size(), expected).ptr;
        CHECK(parse_number(text.data(), text.data() + text.size(), read) == end);
        CHECK(read == expected);
    }
}

TEST_CASE("rounding is what writing and reading gives") {
    TextStyle style;
    style.learn("0.123");
    CHECK(style.round(1.23456) == 1.235);
    CHECK(style.step(1.0) == doctest::Approx(1e-3));
    style.learn("1.5e-7");
    CHECK(style.step(2000) == doctest::Approx(10)); // three significant digits
}

TEST_CASE("the longest possible numbers fit") {
    const double huge = std::numeric_limits<double>::max();
    CHECK(number(styled({"0.12345678901234567890"}, -huge)) == -huge);
    CHECK(number(styled({"1.2345678901234567890e5", "1"}, -huge)) == doctest::Approx(-huge));
}
