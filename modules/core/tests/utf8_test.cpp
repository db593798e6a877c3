// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/utf8.hpp>

#include <doctest/doctest.h>

using namespace wm3d;

TEST_CASE("well-formed UTF-8 of every length, and what is none") {
    for (const char* text :
         {"", "a", "\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x97\xbf", "\xf4\x8f\xbf\xbf", "\n"})
        CHECK(is_utf8(text));
    for (const char* text : {"\xff", "\x80", "\xc3", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80",
                             "\xf4\x90\x80\x80", "a\xe2\x82"})
        CHECK_FALSE(is_utf8(text));
}

TEST_CASE("control characters are not printable") {
    for (const char* text : {"Ann & Co", "\xc2\xa0", "\xc3\xa9"})
        CHECK(is_printable(text));
    for (const char* text : {"a\nb", "\x1b[31m", "\x7f", "\xc2\x85", "\xff"})
        CHECK_FALSE(is_printable(text));
}
