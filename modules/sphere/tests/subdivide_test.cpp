// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/sphere/icosphere.hpp>

#include "vertex_vectors.hpp"

using namespace wm3d;
using namespace wm3d::sphere;

TEST_CASE("every level has its counts, is closed and of genus 0") {
    for (unsigned level = 0; level <= 6; ++level) {
        const Icosphere sphere(level);
        const std::size_t quads = std::size_t{1} << (2 * level);
        CHECK(sphere.level() == level);
        CHECK(sphere.vertices().size() == 10 * quads + 2);
        CHECK(sphere.faces().size() == 20 * quads);
        std::set<std::pair<Index, Index>> half_edges;
        for (const Triangle& t : sphere.faces())
            for (std::size_t k = 0; k < 3; ++k)
                half_edges.emplace(t[k], t[(k + 1) % 3]);
        CHECK(half_edges.size() == 60 * quads); // no half edge twice: oriented
        bool closed = true;
        for (const auto& [a, b] : half_edges)
            closed = closed && half_edges.contains({b, a});
        CHECK(closed);
        CHECK(sphere.vertices().size() + sphere.faces().size() - half_edges.size() / 2 == 2); // Euler
    }
}

TEST_CASE("the finest level can be built and the next is refused") {
    const Icosphere sphere(max_level);
    CHECK(sphere.vertices().size() == 2621442);
    CHECK(sphere.faces().size() == 5242880);
    CHECK_THROWS_AS(Icosphere(max_level + 1), ParameterError);
}

TEST_CASE("coarser levels are prefixes") {
    const Icosphere fine(5);
    for (unsigned level = 0; level < 5; ++level) {
        const Icosphere coarse(level);
        CHECK(std::equal(coarse.vertices().begin(), coarse.vertices().end(), fine.vertices().begin()));
    }
}

TEST_CASE("faces 4f to 4f + 2 lie at the corners of face f of the coarser level, 4f + 3 in its middle") {
    const Icosphere coarse(3), fine(4);
    for (std::size_t f = 0; f < coarse.faces().size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(fine.faces()[4 * f + k][k] == coarse.faces()[f][k]);
            CHECK(fine.faces()[4 * f + 3][k] == fine.faces()[4 * f + k][(k + 1) % 3]);
        }
}

TEST_CASE("vertices and faces are those of the independent generator, bit for bit") {
    const Icosphere sphere(6);
    for (const VertexVector& vector : vertex_vectors)
        CHECK(sphere.vertices()[vector.vertex] == Vec3(vector.x, vector.y, vector.z));
    for (const FaceVector& vector : face_vectors)
        CHECK(Icosphere(vector.level).faces()[vector.face] == vector.corners);
}

TEST_CASE("vertices have radius 1, faces look outwards, and the area converges as h^2") {
    double last_deficit = 0;
    for (unsigned level = 0; level <= 6; ++level) {
        const TriangleMesh mesh = Icosphere(level).mesh();
        double worst = 0, least = 1;
        for (const Vec3& v : mesh.positions)
            worst = std::max(worst, std::abs(v.norm() - 1));
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
            least =
                std::min(least, area_vector(mesh, f).normalized().dot(mesh.positions[mesh.triangles[f][0]]));
        CHECK(worst < 4e-16);
        CHECK(least > 0.79); // the icosahedron's inradius over its circumradius is 0.7947
        const double deficit = 4 * std::numbers::pi - surface_area(mesh);
        CHECK(deficit > 0);
        if (level >= 3)
            CHECK(last_deficit / deficit == doctest::Approx(4).epsilon(0.02));
        last_deficit = deficit;
    }
}
