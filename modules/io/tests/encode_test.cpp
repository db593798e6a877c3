// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <doctest/doctest.h>

#include <wm3d/shapes.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::io;
using namespace wm3d::io::test;

namespace {

double largest_distance(const TriangleMesh& a, const TriangleMesh& b) {
    double largest = 0;
    for (std::size_t v = 0; v < a.positions.size(); ++v)
        largest = std::max(largest, (a.positions[v] - b.positions[v]).norm());
    return largest;
}

} // namespace

TEST_CASE("every format reads back what was encoded") {
    const TriangleMesh mesh = shapes::blob(500, 7);
    for (Format format : {Format::obj, Format::ply, Format::off, Format::gltf, Format::glb})
        for (bool ascii : {false, true}) {
            CAPTURE(name_of(format));
            const Model model =
                parse_as(format, encode(mesh, format, {.ascii = ascii, .comment = "one line"}));
            CHECK(model.mesh().triangles == mesh.triangles);
            REQUIRE(model.mesh().positions.size() == mesh.positions.size());
            const bool exact = format == Format::obj || format == Format::off;
            CHECK(largest_distance(model.mesh(), mesh) <= (exact ? 0 : 2e-7));
        }
}

TEST_CASE("PLY in double is exact") {
    const TriangleMesh mesh = shapes::blob(300, 2);
    for (bool ascii : {false, true})
        CHECK(parse_as(Format::ply, encode(mesh, Format::ply, {.ascii = ascii, .double_precision = true}))
                  .mesh()
                  .positions == mesh.positions);
}

TEST_CASE("STL holds the same triangles and their normals") {
    const TriangleMesh mesh = shapes::box({1, 2, 3}, 2);
    for (bool ascii : {false, true}) {
        const std::string bytes = encode(mesh, Format::stl, {.ascii = ascii});
        const Model model = parse_as(Format::stl, bytes);
        CHECK(model.mesh().positions.size() == mesh.positions.size());
        CHECK(model.mesh().triangles.size() == mesh.triangles.size());
        if (ascii)
            CHECK(bytes.find("facet normal -1 0 0") != std::string::npos);
    }
}

TEST_CASE("colours of vertices and faces") {
    const TriangleMesh mesh = shapes::square(1, 2);
    EncodeOptions options;
    options.vertex_colors.assign(mesh.positions.size(), Color{255, 0, 128});
    for (Format format : {Format::obj, Format::ply, Format::off, Format::gltf, Format::glb}) {
        CHECK(parse_as(format, encode(mesh, format, options)).mesh().triangles == mesh.triangles);
        options.ascii = true;
        CHECK(parse_as(format, encode(mesh, format, options)).mesh().triangles == mesh.triangles);
    }
    CHECK(encode(mesh, Format::ply, options).find("0 0 0 255 0 128\n") != std::string::npos);
    CHECK(encode(mesh, Format::off, options).starts_with("COFF"));
    CHECK_THROWS_AS(encode(mesh, Format::stl, options), ParameterError);

    options.vertex_colors.clear();
    options.face_colors.assign(mesh.triangles.size(), Color{1, 2, 3});
    for (Format format : {Format::ply, Format::off, Format::glb})
        CHECK(parse_as(format, encode(mesh, format, options)).mesh().triangles.size() ==
              mesh.triangles.size());
    CHECK(encode(mesh, Format::glb, options).find("COLOR_0") != std::string::npos);
    CHECK_THROWS_AS(encode(mesh, Format::obj, options), ParameterError);
    options.face_colors.pop_back();
    CHECK_THROWS_AS(encode(mesh, Format::ply, options), ParameterError);
}

TEST_CASE("coordinates that a file can't hold are refused") {
    TriangleMesh mesh = shapes::square(1, 1);
    mesh.positions[0][0] = 1e39;
    CHECK_THROWS_AS(encode(mesh, Format::stl), GeometryError);
    CHECK_NOTHROW(encode(mesh, Format::obj));
    mesh.positions[0][0] = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(encode(mesh, Format::obj), GeometryError);
    CHECK_THROWS_AS(encode(shapes::square(1, 1), Format::ply, {.comment = "two\nlines"}), ParameterError);
}
