// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/evidence.hpp>

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include <wm3d/core/parallel.hpp>
#include <wm3d/detect/tail.hpp>
#include <wm3d/mesh/frame.hpp>
#include <wm3d/shapes.hpp>
#include <wm3d/sphere/icosphere.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::detect;
using detect::test::rmax;

namespace {

constexpr unsigned level = 4;

TriangleMesh canonical_blob() {
    const TriangleMesh mesh = shapes::blob(8000, 21);
    return to_frame(mesh, canonical_frame(mesh));
}

sphere::SparseRows rows_of(const TriangleMesh& mesh) {
    return sphere::barycentric_rows(sphere::Icosphere(level), mesh.positions);
}

std::vector<double> sequence(std::uint64_t seed) {
    std::vector<double> w(10 * (std::size_t{1} << (2 * level)) + 2);
    for (double& x : w) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        x = rmax * (static_cast<double>(seed >> 11) * 0x1p-52 - 1);
    }
    return w;
}

TriangleMesh marked(TriangleMesh mesh, const sphere::SparseRows& rows, std::span<const double> w,
                    double gamma) {
    const std::vector<double> delta = sphere::multiply(rows, w);
    for (std::size_t i = 0; i < delta.size(); ++i)
        mesh.positions[i] *= 1 + gamma * delta[i] / mesh.positions[i].norm();
    return mesh;
}

/// Round steps, one upon the other, with all vertices on their rims: plane treads and cylindrical risers.
TriangleMesh steps() {
    constexpr Index around = 400, rings = 12;
    TriangleMesh mesh;
    for (Index ring = 0; ring < rings; ++ring) {
        const Index treads = (ring + 1) / 2, risers = ring / 2; // from the first rim to this one
        const double radius = 1.5 - 0.25 * treads, height = 0.3 * risers - 0.8;
        for (Index k = 0; k < around; ++k) {
            const double angle = 2 * std::numbers::pi * k / around;
            mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
        }
    }
    for (Index ring = 0; ring + 1 < rings; ++ring)
        for (Index k = 0; k < around; ++k) {
            const Index a = ring * around + k, b = ring * around + (k + 1) % around;
            mesh.triangles.push_back({a, b, b + around});
            mesh.triangles.push_back({a, b + around, a + around});
        }
    return mesh;
}

} // namespace

TEST_CASE("the places of the bank are where the names say") {
    const std::vector<Filter> bank = EvidenceOptions{}.filters;
    REQUIRE(bank.size() == folds_of_flats + 1);
    CHECK((bank[smoothed_scans].hinges == 0 && bank[smoothed_scans].bound > 0));
    CHECK((bank[coarse_coordinates].hinges == 0 && bank[coarse_coordinates].calming > 0));
    for (const std::size_t place :
         {folds_after_rounding, folds_as_marked, folds_after_simplification, folds_of_flats}) {
        CHECK(bank[place].hinges > 0);
        CHECK(bank[place].noise < bank[folds_under_noise].noise);
    }
    CHECK((bank[folds_of_flats].noise == 0 && bank[folds_of_flats].evened));
}

TEST_CASE("a mark raises the score of its own key by about what was predicted, and of no other") {
    const TriangleMesh host = canonical_blob();
    const sphere::SparseRows rows = rows_of(host);
    const std::vector<double> w = sequence(5), other = sequence(6);
    const Evidence clean(host);
    // The move along the normals of gamma = 0.02, to ask for the prediction.
    const std::vector<double> delta = sphere::multiply(rows, w);
    double squares = 0;
    const std::vector<double> area(vertex_areas(host));
    double total = 0;
    for (std::size_t i = 0; i < delta.size(); ++i) {
        squares += area[i] * std::pow(0.02 * delta[i] * clean.visibility()[i], 2);
        total += area[i];
    }
    const TriangleMesh suspect = marked(host, rows, w, 0.02);
    const Evidence found(suspect);
    for (std::size_t f = 0; f < found.filters(); ++f) {
        CAPTURE(f);
        const LinearStatistic before = clean.statistic(f, rows, rmax), after = found.statistic(f, rows, rmax);
        CHECK(std::abs(before.value(w)) < 5 * before.sigma());
        // What is whitened against the strongest noise gives up more of a mark without any.
        const bool of_noise = found.filter(f).noise > 5e-3;
        CHECK(after.value(w) > (of_noise ? 5 : 8) * after.sigma());
        CHECK(std::abs(after.value(other)) < 5 * after.sigma());
        CHECK(exact_tail(after, after.value(w)).log10_p < (of_noise ? -8 : -12));
        const double predicted = clean.expected_sigmas(f, rows, w, rmax, std::sqrt(squares / total));
        CHECK(predicted == doctest::Approx(after.value(w) / after.sigma()).epsilon(0.3));
    }
}

TEST_CASE("turning the mesh and the directions together changes nothing") {
    const TriangleMesh host = canonical_blob();
    TriangleMesh turned = host;
    const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (Vec3& p : turned.positions)
        p = turn * p;
    const sphere::SparseRows rows = rows_of(host);
    const LinearStatistic a = Evidence(host).statistic(5, rows, rmax),
                          b = Evidence(turned).statistic(5, rows, rmax);
    const std::vector<double> w = sequence(8);
    CHECK(std::abs(a.value(w) / a.sigma() - b.value(w) / b.sigma()) < 0.02);
}

TEST_CASE("bounding the residual finds a mark among sharp edges that would drown it") {
    // Spikes on a twentieth of the vertices, as hidden edges are.
    TriangleMesh host = canonical_blob();
    for (std::size_t i = 0; i < host.positions.size(); i += 20)
        host.positions[i] *= i % 40 == 0 ? 1.02 : 0.98;
    const sphere::SparseRows rows = rows_of(host);
    const std::vector<double> w = sequence(8);
    const TriangleMesh suspect = marked(host, rows, w, 0.01);
    const auto sigmas = [&](double bound) {
        EvidenceOptions options;
        options.filters = {{3e-5, 0, 1e-3, 0, 0, bound}};
        const LinearStatistic t = Evidence(suspect, options).statistic(0, rows, rmax);
        return t.value(w) / t.sigma();
    };
    CHECK(sigmas(6) > 2 * std::max(sigmas(0), 2.0));
}

TEST_CASE(
    "hinges find a mark on a part whose every vertex lies on a sharp edge, where diffusions find nothing") {
    const TriangleMesh host = steps();
    const sphere::SparseRows rows = rows_of(host);
    const std::vector<double> w = sequence(8);
    const TriangleMesh suspect = marked(host, rows, w, 0.002);
    const auto sigmas = [&](const Filter& filter) {
        EvidenceOptions options;
        options.filters = {filter};
        const LinearStatistic t = Evidence(suspect, options).statistic(0, rows, rmax);
        return t.value(w) / t.sigma();
    };
    for (const Filter& hinges : {Filter::of_hinges(2e-4, 0, true), Filter::of_hinges(2e-4, 3e-4, true)})
        CHECK(sigmas(hinges) > 2 * std::max(3.0, sigmas({3e-5, 1.0, 3e-4})));
}

TEST_CASE("folds that are whitened bear the noise of the vertices") {
    const TriangleMesh host = steps();
    const sphere::SparseRows rows = rows_of(host);
    const std::vector<double> w = sequence(8);
    TriangleMesh suspect = marked(host, rows, w, 0.004);
    const std::vector<double> noise = sequence(9);
    for (std::size_t i = 0; i < suspect.positions.size(); ++i)
        for (int k = 0; k < 3; ++k)
            suspect.positions[i][k] +=
                0.0015 / rmax * noise[(3 * i + static_cast<std::size_t>(k)) % noise.size()];
    EvidenceOptions options;
    options.filters = {Filter::of_hinges(2e-4, 0), Filter::of_hinges(2e-4, 2e-3)};
    const Evidence evidence(suspect, options);
    const auto sigmas = [&](std::size_t f) {
        const LinearStatistic t = evidence.statistic(f, rows, rmax);
        return t.value(w) / t.sigma();
    };
    CAPTURE(sigmas(0));
    CAPTURE(sigmas(1));
    CHECK(sigmas(1) > 1.3 * std::max(sigmas(0), 3.0));
}

TEST_CASE("surfaces that say little are borne: flat, tiny, degenerate") {
    for (const TriangleMesh& mesh :
         {shapes::box({1, 1, 1}, 1), shapes::box({1, 2, 3}, 12), shapes::square(1, 8)}) {
        const TriangleMesh base = to_frame(mesh, canonical_frame(mesh));
        const Evidence evidence(base);
        const sphere::SparseRows rows = rows_of(base);
        for (std::size_t f = 0; f < evidence.filters(); ++f) {
            const LinearStatistic t = evidence.statistic(f, rows, rmax);
            CHECK(std::isfinite(t.sigma()));
            CHECK(std::isfinite(t.value(sequence(3))));
            CHECK(std::isfinite(evidence.expected_sigmas(f, rows, sequence(3), rmax, 0.001)));
        }
    }
}

TEST_CASE("the same bytes at one thread and at many") {
    const TriangleMesh host = canonical_blob();
    const sphere::SparseRows rows = rows_of(host);
    const LinearStatistic many = Evidence(host).statistic(0, rows, rmax);
    const ThreadLimit one(1);
    const LinearStatistic single = Evidence(host).statistic(0, rows, rmax);
    CHECK(std::vector<double>(many.coefficients().begin(), many.coefficients().end()) ==
          std::vector<double>(single.coefficients().begin(), single.coefficients().end()));
}
