// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/mark.hpp>

#include <cmath>

#include <doctest/doctest.h>

#include <wm3d/masking/budget.hpp>
#include <wm3d/masking/creases.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/shapes.hpp>
#include <wm3d/watermark/defaults.hpp>

#include "fixed_key.hpp"

using namespace wm3d;
using namespace wm3d::watermark;

TEST_CASE("the visibility is kept to by what a file makes of the positions") {
    const TriangleMesh mesh = shapes::blob(4000, 4);
    const key::Key key = fixed_key();
    const auto coarse = [&](std::span<const Vec3> wanted) {
        constexpr double more = 1.3; // as if the file rounded everything away from where it was
        std::vector<Vec3> stored(wanted.begin(), wanted.end());
        for (std::size_t i = 0; i < stored.size(); ++i)
            stored[i] = mesh.positions[i] + more * (wanted[i] - mesh.positions[i]);
        return stored;
    };
    const Marked in_memory = mark(mesh, key);
    REQUIRE(in_memory.seen_by_few); // else the file's steps decide nothing
    const Marked for_file = mark(mesh, key, {}, {}, coarse);
    CHECK(for_file.strength < in_memory.strength);
    const double seen = masking::Budget(mesh).visible(coarse(for_file.positions));
    CHECK(seen <= default_visibility);
    CHECK(for_file.msdm2.value() == doctest::Approx(seen).epsilon(1e-9));
}

TEST_CASE("a mark folds no crease into a surface, but one of a strength that was asked for may") {
    const TriangleMesh mesh = shapes::blob(4000, 4);
    const key::Key key = fixed_key();
    const std::vector<Vec3> normals = vertex_normals(mesh);
    const masking::Creases creases(mesh, normals);
    const auto worst = [&](const Marked& marked) {
        std::vector<double> moves;
        for (std::size_t i = 0; i < normals.size(); ++i)
            moves.push_back(normals[i].dot(marked.positions[i] - mesh.positions[i]));
        return creases.worst(moves);
    };
    MarkOptions options;
    CHECK(worst(mark(mesh, key, options)) < 1.1);
    options.visibility = 0.5; // of a mark that may be seen, creases too
    CHECK(worst(mark(mesh, key, options)) > 1.5);
    options.strength = 0.5;
    CHECK(worst(mark(mesh, key, options)) > 1.5);
}
