// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/mark.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <wm3d/detect/verdict.hpp>
#include <wm3d/maps/base_domain.hpp>
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

double gamma_of(const MarkOptions& options, double unit_rms, double diagonal) {
    if (options.gamma)
        return *options.gamma;
    if (!(unit_rms > 0))
        throw GeometryError("no radial move of this surface shows along its normals, so it can't be marked; a closed "
                            "or curved model can");
    return options.strength / 100 * diagonal / unit_rms;
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

Marked mark(const TriangleMesh& mesh, const key::Key& key, const MarkOptions& options, const Progress& progress) {
    Marked marked;
    marked.level = level_of(key, options);
    marked.rmax = options.rmax.value_or(key.parameters().rmax);
    marked.frame = canonical_frame(mesh);
    marked.diagonal = surface_box(mesh).diagonal();

    const TriangleMesh canonical = to_frame(mesh, marked.frame);
    simplify::Options base_options;
    base_options.target_vertices = options.vertices;
    const maps::BaseDomain domain = maps::parameterize(canonical, base_options, progress);
    marked.base_vertices = domain.mesh.positions.size();

    report(progress, "marking", 0);
    const sphere::BumpedSphere bumped(sphere::Icosphere(marked.level),
                                      key::watermark_sequence(key.secret(), marked.level, marked.rmax));
    const std::vector<double> delta = bumped.deltas(domain.mesh.positions);
    const embed::DetailedMesh detailed(canonical, domain.mesh, domain.point);
    // The move is linear in gamma: one trial tells the gamma of any strength.
    constexpr double trial = 1e-3;
    const auto moved_by = [&](double gamma) {
        return detailed.reconstruct(embed::mark_base(domain.mesh.positions, delta, gamma));
    };
    const double unit_rms = embed::distortion(canonical, moved_by(trial)).normal_rms / trial;
    marked.gamma = gamma_of(options, unit_rms, marked.diagonal / marked.frame.scale);
    const std::vector<Vec3> moved = moved_by(marked.gamma);

    marked.positions = mesh.positions;
    for (std::size_t i = 0; i < moved.size(); ++i)
        if (moved[i] != canonical.positions[i]) // what did not move keeps its exact coordinates
            marked.positions[i] = marked.frame.from_canonical(moved[i]);
    marked.distortion = embed::distortion(mesh, marked.positions);
    report(progress, "marking", 1);
    return marked;
}

} // namespace wm3d::pipeline
