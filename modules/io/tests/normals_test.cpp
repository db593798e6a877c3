// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Stored normals that turn with the surface: turning a whole model has to turn every one of them
/// alike.
#include <cmath>
#include <sstream>

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include "gltf_support.hpp"
#include "support.hpp"

using namespace wm3d;
using namespace wm3d::io;
using namespace wm3d::io::test;

namespace {

const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();

std::vector<Vec3> turned_positions(const Model& model) {
    std::vector<Vec3> positions = model.mesh().positions;
    for (Vec3& p : positions)
        p = turn * p;
    return positions;
}

/// Numbers of the lines that begin with `keyword`.
std::vector<Vec3> vectors_of_lines(const std::string& text, const std::string& keyword) {
    std::istringstream in(text);
    std::vector<Vec3> vectors;
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(keyword)) {
            std::istringstream numbers(line.substr(keyword.size()));
            Vec3 v;
            numbers >> v[0] >> v[1] >> v[2];
            vectors.push_back(v);
        }
    return vectors;
}

void check_turned(const std::vector<Vec3>& before, const std::vector<Vec3>& after, double tolerance) {
    REQUIRE(before.size() == after.size());
    REQUIRE_FALSE(before.empty());
    for (std::size_t n = 0; n < before.size(); ++n)
        CHECK((after[n] - turn * before[n]).norm() < tolerance);
}

std::string turned_file(const std::string& bytes, Format format) {
    const Model model = parse_as(format, bytes);
    CHECK(model.patched(model.mesh().positions, Normals::turn) == bytes);
    return model.patched(turned_positions(model), Normals::turn);
}

/// A tetrahedron's corners, spelt with six decimals; normals below are anything but those of its faces.
const std::string obj_model = "v 0.000000 0.000000 0.000000\nv 1.000000 0.000000 0.000000\n"
                              "v 0.000000 1.000000 0.000000\nv 0.000000 0.000000 1.000000\n"
                              "vn 0.600000 0.800000 0.000000 # by hand\nvn 0.000000 -0.600000 0.800000\n"
                              "vn 1.000000 0.000000 0.000000\nvt 0.5 0.5\n"
                              "f 1//1 3//1 2//1\nf 1/1/2 2/1/2 4/1/2\nf 1//-1 4//-1 \\\n 3//-1\nf 2 3 4\n";

} // namespace

TEST_CASE("normals of an OBJ file turn with the faces that name them") {
    const std::string out = turned_file(obj_model, Format::obj);
    check_turned(vectors_of_lines(obj_model, "vn "), vectors_of_lines(out, "vn "), 2e-6);
    CHECK(out.find("# by hand") != std::string::npos);
    CHECK(out.find("vt 0.5 0.5\nf 1//1 3//1 2//1\n") != std::string::npos);
}

TEST_CASE("a crease stays: corners of one vertex keep normals of their own") {
    // Two squares that share an edge; only the second one is folded up.
    const std::string bytes = "v 0.0000 0.0000 0.0000\nv 1.0000 0.0000 0.0000\nv 1.0000 1.0000 0.0000\n"
                              "v 0.0000 1.0000 0.0000\nv 2.0000 0.0000 0.0000\nv 2.0000 1.0000 0.0000\n"
                              "vn 0.0000 0.0000 1.0000\nvn 0.0000 0.6000 0.8000\n"
                              "f 1//1 2//1 3//1 4//1\nf 2//2 5//2 6//2 3//2\n";
    const Model model = parse_as(Format::obj, bytes);
    std::vector<Vec3> folded = model.mesh().positions;
    folded[4] = Vec3(1, 0, 1);
    folded[5] = Vec3(1, 1, 1);
    const std::vector<Vec3> normals = vectors_of_lines(model.patched(folded, Normals::turn), "vn ");
    CHECK(normals[0] == Vec3(0, 0, 1));
    CHECK((normals[1] - Vec3(-0.8, 0.6, 0)).norm() < 2e-4); // a quarter turn about y
    CHECK(vectors_of_lines(model.patched(folded), "vn ")[1] == Vec3(0, 0.6, 0.8));
}

TEST_CASE("a face that is turned over turns its normal over") {
    // A face of no area, which crosses itself, holds the edges where they are; the other one is mirrored.
    const std::string bytes = "v 0.0000 0.0000 0.0000\nv 9.0000 9.0000 0.0000\nv 9.0000 0.0000 0.0000\n"
                              "v 0.0000 9.0000 0.0000\nv 20.0000 0.0000 0.0000\nv 21.0000 0.0000 0.0000\n"
                              "v 20.0000 1.0000 0.0000\nvn 0.0000 0.0000 1.0000\n"
                              "f 1//1 2//1 3//1 4//1\nf 5//1 6//1 7//1\n";
    const Model model = parse_as(Format::obj, bytes);
    std::vector<Vec3> positions = model.mesh().positions;
    positions.back().y() = -1;
    const std::vector<Vec3> normals = vectors_of_lines(model.patched(positions, Normals::turn), "vn ");
    REQUIRE(normals.size() == 1);
    CHECK((normals.front() - Vec3(0, 0, -1)).norm() < 1e-4);
}

TEST_CASE("normals of a text PLY file turn, zeros and what is no number stay") {
    const std::string elements =
        "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty float nx\nproperty float ny\nproperty float nz\n"
        "element face 3\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string text = "ply\nformat ascii 1.0\n" + elements +
                             "0.000000 0.000000 0.000000 7 0.600000 0.800000 0.000000\n"
                             "1.000000 0.000000 0.000000 8 0.000000 0.600000 0.800000\n"
                             "0.000000 1.000000 0.000000 9 0.000000 0.000000 0.000000\n"
                             "0.000000 0.000000 1.000000 9 nan 0.000000 0.000000\n"
                             "3 0 2 1\n3 0 1 3\n3 0 3 2\n";
    const std::string out = turned_file(text, Format::ply);
    const auto normals = [](const std::string& file) {
        std::vector<Vec3> vectors;
        std::istringstream in(file.substr(file.find("end_header\n") + 11));
        for (int i = 0; i < 2; ++i) {
            double skipped;
            Vec3 n;
            in >> skipped >> skipped >> skipped >> skipped >> n[0] >> n[1] >> n[2];
            vectors.push_back(n);
        }
        return vectors;
    };
    check_turned(normals(text), normals(out), 2e-6);
    CHECK(out.find(" 9 0.000000 0.000000 0.000000\n") != std::string::npos);
    CHECK(out.find(" 9 nan 0.000000 0.000000\n") != std::string::npos);
}

TEST_CASE("normals of a binary PLY file turn") {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
        "element face 1\nproperty list uchar uchar vertex_indices\nend_header\n";
    const std::size_t body = bytes.size();
    bytes += floats({0, 0, 0, 0.6F, 0.8F, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 0});
    bytes += std::string("\3\0\1\2", 4);
    const std::string out = turned_file(bytes, Format::ply);
    const auto normals = [&](const std::string& file) {
        std::vector<Vec3> vectors;
        for (std::size_t v = 0; v < 3; ++v) {
            std::array<float, 3> n{};
            std::memcpy(n.data(), file.data() + body + 24 * v + 12, 12);
            vectors.emplace_back(n[0], n[1], n[2]);
        }
        return vectors;
    };
    check_turned(normals(bytes), normals(out), 1e-6);
}

TEST_CASE("facet normals of STL files turn") {
    const std::string text =
        "solid\nfacet normal 0.000000 0.000000 -1.000000\nouter loop\nvertex 0.000000 0.000000 0.000000\n"
        "vertex 0.000000 1.000000 0.000000\nvertex 1.000000 0.000000 0.000000\nendloop\nendfacet\n"
        "facet normal 0.000000 0.000000 0.000000\nouter loop\nvertex 0.000000 0.000000 0.000000\n"
        "vertex 1.000000 0.000000 0.000000\nvertex 0.000000 0.000000 1.000000\nendloop\nendfacet\n"
        "facet normal nan nan nan\nouter loop\nvertex 0.000000 0.000000 0.000000\n"
        "vertex 0.000000 0.000000 1.000000\nvertex 0.000000 1.000000 0.000000\nendloop\nendfacet\n"
        "endsolid\n";
    const std::vector<Vec3> normals = vectors_of_lines(turned_file(text, Format::stl), "facet normal ");
    CHECK((normals[0] - turn * Vec3(0, 0, -1)).norm() < 2e-6);
    CHECK(normals[1] == Vec3::Zero());
    CHECK(turned_file(text, Format::stl).find("facet normal nan nan nan\n") != std::string::npos);

    std::string binary(80, ' ');
    put_u32(binary, 1);
    binary += floats({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}) + std::string(2, '\0');
    const std::string out = turned_file(binary, Format::stl);
    std::array<float, 3> n{};
    std::memcpy(n.data(), out.data() + 84, 12);
    CHECK((Vec3(n[0], n[1], n[2]) - turn * Vec3(0, 0, 1)).norm() < 1e-6);
}

TEST_CASE("normals of an OFF file turn; beside colours their place is not known") {
    const std::string body = " 3 1 0\n0.000000 0.000000 0.000000 0.600000 0.800000 0.000000\n"
                             "1.000000 0.000000 0.000000 0.000000 0.600000 0.800000\n"
                             "0.000000 1.000000 0.000000 1.000000 0.000000 0.000000\n3 0 1 2\n";
    const Model model = parse_as(Format::off, "NOFF" + body);
    const std::string out = model.patched(turned_positions(model), Normals::turn);
    std::istringstream in(out.substr(out.find('\n') + 1));
    for (const Vec3& expected : {Vec3(0.6, 0.8, 0), Vec3(0, 0.6, 0.8), Vec3(1, 0, 0)}) {
        double skipped;
        Vec3 n;
        in >> skipped >> skipped >> skipped >> n[0] >> n[1] >> n[2];
        CHECK((n - turn * expected).norm() < 2e-6);
    }
    const Model coloured = parse_as(Format::off, "CNOFF" + body);
    CHECK_NOTHROW(coloured.patched(turned_positions(coloured)));
    CHECK_THROWS_WITH_AS(coloured.patched(turned_positions(coloured), Normals::turn),
                         doctest::Contains("colours"), InputError);
}

TEST_CASE("normals of glTF turn in the mesh's own coordinates, wherever the buffer is") {
    const std::string json =
        R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,)"
        R"("translation":[0,0,5],"scale":[2,2,2]}],"meshes":[{"primitives":[{"attributes":)"
        R"({"POSITION":0,"NORMAL":1},"indices":2}]}],"accessors":[)"
        R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
        R"({"bufferView":1,"componentType":5126,"count":4,"type":"VEC3"},)"
        R"({"bufferView":2,"componentType":5123,"count":6,"type":"SCALAR"}],"bufferViews":[)"
        R"({"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":48},)"
        R"({"buffer":0,"byteOffset":96,"byteLength":12}],"buffers":[)";
    const std::string buffer = floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) +
                               floats({0.6F, 0.8F, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1}) +
                               shorts({0, 1, 2, 0, 2, 3});
    const std::string whole = glb(json + R"({"byteLength":108}]})", buffer);
    const std::size_t normals_at = whole.find(buffer) + 48;
    const auto check = [&](const char* normals) {
        std::size_t n = 0;
        for (const Vec3& expected : {Vec3(0.6, 0.8, 0), Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 0, 1)}) {
            std::array<float, 3> found{};
            std::memcpy(found.data(), normals + 12 * n++, 12);
            CHECK((Vec3(found[0], found[1], found[2]) - turn * expected).norm() < 1e-6);
        }
    };
    const std::string out = turned_file(whole, Format::glb);
    REQUIRE(out.size() == whole.size());
    check(out.data() + normals_at);

    const Model external = parse(json + R"({"byteLength":108,"uri":"a.bin"}]})", Format::gltf, "model",
                                 [&](std::string_view) { return buffer; });
    const PatchedFiles files = external.patched_files(turned_positions(external), "out.gltf", Normals::turn);
    REQUIRE(files.side_files.size() == 1);
    CHECK(files.side_files[0].name == "out.bin");
    check(files.side_files[0].bytes.data() + 48);
    CHECK(files.bytes.find("\"out.bin\"") != std::string::npos);
}

TEST_CASE("files without normals are patched as ever") {
    const std::string bytes = "v 0.0 0.0 0.0\nv 1.0 0.0 0.0\nv 0.0 1.0 0.0\nf 1 2 3\n";
    const Model model = parse_as(Format::obj, bytes);
    const std::vector<Vec3> wanted = turned_positions(model);
    CHECK(model.patched(wanted, Normals::turn) == model.patched(wanted));
}
