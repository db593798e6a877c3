// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstring>
#include <limits>

#include <doctest/doctest.h>

#include <wm3d/shapes.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::io;
using namespace wm3d::io::test;

TEST_CASE("STL: binary facets are welded; normals, header and attributes are kept") {
    std::string bytes = encode(shapes::blob(200, 3), Format::stl);
    std::memcpy(bytes.data(), "solid but binary", 16);
    bytes[84 + 48] = 'a'; // attributes of the first facet
    const Model model = parse_as(Format::stl, bytes);
    CHECK(model.mesh().positions.size() == shapes::blob(200, 3).positions.size());
    CHECK(model.vertex_of_slot().size() == 3 * model.mesh().triangles.size());
    const std::string out = check_patch(bytes, Format::stl, 1e-3);
    for (std::size_t offset : different_bytes(bytes, out)) {
        REQUIRE(offset >= 84);
        const std::size_t in_facet = (offset - 84) % 50;
        CHECK(in_facet >= 12);
        CHECK(in_facet < 48);
    }
}

TEST_CASE("STL: text, with several solids and odd cases") {
    const std::string bytes =
        "solid first facet\n FACET NORMAL nan 0 1\n  outer loop\n   vertex 0 0 0\n"
        "   vertex 1.0e+00 0 0\n   vertex 0 1.0e+00 0\n  endloop\n endfacet\nendsolid first\n"
        "solid\nfacet normal 0 0 1 outer loop vertex 1 0 0 vertex 1 1 0 vertex 0 1.00 0 endloop "
        "endfacet\nendsolid";
    const Model model = parse_as(Format::stl, bytes);
    CHECK(model.mesh().positions.size() == 4);
    CHECK(model.mesh().triangles == std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}});
    const std::string out = check_patch(bytes, Format::stl, 0.3);
    CHECK(different_words(bytes, out).size() == 18);
}

TEST_CASE("STL: errors say what is wrong") {
    const std::string binary = encode(shapes::square(1, 1), Format::stl);
    CHECK(mentions(input_error(Format::stl, binary.substr(0, binary.size() - 1)), "counts 2 facets"));
    CHECK(mentions(input_error(Format::stl, binary + "x"), "185"));
    CHECK(mentions(input_error(Format::stl, binary.substr(0, 40)), "40 bytes"));
    std::string none = binary.substr(0, 84);
    none[80] = 0;
    CHECK(mentions(input_error(Format::stl, none), "no faces"));
    std::string infinite = binary;
    const float inf = std::numeric_limits<float>::infinity();
    std::memcpy(infinite.data() + 84 + 12, &inf, 4);
    CHECK(mentions(input_error(Format::stl, infinite), "byte 96"));

    const std::string text = encode(shapes::square(1, 1), Format::stl, {.ascii = true});
    CHECK(mentions(input_error(Format::stl, text.substr(0, text.find("endsolid"))), "endsolid"));
    CHECK(mentions(input_error(Format::stl, text.substr(0, text.find("endloop"))), "endloop"));
    std::string wrong = text;
    wrong.replace(text.find("vertex"), 6, "vertes");
    CHECK(mentions(input_error(Format::stl, wrong), "line 4"));
}
