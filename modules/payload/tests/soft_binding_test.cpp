// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/soft_binding.hpp>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>

using namespace wm3d::payload;

TEST_CASE("the value of a soft binding is the message's bytes in Base64") {
    CHECK(soft_binding_value(parse_message("foobar")) == "Zm9vYmFy"); // RFC 4648, section 10
    CHECK(soft_binding_value(parse_message("foob")) == "Zm9vYg==");
    CHECK(soft_binding_value(parse_message("0x666f6f626172")) == "Zm9vYmFy");
    CHECK(soft_binding_value(parse_message("0xfff")) == "D/8=");
}

TEST_CASE("a message of digits that are none has no soft binding") {
    for (const char* bad : {"fg", "g", " f", "-1", "0x"})
        CHECK_THROWS_WITH_AS(soft_binding_value({Message::Kind::hex, bad}),
                             doctest::Contains("is no hexadecimal"), wm3d::ParameterError);
}
