// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/soft_binding.hpp>

#include <doctest/doctest.h>

using namespace wm3d::payload;

TEST_CASE("the value of a soft binding is the message's bytes in Base64") {
    CHECK(soft_binding_value(parse_message("foobar")) == "Zm9vYmFy"); // RFC 4648, section 10
    CHECK(soft_binding_value(parse_message("foob")) == "Zm9vYg==");
    CHECK(soft_binding_value(parse_message("0x666f6f626172")) == "Zm9vYmFy");
    CHECK(soft_binding_value(parse_message("0xfff")) == "D/8=");
}
