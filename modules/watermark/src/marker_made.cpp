// SPDX-License-Identifier: GPL-3.0-or-later
// What depends on no key, made when it is first needed.
#include <algorithm>
#include <utility>

#include <wm3d/core/parallel.hpp>
#include <wm3d/key/stream.hpp>
#include <wm3d/mesh/frame.hpp>

#include "marker_parts.hpp"

namespace wm3d::watermark {

namespace {

/// Of the solver of a trial mark's carriers.
constexpr double trial_tolerance = 1e-3;

/// Trial marks of the masks: a family that no key and no trial draws from.
constexpr std::uint64_t mask_family = 0x6d61736b;

/// On meshes of more vertices nothing is made at once that takes memory while it is made.
constexpr std::size_t large = 60'000;

maps::BaseDomain base_domain(const TriangleMesh& canonical, std::size_t vertices, const Progress& progress) {
    simplify::Options options;
    options.target_vertices = vertices;
    return maps::parameterize(canonical, options, progress);
}

} // namespace

Marker::Base::Base(const TriangleMesh& canonical, std::size_t vertices, const Progress& progress)
    : domain(base_domain(canonical, vertices, progress)), detailed(canonical, domain.mesh, domain.point) {}

const TriangleMesh& Marker::canonical() const {
    if (!made_->canonical)
        made_->canonical = to_frame(mesh_, frame_);
    return *made_->canonical;
}

const Marker::Base& Marker::base() const {
    const std::lock_guard lock(made_->guard);
    if (!made_->base)
        made_->base = std::make_unique<Base>(canonical(), vertices_, progress_);
    return *made_->base;
}

const masking::Budget& Marker::budget() const {
    const std::lock_guard lock(made_->guard);
    return made_budget();
}

const masking::Budget& Marker::made_budget() const {
    if (!made_->budget)
        made_->budget = std::make_unique<masking::Budget>(mesh_);
    return *made_->budget;
}

/// What doesn't depend on each other is made at once, but on large meshes, where each takes memory while it is made.
Marker::Carried Marker::fresh_carriers(unsigned level) const {
    std::optional<Carried> fresh;
    const auto make = [&] {
        fresh.emplace(Carried{std::nullopt, masking::Carriers(mesh_, frame_), std::nullopt});
    };
    if (mesh_.positions.size() <= large) {
        parallel_invoke([&] { made_budget(); }, make);
        fresh->rows = rows(level, 0, mesh_.positions.size());
    } else {
        made_budget();
        make();
    }
    return *std::move(fresh);
}

/// Weighs the mask by a trial mark.
void Marker::weigh(Carried& carried, unsigned level) const {
    masking::Carriers& carriers = carried.carriers;
    const std::vector<double> moves = carriers.carry(
        bumps(carried, level, key::watermark_sequence(key::null_secret(mask_family, 0), level, 0.1)),
        trial_tolerance);
    const double rms = percent_of_diagonal(carriers.rms(moves));
    if (!(rms > 0))
        return;
    const auto trial = [&](double strength) { return moved(carriers, moves, strength / rms); };
    carried.usual_factor = made_budget().equalize(carriers, trial, default_visibility, first_strength) / rms;
}

/// \param meanwhile  done with the carriers, while they are weighed if they are new
const Marker::Carried& Marker::carried(unsigned level, const Meanwhile& meanwhile) const {
    const std::lock_guard lock(made_->guard);
    auto found = made_->carried.find(level);
    if (found == made_->carried.end()) {
        Carried fresh = fresh_carriers(level);
        parallel_invoke(
            [&] {
                if (meanwhile)
                    meanwhile(fresh);
                if (mesh_.positions.size() <= large)
                    fresh.creases.emplace(mesh_, fresh.carriers.normals());
            },
            [&] { weigh(fresh, level); });
        found = made_->carried.emplace(level, std::move(fresh)).first;
    } else if (meanwhile) {
        meanwhile(found->second);
    }
    return found->second;
}

/// B for some vertices.
sphere::SparseRows Marker::rows(unsigned level, std::size_t begin, std::size_t end) const {
    std::vector<Vec3> places(end - begin);
    std::transform(mesh_.positions.begin() + static_cast<std::ptrdiff_t>(begin),
                   mesh_.positions.begin() + static_cast<std::ptrdiff_t>(end), places.begin(),
                   [&](const Vec3& p) { return frame_.to_canonical(p); });
    return sphere::barycentric_rows(sphere::Icosphere(level), places);
}

std::vector<double> Marker::bumps(const Carried& with, unsigned level, std::span<const double> w) const {
    if (with.rows)
        return with.carriers.bumps(*with.rows, w);
    constexpr std::size_t some = 1 << 17; // whose rows are held at a time
    std::vector<double> heights;
    heights.reserve(mesh_.positions.size());
    for (std::size_t begin = 0; begin < mesh_.positions.size(); begin += some) {
        const std::vector<double> next =
            sphere::multiply(rows(level, begin, std::min(begin + some, mesh_.positions.size())), w);
        heights.insert(heights.end(), next.begin(), next.end());
    }
    return with.carriers.bumps(std::move(heights));
}

} // namespace wm3d::watermark
