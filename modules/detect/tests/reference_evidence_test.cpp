// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/reference_evidence.hpp>

#include <cmath>

#include <doctest/doctest.h>

#include <wm3d/detect/tail.hpp>
#include <wm3d/mesh/frame.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/shapes/shapes.hpp>
#include <wm3d/sphere/icosphere.hpp>

#include "support.hpp"

using namespace wm3d;
using detect::test::rmax;

namespace {

/// Repeatable numbers of (-1, 1) without visible order.
std::vector<double> numbers(std::size_t count, double seed) {
    std::vector<double> x(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double s = std::sin(12.9898 * static_cast<double>(i + 1) + seed) * 43758.5453;
        x[i] = 2 * (s - std::floor(s)) - 1;
    }
    return x;
}

struct Scene {
    TriangleMesh mesh = shapes::blob(4000, 2);
    sphere::SparseRows rows;
    std::vector<double> w, difference, trust;

    Scene() {
        mesh = to_frame(mesh, canonical_frame(mesh));
        const sphere::Icosphere sphere(4);
        rows = sphere::barycentric_rows(sphere, mesh.positions);
        w = numbers(rows.columns, 1);
        for (double& x : w)
            x *= rmax;
        difference = sphere::multiply(rows, w);
        const std::vector<Vec3> normals = vertex_normals(mesh);
        const std::vector<double> noise = numbers(difference.size(), 7);
        for (std::size_t i = 0; i < difference.size(); ++i)
            difference[i] =
                0.01 * normals[i].dot(mesh.positions[i].normalized()) * difference[i] + 0.003 * noise[i];
        trust.assign(difference.size(), 1);
    }

    double log10_p(std::span<const double> key) const {
        const detect::ReferenceEvidence evidence(mesh, difference, trust);
        const detect::LinearStatistic t = evidence.statistic(rows, rmax);
        return detect::exact_tail(t, t.value(key)).log10_p;
    }
};

} // namespace

TEST_CASE("a mark below the noise is found in the difference, and another key's is not") {
    const Scene scene;
    CHECK(scene.log10_p(scene.w) < -12);
    for (double seed : {11.0, 12.0, 13.0, 14.0}) {
        std::vector<double> other = numbers(scene.w.size(), seed);
        for (double& x : other)
            x *= rmax;
        CHECK(scene.log10_p(other) > -4);
    }
}

TEST_CASE("places without a counterpart have no say, however far off they are") {
    Scene half;
    for (std::size_t i = 0; i < half.trust.size(); ++i)
        if (half.mesh.positions[i].x() > 0) {
            half.trust[i] = 0;
            half.difference[i] = 0;
        }
    const double without = half.log10_p(half.w);
    CHECK(without < -4);
    for (std::size_t i = 0; i < half.trust.size(); ++i)
        half.trust[i] = 0;
    const detect::ReferenceEvidence nothing(half.mesh, half.difference, half.trust);
    CHECK(nothing.statistic(half.rows, rmax).sigma() == 0);
}

TEST_CASE("a suspect that equals its reference says nothing") {
    const Scene scene;
    const std::vector<double> zero(scene.difference.size(), 0.0);
    const detect::ReferenceEvidence evidence(scene.mesh, zero, scene.trust);
    CHECK(evidence.statistic(scene.rows, rmax).sigma() == 0);
}
