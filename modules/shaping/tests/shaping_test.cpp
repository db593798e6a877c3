// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/shaping.hpp>

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/frame.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/umbrella.hpp>
#include <wm3d/shapes.hpp>

using namespace wm3d;

namespace {

constexpr unsigned level = 4;
constexpr double rmax = 0.1;

/// A blob in its canonical frame and a mark for it.
struct Host {
    TriangleMesh base;
    sphere::SparseRows rows;
    std::vector<double> w;

    explicit Host(std::uint64_t seed) : base(shapes::blob(5000, seed)) {
        base = to_frame(base, canonical_frame(base));
        const sphere::Icosphere sphere(level);
        rows = sphere::barycentric_rows(sphere, base.positions);
        std::uint64_t state = seed;
        for (std::size_t j = 0; j < rows.columns; ++j) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            w.push_back(rmax * (static_cast<double>(state >> 11) * 0x1p-52 - 1));
        }
    }

    TriangleMesh moved(const std::vector<double>& moves, double rms) const {
        const std::vector<Vec3> normals = vertex_normals(base);
        TriangleMesh mesh = base;
        for (std::size_t i = 0; i < moves.size(); ++i)
            mesh.positions[i] += rms * moves[i] * normals[i];
        return mesh;
    }

    /// Score in the finest filter.
    double sigmas(const TriangleMesh& mesh) const {
        const detect::LinearStatistic t = detect::Evidence(mesh).statistic(0, rows, rmax);
        return t.value(w) / t.sigma();
    }
};

TriangleMesh smoothed(const TriangleMesh& mesh, int steps) {
    return {Umbrella(mesh).smooth(mesh.positions, steps, 0.1), mesh.triangles};
}

} // namespace

TEST_CASE("the moves have an area-weighted root mean square of one") {
    const Host host(3);
    const std::vector<double> moves = shaping::normal_moves(host.base, host.rows, host.w, 1e-3, 1);
    const std::vector<double> area = vertex_areas(host.base);
    double squares = 0, total = 0;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        squares += area[i] * moves[i] * moves[i];
        total += area[i];
    }
    CHECK(std::sqrt(squares / total) == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("no vertex takes much more than its share, not even one of next to no area") {
    Host host(3);
    // A needle: one vertex is pulled close to a neighbour.
    const Triangle& t = host.base.triangles[100];
    host.base.positions[t[0]] = 0.999 * host.base.positions[t[1]] + 0.001 * host.base.positions[t[0]];
    double largest = 0;
    for (double move : shaping::normal_moves(host.base, host.rows, host.w, 1e-3, 1))
        largest = std::max(largest, std::abs(move));
    CHECK(largest > 2);
    CHECK(largest < 12);
}

TEST_CASE("at the same strength a shaped mark scores more than bumps, after smoothing too") {
    const Host host(5);
    constexpr double rms = 3e-4;
    shaping::Blend bumps;
    bumps.templates.clear();
    const TriangleMesh plain =
        host.moved(shaping::normal_moves(host.base, host.rows, host.w, rms, 1, bumps), rms);
    const TriangleMesh shaped = host.moved(shaping::normal_moves(host.base, host.rows, host.w, rms, 1), rms);
    CHECK(host.sigmas(shaped) > host.sigmas(plain));
    CHECK(host.sigmas(smoothed(shaped, 30)) > 1.2 * host.sigmas(smoothed(plain, 30)));
}

TEST_CASE("the detector's template is the gradient of T") {
    const Host host(7);
    detect::EvidenceOptions options;
    // Of this scale no fold changes its weight.
    options.filters = {shaping::Blend{}.filter, detect::Filter::of_hinges(1, 0),
                       detect::Filter::of_hinges(1, 0.5)};
    const detect::Evidence evidence(host.base, options);
    // A smooth move of all vertices, small enough to be linear, far from the host's own residual.
    const std::vector<Vec3> normals = vertex_normals(host.base);
    const std::vector<double> x = sphere::multiply(host.rows, host.w);
    TriangleMesh up = host.base, down = host.base;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec3 move = 1e-5 * x[i] * normals[i];
        up.positions[i] += move;
        down.positions[i] -= move;
    }
    for (std::size_t filter = 0; filter < evidence.filters(); ++filter) {
        CAPTURE(filter);
        const std::vector<Vec3> gradient = evidence.gradient(filter, host.rows, host.w);
        double predicted = 0;
        for (std::size_t i = 0; i < x.size(); ++i)
            predicted += gradient[i].dot(up.positions[i] - down.positions[i]);
        const auto t = [&](const TriangleMesh& mesh) {
            return detect::Evidence(mesh, options).statistic(filter, host.rows, rmax).value(host.w);
        };
        CHECK(t(up) - t(down) ==
              doctest::Approx(predicted).epsilon(0.2)); // the weights move a little as well
    }
}

TEST_CASE("a mark that shows along no normal moves nothing, and the bytes don't depend on the threads") {
    const Host host(9);
    const std::vector<double> none(host.w.size(), 0.0);
    for (double move : shaping::normal_moves(host.base, host.rows, none, 1e-3, 1))
        CHECK(move == 0);
    const std::vector<double> many = shaping::normal_moves(host.base, host.rows, host.w, 1e-3, 0.5);
    const ThreadLimit one(1);
    CHECK(shaping::normal_moves(host.base, host.rows, host.w, 1e-3, 0.5) == many);
}
