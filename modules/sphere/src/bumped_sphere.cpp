// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/sphere/bumped_sphere.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>

namespace wm3d::sphere {

double bumped_radius(const SphereLocation& at, std::span<const double> w, double radius) {
    double sum = 0;
    for (int j = 0; j < 3; ++j)
        sum += at.barycentric[j] / (radius + w[at.vertices[j]]);
    return at.flat_radius / sum; // R_P of eq. (3)
}

double delta(const SphereLocation& at, std::span<const double> w, double radius) {
    return bumped_radius(at, w, radius) - radius; // Delta of eq. (3)
}

double linear_delta(const SphereLocation& at, std::span<const double> w) {
    return at.barycentric[0] * w[at.vertices[0]] + at.barycentric[1] * w[at.vertices[1]] +
           at.barycentric[2] * w[at.vertices[2]];
}

double linearization_bound(double flat_radius, double rmax, double radius) {
    const double ends = std::sqrt(radius + rmax) - std::sqrt(radius - rmax);
    return ends * ends + (1 - flat_radius) * (radius + rmax);
}

BumpedSphere::BumpedSphere(Icosphere sphere, std::vector<double> w, double radius)
    : sphere_(std::move(sphere)), w_(std::move(w)), radius_(radius) {
    if (w_.size() != sphere_.vertices().size())
        throw ParameterError(fmt::format("a sphere of level {} needs {} heights, but {} were given",
                                         sphere_.level(), sphere_.vertices().size(), w_.size()));
    const auto bad = std::ranges::find_if(w_, [&](double height) { return !(radius_ + height > 0); });
    if (bad != w_.end())
        throw ParameterError(
            fmt::format("the height {} of sphere vertex {} reaches the centre of the sphere of radius "
                        "{}; take a smaller rmax",
                        *bad, bad - w_.begin(), radius_));
}

std::vector<double> BumpedSphere::deltas(std::span<const Vec3> directions) const {
    std::vector<double> result(directions.size());
    parallel_blocks(result.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            result[i] = delta(sphere_.locate(directions[i]), w_, radius_);
    });
    return result;
}

TriangleMesh BumpedSphere::mesh() const {
    TriangleMesh mesh = sphere_.mesh();
    for (std::size_t j = 0; j < w_.size(); ++j)
        mesh.positions[j] *= radius_ + w_[j];
    return mesh;
}

} // namespace wm3d::sphere
