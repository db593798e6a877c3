// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/shapes/turned.hpp>

#include <cmath>

#include <doctest/doctest.h>
#include <wm3d/mesh/frame.hpp>
#include <wm3d/mesh/topology.hpp>

using namespace wm3d;

TEST_CASE("turned solids are closed, look outwards, and have two equal moments") {
    for (const TriangleMesh& mesh : {shapes::vase(6000), shapes::gear(24, 6000), shapes::disc(6000)}) {
        CHECK(inspect_topology(mesh).closed());
        CHECK(inspect_topology(mesh).degenerate_triangles == 0);
        CHECK(inspect_topology(mesh).components == 1);
        CHECK(enclosed_volume(mesh) > 0);
        CHECK(std::abs(static_cast<double>(mesh.positions.size()) - 6000) < 300);
        const Mat3 covariance = shape_moments(mesh).of(Substance::solid).covariance;
        CHECK(covariance(0, 0) == doctest::Approx(covariance(1, 1)).epsilon(0.005));
    }
}
