// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/shapes/sample.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh.hpp>

using namespace wm3d;
using shapes::sample;

namespace {

/// 1 for an equilateral triangle, near 0 for a sliver.
double quality(const TriangleMesh& mesh, std::size_t f) {
    const auto& [a, b, c] = mesh.triangles[f];
    const Vec3 u = mesh.positions[b] - mesh.positions[a], v = mesh.positions[c] - mesh.positions[a];
    const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
    return 2 / std::sqrt(3.0) * u.cross(v).norm() / longest;
}

/// Part of the surface that the segment from the centroid reaches from inside only: its normal looks back.
double part_facing_centre(const TriangleMesh& mesh, const Vec3& centre) {
    double facing = 0, total = 0;
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const Vec3 n = area_vector(mesh, f);
        facing += n.dot(mesh.positions[mesh.triangles[f][0]] - centre) < 0 ? n.norm() : 0;
        total += n.norm();
    }
    return facing / total;
}

} // namespace

TEST_CASE("at every size the sample is closed, manifold and has about the faces asked for") {
    for (const std::size_t faces : {2000u, 5000u, 20000u, 60000u}) {
        CAPTURE(faces);
        const TriangleMesh mesh = sample(faces, 1);
        CHECK(std::abs(static_cast<double>(mesh.triangles.size()) / static_cast<double>(faces) - 1) < 0.05);
        const Topology t = inspect_topology(mesh);
        CHECK(t.closed());
        CHECK(enclosed_volume(mesh) > 0);
        if (faces >= 20000) { // with its handle: genus 1
            CHECK(t.euler_characteristic == 0);
            CHECK(t.components == 1);
        }
    }
}

TEST_CASE("the sample is a demanding host: not star-shaped, with a clear frame, of sound triangles") {
    const TriangleMesh mesh = sample(40000, 1);
    const SurfaceMoments moments = surface_moments(mesh);
    CHECK(part_facing_centre(mesh, moments.centroid) > 0.1);
    const Vec3 variances = Eigen::SelfAdjointEigenSolver<Mat3>(moments.covariance).eigenvalues();
    CHECK(variances[1] > 1.5 * variances[0]);
    CHECK(variances[2] > 1.5 * variances[1]);
    const auto poor = [&] {
        std::size_t count = 0;
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
            count += quality(mesh, f) < 0.3;
        return count;
    }();
    CHECK(poor < mesh.triangles.size() / 50);
}

TEST_CASE("the sample repeats with its seed, changes with it, and ignores the number of threads") {
    const TriangleMesh mesh = sample(5000, 3);
    CHECK(sample(5000, 4).positions != mesh.positions);
    const ThreadLimit limit(1);
    CHECK(sample(5000, 3).positions == mesh.positions);
}

TEST_CASE("numbers of faces out of range are refused") {
    CHECK_THROWS_AS(sample(shapes::sample_min_faces - 1, 1), ParameterError);
    CHECK_THROWS_AS(sample(shapes::sample_max_faces + 1, 1), ParameterError);
}
