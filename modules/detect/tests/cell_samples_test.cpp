// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/cell_samples.hpp>

#include <cmath>
#include <numeric>

#include <doctest/doctest.h>

#include <wm3d/detect/evidence.hpp>
#include <wm3d/mesh/frame.hpp>
#include <wm3d/shapes.hpp>

using namespace wm3d;

TEST_CASE("spreading keeps the sum and puts most near the vertex") {
    const TriangleMesh mesh = shapes::blob(300, 2);
    const detect::CellSamples samples(mesh, 5000);
    CHECK(samples.positions().size() >= 5000);
    CHECK(samples.positions().size() % mesh.triangles.size() == 0);
    std::vector<double> y(mesh.positions.size(), 0.0);
    y[17] = 2.5;
    const std::vector<double> spread = samples.spread(y);
    CHECK(std::accumulate(spread.begin(), spread.end(), 0.0) == doctest::Approx(2.5));
    double mean = 0, farthest = 0;
    for (std::size_t s = 0; s < spread.size(); ++s) {
        const double distance = (samples.positions()[s] - mesh.positions[17]).norm();
        CHECK(spread[s] >= 0);
        mean += spread[s] / 2.5 * distance;
        if (spread[s] > 0)
            farthest = std::max(farthest, distance);
    }
    CHECK(mean < 0.6 * farthest);
}

TEST_CASE("an enlarged statistic depends on the suspect alone and has no other sum than the vertices'") {
    TriangleMesh mesh = shapes::blob(1500, 4);
    mesh = to_frame(mesh, canonical_frame(mesh));
    const detect::Evidence evidence(mesh);
    const detect::CellSamples samples(mesh, 20000);
    const sphere::Icosphere sphere(3);
    const detect::LinearStatistic at_vertices =
        evidence.statistic(5, sphere::barycentric_rows(sphere, mesh.positions), 0.1);
    const detect::LinearStatistic in_cells =
        evidence.statistic(5, samples, sphere::barycentric_rows(sphere, samples.positions()), 0.1);
    const auto sum = [](std::span<const double> c) { return std::accumulate(c.begin(), c.end(), 0.0); };
    CHECK(sum(in_cells.coefficients()) == doctest::Approx(sum(at_vertices.coefficients())).epsilon(1e-9));
    CHECK(in_cells.sigma() < at_vertices.sigma()); // a mean varies less than a point
}
