// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cstring>

#include <doctest/doctest.h>

#include <wm3d/shapes.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::io;
using namespace wm3d::io::test;

namespace {

/// Builds a binary body in either byte order.
struct Body {
    bool big;
    std::string bytes;
    template<typename T>
    Body& add(T value) {
        char raw[sizeof(T)];
        std::memcpy(raw, &value, sizeof(T));
        if (big != (std::endian::native == std::endian::big))
            std::reverse(raw, raw + sizeof(T));
        bytes.append(raw, sizeof(T));
        return *this;
    }
};

/// Two triangles with everything that PLY allows around them; faces come before the vertices.
std::string awkward_binary(bool big) {
    Body body{big, {}};
    for (int f = 0; f < 2; ++f) {
        body.add(std::uint8_t(77)).add(std::uint16_t(3));
        for (int k = 0; k < 3; ++k)
            body.add(std::int16_t(f == 0 ? k : 3 - k));
        body.add(std::uint8_t(2)).add(0.25f).add(0.75f);
    }
    for (int v = 0; v < 4; ++v) {
        body.add(std::uint8_t(1)).add(std::int32_t(v)); // a list before the coordinates
        body.add(v * 0.5).add(std::uint8_t(200)).add(float(v == 1)).add(std::int16_t(100 * (v == 2)));
    }
    body.add(1.25);
    return std::string("ply\nformat binary_") + (big ? "big" : "little") +
           "_endian 1.0\ncomment element vertex 9\nobj_info kept\nelement face 2\nproperty uchar flag\n"
           "property list ushort short vertex_index\nproperty list uchar float uv\nelement vertex 4\n"
           "property list uchar int tags\nproperty double z\nproperty uchar red\nproperty float x\n"
           "property short y\nelement extra 1\nproperty double value\nend_header\n" +
           body.bytes + "trailing";
}

std::string tetra_text(const std::string& end) {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float z\nproperty uchar red\n"
        "property float y\nproperty float x\nelement face 2\nproperty list uchar int vertex_indices\n"
        "property uchar material\nend_header\n"
        "0.00 255 0.00 0.00\n0.00 9 0.00 1.00\n0.0 8 1.0 0.00\n1.00 7 0.25 0\n"
        "3 0 1 2 5\n4 0 1 3 2 6\n";
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size())
        text.replace(at, 1, end);
    return text;
}

std::string header(const std::string& format, const std::string& rest) {
    return "ply\nformat " + format + " 1.0\n" + rest + "end_header\n";
}

} // namespace

TEST_CASE("PLY: binary of both byte orders, any types, any order, other data kept") {
    for (bool big : {false, true}) {
        CAPTURE(big);
        const std::string bytes = awkward_binary(big);
        const Model model = parse_as(Format::ply, bytes);
        REQUIRE(model.mesh().positions.size() == 4);
        CHECK(model.mesh().positions[1] == Vec3(1, 0, 0.5));
        CHECK(model.mesh().positions[2] == Vec3(0, 100, 1));
        CHECK(model.mesh().triangles == std::vector<Triangle>{{0, 1, 2}, {3, 2, 1}});
        CHECK(model.coordinate_step() == 1); // y is a short
        const std::string out = check_patch(bytes, Format::ply, 0.7);
        const std::size_t body = bytes.find("end_header\n") + 11, first = body + 2 * (1 + 2 + 6 + 1 + 8);
        for (std::size_t offset : different_bytes(bytes, out)) {
            REQUIRE(offset >= first);
            const std::size_t in_record = (offset - first) % 20;
            CHECK(offset < first + 80);
            CHECK(((in_record >= 5 && in_record < 13) || in_record >= 14)); // z, then x and y
        }
    }
}

TEST_CASE("PLY: text with every kind of line end") {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        const std::string bytes = tetra_text(end);
        const Model model = parse_as(Format::ply, bytes);
        CHECK(model.mesh().positions[3] == Vec3(0, 0.25, 1));
        CHECK(model.mesh().triangles.size() == 3);
        const std::string out = check_patch(bytes, Format::ply, 0.1);
        CHECK(different_words(bytes, out).size() == 12);
    }
}

TEST_CASE("PLY: triangle strips with -1 between them") {
    const std::string bytes =
        header("ascii", "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
                        "element tristrips 1\nproperty list int int vertex_indices\n") +
        "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 2 1\n9 0 1 2 3 -1 2 3 4 -1\n";
    CHECK(parse_as(Format::ply, bytes).mesh().triangles ==
          std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}});
}

TEST_CASE("PLY: errors say where") {
    const std::string xyz = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string face = "element face 1\nproperty list char int vertex_indices\n";
    const std::string v = "0 0 0\n1 0 0\n0 1 0\n";
    const auto text = [&](const std::string& body) {
        return input_error(Format::ply, header("ascii", xyz + face) + body);
    };
    CHECK(text(v + "3 0 1 2\n").empty());
    CHECK(mentions(text(v + "3 0 1 3\n"), "line 13"));
    const std::string remark = input_error(Format::ply, header("ascii", "# by hand\n" + xyz + face) + v);
    CHECK(mentions(remark, "line 3"));
    CHECK(mentions(remark, "put \"comment\" before a remark"));
    CHECK(mentions(text(v + "-3 0 1 2\n"), "below 0"));
    CHECK(mentions(text(v + "3 0 1 -1\n"), "below 0"));
    CHECK(mentions(text(v + "3 0 1"), "cut short"));
    CHECK(mentions(text(v + "2000000000 0 1 2"), "longer than the file"));
    CHECK(mentions(text("0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n"), "line 10"));
    CHECK(mentions(input_error(Format::ply, header("ascii", xyz) + v), "no faces"));
    CHECK(mentions(input_error(Format::ply, header("ascii", "element vertex 99999999999\n" + xyz.substr(17))),
                   "announces"));
    CHECK(mentions(input_error(Format::ply, header("ascii", face)), "no element named vertex"));
    CHECK(mentions(input_error(Format::ply, header("strange", xyz)), "line 2"));
    CHECK(mentions(input_error(Format::ply, "ply\nformat ascii 1.0\nelement vertex 3\n"), "end_header"));
    CHECK(
        mentions(input_error(Format::ply, header("ascii", "element vertex 1\nproperty quad x\n")), "line 4"));
    CHECK(
        mentions(input_error(Format::ply,
                             header("ascii", xyz + "element face 1\nproperty list float int vertex_index\n")),
                 "floating-point"));
    std::string binary = awkward_binary(false);
    CHECK(mentions(input_error(Format::ply, binary.substr(0, binary.size() - 30)), "cut short"));
}
