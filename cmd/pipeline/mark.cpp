// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/mark.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <wm3d/detect/verdict.hpp>
#include <wm3d/mesh/error.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/sphere/bumped_sphere.hpp>

namespace wm3d::pipeline {

namespace {

unsigned level_of(const key::Key& key, const MarkOptions& options) {
    const std::vector<unsigned>& levels = key.parameters().levels;
    const unsigned level = options.level.value_or(default_level(key.parameters()));
    if (std::ranges::find(levels, level) == levels.end())
        throw ParameterError(fmt::format("the key admits marks of level {} and not of {}, so verify would not look for "
                                         "it; choose one of them or make a key with `keygen --levels`",
                                         fmt::join(levels, ", "), level));
    return level;
}

double gamma_of(double strength, double unit_rms, double diagonal) {
    if (!(unit_rms > 0))
        throw GeometryError("no radial move of this surface shows along its normals, so it can't be marked; a closed "
                            "or curved model can");
    return strength / 100 * diagonal / unit_rms;
}

maps::BaseDomain base_domain(const TriangleMesh& canonical, std::size_t vertices, const Progress& progress) {
    simplify::Options options;
    options.target_vertices = vertices;
    return maps::parameterize(canonical, options, progress);
}

Forecast forecast_on(const Examination& host, const key::Key& key, const MarkOptions& options, double strength) {
    Sequences sequences(key.secret(), key.parameters().rmax);
    Forecast result;
    result.expected_sigmas = host.expected_sigmas(sequences, level_of(key, options), strength);
    result.predicted_miss =
        detect::predicted_miss(result.expected_sigmas, std::log10(options.pf), host.family().size());
    return result;
}

ExaminationOptions examination_options(const key::Key& key, const MarkOptions& options) {
    ExaminationOptions result;
    result.vertices = options.vertices;
    result.levels = key.parameters().levels;
    result.rmax = key.parameters().rmax;
    return result;
}

} // namespace

embed::Distortion percent(const embed::Distortion& distortion, double diagonal) {
    const double scale = diagonal > 0 ? 100 / diagonal : 0;
    return {distortion.normal_rms * scale, distortion.vertex_rms * scale, distortion.max * scale};
}

Forecast forecast(const TriangleMesh& mesh, const key::Key& key, const MarkOptions& options,
                  const Progress& progress) {
    const Examination host(mesh, examination_options(key, options), progress);
    return forecast_on(host, key, options, options.strength);
}

Marker::Marker(const TriangleMesh& mesh, std::size_t vertices, const Progress& progress)
    : mesh_(mesh), frame_(canonical_frame(mesh)), diagonal_(surface_box(mesh).diagonal()),
      canonical_(to_frame(mesh, frame_)), domain_(base_domain(canonical_, vertices, progress)),
      detailed_(canonical_, domain_.mesh, domain_.point) {}

Marked Marker::mark(const key::Secret& secret, unsigned level, double rmax, double strength,
                    std::optional<double> gamma) const {
    const sphere::BumpedSphere bumped(sphere::Icosphere(level), key::watermark_sequence(secret, level, rmax));
    const std::vector<double> delta = bumped.deltas(domain_.mesh.positions);
    const auto moved_by = [&](double factor) {
        return detailed_.reconstruct(embed::mark_base(domain_.mesh.positions, delta, factor));
    };
    Marked marked;
    marked.level = level;
    marked.rmax = rmax;
    marked.frame = frame_;
    marked.diagonal = diagonal_;
    marked.base_vertices = domain_.mesh.positions.size();
    if (gamma) {
        marked.gamma = *gamma;
    } else {
        // The move is linear in gamma: one trial tells the gamma of any strength.
        constexpr double trial = 1e-3;
        const double unit_rms = embed::distortion(canonical_, moved_by(trial)).normal_rms / trial;
        marked.gamma = gamma_of(strength, unit_rms, diagonal_ / frame_.scale);
    }
    const std::vector<Vec3> moved = moved_by(marked.gamma);
    marked.positions = mesh_.positions;
    for (std::size_t i = 0; i < moved.size(); ++i)
        if (moved[i] != canonical_.positions[i]) // what did not move keeps its exact coordinates
            marked.positions[i] = frame_.from_canonical(moved[i]);
    marked.distortion = embed::distortion(mesh_, marked.positions);
    return marked;
}

Marked mark(const TriangleMesh& mesh, const key::Key& key, const MarkOptions& options, const Progress& progress) {
    const unsigned level = level_of(key, options); // before any work
    const Marker marker(mesh, options.vertices, progress);
    report(progress, "marking", 0);
    Marked marked = marker.mark(key.secret(), level, options.rmax.value_or(key.parameters().rmax), options.strength,
                                options.gamma);
    report(progress, "marking", 1);
    return marked;
}

} // namespace wm3d::pipeline
