// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "gltf_support.hpp"
#include "support.hpp"

using namespace wm3d;
using namespace wm3d::io;
using namespace wm3d::io::test;

namespace {

Model square_scene(const std::string& nodes) {
    return parse_as(Format::glb, glb(square_asset(nodes, R"({"byteLength":60})"), square_buffer()));
}

Index vertex_at(const Model& model, const Vec3& p) {
    for (std::size_t v = 0; v < model.mesh().positions.size(); ++v)
        if (model.mesh().positions[v] == p)
            return static_cast<Index>(v);
    FAIL("no such vertex");
    return no_index;
}

void check_settles(const Model& model, const std::vector<Vec3>& wanted) {
    check_reads_back(model, parse_as(Format::glb, model.patched(wanted)), model.stored_positions(wanted));
}

} // namespace

TEST_CASE("node transforms place the mesh; its positions move in local coordinates") {
    const Model model = square_scene(
        R"([{"children":[1],"translation":[10,0,0]},{"mesh":0,"scale":[2,2,2],"rotation":[0,0,0.7071067811865476,0.7071067811865476]}])");
    CHECK((model.mesh().positions[1] - Vec3(10, 2, 0)).norm() < 1e-12);
    CHECK(model.coordinate_step() == doctest::Approx(2 * 1.1920929e-7));
    const std::vector<Vec3> wanted = moved(model.mesh(), 0.01);
    const std::vector<Vec3> stored = model.stored_positions(wanted);
    for (std::size_t v = 0; v < wanted.size(); ++v)
        CHECK((stored[v] - wanted[v]).norm() < 4e-7);
    check_settles(model, wanted);
}

TEST_CASE("a matrix places the mesh too") {
    const Model model = square_scene(R"([{"mesh":0,"matrix":[0,1,0,0, -1,0,0,0, 0,0,1,0, 5,6,7,1]}])");
    CHECK(model.mesh().positions[1] == Vec3(5, 7, 7));
    CHECK(model.mesh().positions[3] == Vec3(4, 6, 7));
    check_settles(model, moved(model.mesh(), 0.01));
}

TEST_CASE("several instances move by the mean of what each wants") {
    const Model model = square_scene(R"([{"children":[1,2]},{"mesh":0},{"mesh":0,"translation":[8,0,0]}])");
    REQUIRE(model.mesh().positions.size() == 8);
    std::vector<Vec3> wanted = model.mesh().positions;
    wanted[vertex_at(model, {1, 1, 0})] += Vec3(0, 0, 0.5);
    const std::vector<Vec3> stored = model.stored_positions(wanted);
    CHECK(stored[vertex_at(model, {1, 1, 0})] == Vec3(1, 1, 0.25));
    CHECK(stored[vertex_at(model, {9, 1, 0})] == Vec3(9, 1, 0.25));
    CHECK(stored[vertex_at(model, {0, 1, 0})] == Vec3(0, 1, 0));
    check_settles(model, wanted);
}

TEST_CASE("mirrored halves keep their seam closed") {
    // The second instance is mirrored at x = 0; both share the edge x = 0.
    const Model model = square_scene(R"([{"children":[1,2]},{"mesh":0},{"mesh":0,"scale":[-1,1,1]}])");
    REQUIRE(model.mesh().positions.size() == 6);
    std::vector<Vec3> wanted = model.mesh().positions;
    wanted[vertex_at(model, {0, 1, 0})] += Vec3(0.5, 0, 0.5);
    const std::vector<Vec3> stored = model.stored_positions(wanted);
    CHECK(stored[vertex_at(model, {0, 1, 0})] == Vec3(0, 1, 0.5)); // along x the halves disagree
    check_settles(model, wanted);
}

TEST_CASE("positions that would tear a seam stay, and what hangs together with them") {
    // The right edge of the first instance is the left edge of the second: local (1, y) and (0, y) hang
    // together.
    const Model model = square_scene(R"([{"children":[1,2]},{"mesh":0},{"mesh":0,"translation":[1,0,0]}])");
    REQUIRE(model.mesh().positions.size() == 6);
    std::vector<Vec3> wanted = model.mesh().positions;
    wanted[vertex_at(model, {2, 1, 0})] += Vec3(0, 0, 0.5);
    CHECK(model.stored_positions(wanted) == model.mesh().positions);
    CHECK(model.patched(wanted) == model.patched(model.mesh().positions));
    // Where all instances want the same, all move.
    wanted = model.mesh().positions;
    for (double x : {0.0, 1.0, 2.0})
        wanted[vertex_at(model, {x, 1, 0})] += Vec3(0, 0, 0.5);
    CHECK(model.stored_positions(wanted) == wanted);
    check_settles(model, wanted);
}

TEST_CASE("an instance without thickness has no say and does no harm") {
    const Model model =
        square_scene(R"([{"children":[1,2]},{"mesh":0},{"mesh":0,"scale":[1,1,0],"translation":[0,0,4]}])");
    std::vector<Vec3> wanted = model.mesh().positions;
    wanted[vertex_at(model, {1, 1, 0})] += Vec3(0, 0, 0.5);
    check_settles(model, wanted);
    CHECK(model.stored_positions(wanted)[vertex_at(model, {1, 1, 4})] == Vec3(1, 1, 4));
}
