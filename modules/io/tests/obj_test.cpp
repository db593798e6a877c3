// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include <doctest/doctest.h>

#include <wm3d/core/parallel.hpp>
#include <wm3d/shapes.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::io;
using namespace wm3d::io::test;

namespace {

const std::string cube_corner = "# a comment with v 1 2 3 in it\r\n"
                                "mtllib none.mtl\r\n"
                                "v 0.000 0.000 0.000 0.1 0.2 0.3\r\n"
                                "\tv  1.000\t0.000 0.000   # trailing\r\n"
                                "v 0.000 1.000 0.000 1.0\r\n"
                                "vt 0.5 0.5\nvn 0 0 1\n"
                                "g left right\nusemtl red\ns off\n"
                                "f 1/1/1 2//1 3/1\n"
                                "v 0.000 0.000 1.000\n"
                                "v 1e-1 0 1.000\n"
                                "v 0.100 0.0 1\n"
                                "f -3 -1 1\n"
                                "f 1 3 5 2\n"
                                "l 1 2\n"
                                "end of nothing";

} // namespace

TEST_CASE("OBJ: statements are read, coinciding positions welded whatever their spelling") {
    const Model model = parse_as(Format::obj, cube_corner);
    CHECK(model.vertex_of_slot().size() == 6);
    CHECK(model.mesh().positions.size() == 5);
    CHECK(model.vertex_of_slot()[4] == model.vertex_of_slot()[5]);
    CHECK(model.mesh().triangles[0] == Triangle{0, 1, 2});
    CHECK(model.mesh().triangles[1] == Triangle{3, 4, 0});
    CHECK(model.mesh().triangles.size() == 4);
}

TEST_CASE("OBJ: only coordinates change") {
    const std::string out = check_patch(cube_corner, Format::obj, 0.2);
    const std::set<std::string> coordinates{"0.000", "1.000", "1e-1", "0", "0.100", "0.0", "1"};
    const auto different = different_words(cube_corner, out);
    CHECK(different.size() == 18);
    for (const auto& [before, after] : different)
        CHECK(coordinates.count(before) == 1);
}

TEST_CASE("OBJ: vertices that don't move keep their bytes, and so do coordinates") {
    const std::string bytes = "v 0.10 0 0\nv 1 0.00 0\nv 0 1.5 0\nf 1 2 3\n";
    const Model model = parse_as(Format::obj, bytes);
    std::vector<Vec3> wanted = model.mesh().positions;
    wanted[1][1] = 0.126;
    CHECK(model.patched(wanted) == "v 0.10 0 0\nv 1 0.13 0\nv 0 1.5 0\nf 1 2 3\n");
    CHECK(model.stored_positions(wanted)[1] == Vec3(1, 0.13, 0));
    CHECK(model.coordinate_step() == doctest::Approx(0.01));
}

TEST_CASE("OBJ: a backslash continues a line; lone CR ends one") {
    const std::string bytes = "v 0 0 0\\\n\nv 1 \\\r\n0 0\nv 0 1 0\nf 1 \\\n 2 3\n";
    const Model model = parse_as(Format::obj, bytes);
    CHECK(model.mesh().triangles.size() == 1);
    CHECK(model.patched(model.mesh().positions) == bytes);
    check_patch(bytes, Format::obj, 3);
    CHECK(parse_as(Format::obj, "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r").mesh().triangles.size() == 1);
}

TEST_CASE("OBJ: a file of many pieces reads as one") {
    const TriangleMesh mesh = shapes::blob(20000, 1);
    const std::string bytes = encode(mesh, Format::obj);
    REQUIRE(bytes.size() > 1'000'000);
    const Model model = parse_as(Format::obj, bytes);
    CHECK(model.mesh().positions == mesh.positions);
    CHECK(model.mesh().triangles == mesh.triangles);
    const ThreadLimit one(1);
    CHECK(parse_as(Format::obj, bytes).mesh().triangles == mesh.triangles);
}

TEST_CASE("OBJ: faces of plain numbers are read as those among other statements") {
    const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    const std::vector<Triangle> two{{0, 1, 2}, {1, 3, 2}};
    for (const std::string faces :
         {"f 1 2 3\nf 2 4 3\n", "f 1/1/1 2//7 3/\n\nf\t2/4 4/4\t3/4 ", "f 1// 2 3 \r\nf 2 4 3\r",
          "# f 1 2 4\nvt 0 1\n f 01 2 3\nvn 0 0 1\nf 2 4 3"})
        for (const std::string other : {"", "g group\n", "f -4 -3 -2\n"}) {
            CAPTURE(faces);
            CAPTURE(other);
            std::vector<Triangle> expected = two;
            if (other.starts_with('f'))
                expected.insert(expected.begin(), {0, 1, 2});
            CHECK(parse_as(Format::obj, v + other + faces).mesh().triangles == expected);
        }
    CHECK(parse_as(Format::obj, v + "f 1 2 3 4\n").mesh().triangles.size() == 2);
    for (const std::string odd :
         {"f 1 2 3#\n", "f 1/1/1/1 2 3\n", "f 1 2 4294967297\n", "f 1 2\n", "f 1 2 0\n", "f \n"}) {
        CAPTURE(odd);
        const auto outcome = [&](const std::string& before) -> std::string {
            try {
                const Model model = parse_as(Format::obj, v + before + "f 2 4 3\n" + odd);
                return std::to_string(model.mesh().triangles.size());
            } catch (const InputError& error) {
                return error.what();
            }
        };
        CHECK(outcome("#\n") == outcome("g\n"));
    }
}

TEST_CASE("OBJ: errors name the line") {
    const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    CHECK(mentions(input_error(Format::obj, v + "f 1 2 4\n"), "line 4"));
    CHECK(mentions(input_error(Format::obj, v + "f 1 2 4\n"), "vertex 4"));
    CHECK(mentions(input_error(Format::obj, v + "\nf 0 1 2\n"), "line 5"));
    CHECK(mentions(input_error(Format::obj, v + "f 1 2 -4"), "line 4"));
    CHECK(mentions(input_error(Format::obj, v + "f 1 2\n"), "2 corners"));
    CHECK(mentions(input_error(Format::obj, v + "f 1 2 x\n"), "line 4"));
    CHECK(mentions(input_error(Format::obj, v + "v 1 2\nf 1 2 3\n"), "line 4"));
    CHECK(mentions(input_error(Format::obj, v + "v 1 2 x\nf 1 2 3\n"), "\"x\""));
    CHECK(mentions(input_error(Format::obj, v + "v 1 nan 2\nf 1 2 3\n"), "not finite"));
    CHECK(mentions(input_error(Format::obj, v + "v 1 1e999 2\nf 1 2 3\n"), "line 4"));
    CHECK(mentions(input_error(Format::obj, v), "no faces"));
    CHECK(mentions(input_error(Format::obj, v + std::string("\0", 1)), "byte 24"));
    CHECK(mentions(input_error(Format::obj, "nonsense"), "no faces"));
}
