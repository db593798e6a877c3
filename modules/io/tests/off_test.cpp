// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::io;
using namespace wm3d::io::test;

namespace {

const std::string body =
    "0 0.00 0\n1 0 0\n1 1 0\n0 1 0 # comment\n\n# another\n4 0 1 2 3 0.5 0.5 0.5\n3 0 1 2\n";

} // namespace

TEST_CASE("OFF: keyword and counts in all their places") {
    for (const std::string head :
         {"OFF\n4 2 0\n", "OFF 4 2 0\n", "OFF4 2 0\n", "# first\nOFF # kw\n# c\n4 2\n", "4 2 0\n"}) {
        CAPTURE(head);
        const Model model = parse_as(Format::off, head + body);
        CHECK(model.mesh().positions.size() == 4);
        CHECK(model.mesh().triangles.size() == 3);
        const std::string out = check_patch(head + body, Format::off, 0.2);
        CHECK(different_words(head + body, out).size() == 12);
    }
}

TEST_CASE("OFF: colours and normals after the coordinates are kept") {
    const std::string bytes =
        "COFF\r\n3 1 3\r\n0 0 0 255 0 0 255\r\n1.5 0 0 0 255 0 255\r\n0 1 0 0 0 255 255\r\n3 0 1 2\r\n";
    const auto different = different_words(bytes, check_patch(bytes, Format::off, 0.6));
    CHECK(different.size() <= 9);
    for (const auto& [before, after] : different)
        CHECK(before.size() <= 3);
    CHECK(parse_as(Format::off, "NOFF\n3 1 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n")
              .mesh()
              .triangles.size() == 1);
}

TEST_CASE("OFF: errors name the line") {
    CHECK(mentions(input_error(Format::off, "OFF\n4 2 0\n" + body.substr(0, body.size() - 4)), "cut short"));
    CHECK(mentions(input_error(Format::off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "line 6"));
    CHECK(mentions(input_error(Format::off, "OFF\n3 1 0\n0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n"), "line 4"));
    CHECK(mentions(input_error(Format::off, "OFF\n3000000000000 1 0\n0 0 0\n"), "too short"));
    CHECK(mentions(input_error(Format::off, "OFF BINARY\n"), "binary OFF"));
    CHECK(mentions(input_error(Format::off, "4OFF\n1 1 1\n"), "dimension"));
    CHECK(mentions(input_error(Format::off, "OFF\n-3 1 0\n"), "below 0"));
    CHECK(mentions(input_error(Format::off, "hello"), "no keyword"));
}
