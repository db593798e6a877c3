// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/base64.hpp>

#include <utility>

#include <doctest/doctest.h>

using namespace wm3d;

TEST_CASE("the examples of RFC 4648, both ways") {
    for (const auto& [bytes, text] : {std::pair{"", ""},
                                      {"f", "Zg=="},
                                      {"fo", "Zm8="},
                                      {"foo", "Zm9v"},
                                      {"foob", "Zm9vYg=="},
                                      {"fooba", "Zm9vYmE="},
                                      {"foobar", "Zm9vYmFy"}}) {
        CHECK(to_base64(bytes) == text);
        CHECK(from_base64(text) == bytes);
    }
    CHECK_FALSE(from_base64("Zm9v!"));
    CHECK_FALSE(from_base64("Zm9vY"));
}

TEST_CASE("all bytes come back") {
    std::string bytes;
    for (int i = 0; i < 256; ++i)
        bytes += static_cast<char>(i);
    CHECK(from_base64(to_base64(bytes)) == bytes);
}
