// SPDX-License-Identifier: GPL-3.0-or-later
// How the three profiles lay a mark on a mesh.
#include <utility>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/shaping/shaping.hpp>
#include <wm3d/sphere/bumped_sphere.hpp>
#include <wm3d/sphere/icosphere.hpp>

#include "marker_parts.hpp"

namespace wm3d::watermark {

namespace {

/// Of the solver that makes a mark smooth: what it leaves is a part of the mark.
constexpr double mark_tolerance = 1e-4;

/// The shaped mark on a base domain, of about `rms` mean radii.
std::vector<Vec3> shaped_base(const TriangleMesh& base, std::span<const double> w, unsigned level, double rms,
                              double density) {
    const sphere::SparseRows rows = sphere::barycentric_rows(sphere::Icosphere(level), base.positions);
    const std::vector<double> moves = shaping::normal_moves(base, rows, w, rms, density);
    const std::vector<Vec3> normals = vertex_normals(base);
    std::vector<Vec3> moved = base.positions;
    for (std::size_t i = 0; i < moved.size(); ++i)
        moved[i] += rms * moves[i] * normals[i];
    return moved;
}

} // namespace

double Marker::normal_rms(std::span<const Vec3> moved) const {
    return percent_of_diagonal(embed::distortion(*made_->canonical, moved).normal_rms);
}

std::vector<Vec3> Marker::in_file(std::span<const Vec3> moved) const {
    std::vector<Vec3> positions = mesh_.positions;
    for (std::size_t i = 0; i < moved.size(); ++i)
        if (moved[i] != made_->canonical->positions[i]) // what did not move keeps its exact coordinates
            positions[i] = frame_.from_canonical(moved[i]);
    return positions;
}

std::vector<Vec3> Marker::moved(const masking::Carriers& carriers, std::span<const double> moves,
                                double factor) const {
    constexpr std::size_t block = 16384;
    std::vector<Vec3> positions = mesh_.positions;
    parallel_blocks(positions.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            positions[i] += factor * frame_.scale * moves[i] * carriers.normals()[i];
    });
    return positions;
}

Marker::Layout Marker::masked(std::span<const double> w, unsigned level) const {
    std::vector<double> smooth;
    double unit = 0;
    const Carried& with = carried(level, [&](const Carried& made) {
        smooth = bumps(made, level, w);
        unit = percent_of_diagonal(made.carriers.rms(smooth));
        smooth = made.carriers.smooth(std::move(smooth), mark_tolerance);
    });
    std::vector<double> moves = with.carriers.masked(std::move(smooth));
    const double rms = percent_of_diagonal(with.carriers.rms(moves));
    require_move(rms);
    return {[this, &with, moves = std::move(moves), rms](double strength) {
                return moved(with.carriers, moves, strength / rms);
            },
            unit, with.usual_factor * rms};
}

Marker::Layout Marker::bumpy(std::span<const double> w, unsigned level) const {
    const Base& on = base();
    const std::vector<Vec3>& base_positions = on.domain.mesh.positions;
    const sphere::BumpedSphere bumped(sphere::Icosphere(level), {w.begin(), w.end()});
    const auto marked = [&on, delta = bumped.deltas(base_positions)](double gamma) {
        return on.detailed.reconstruct(embed::mark_base(on.domain.mesh.positions, delta, gamma));
    };
    // The move is linear in gamma: one trial tells the gamma of any strength.
    constexpr double trial = 1e-3;
    const double unit = normal_rms(marked(trial)) / trial;
    require_move(unit);
    return {[this, marked, unit](double strength) { return in_file(marked(strength / unit)); }, unit};
}

Marker::Layout Marker::shaped(std::span<const double> w, unsigned level) const {
    const Base& on = base();
    const double density =
        static_cast<double>(on.domain.mesh.positions.size()) / static_cast<double>(mesh_.positions.size());
    Layout layout;
    layout.unit = bumpy(w, level).unit;
    layout.positions = [this, &on, density, level, w = std::vector(w.begin(), w.end())](double strength) {
        const std::vector<Vec3>& still = on.domain.mesh.positions;
        const double rms = strength / 100 * diagonal_ / frame_.scale;
        std::vector<Vec3> moved = shaped_base(on.domain.mesh, w, level, rms, density);
        // That is the strength on the base; the full mesh's differs by what its details hide.
        const double factor = strength / normal_rms(on.detailed.reconstruct(moved));
        for (std::size_t i = 0; i < moved.size(); ++i)
            moved[i] = still[i] + factor * (moved[i] - still[i]);
        return in_file(on.detailed.reconstruct(moved));
    };
    return layout;
}

Marker::Layout Marker::layout(std::span<const double> w, Profile profile, unsigned level) const {
    switch (profile) {
    case Profile::masked:
        return masked(w, level);
    case Profile::robust:
        return shaped(w, level);
    default:
        return bumpy(w, level);
    }
}

} // namespace wm3d::watermark
