// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/mark.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <wm3d/core/error.hpp>
#include <wm3d/detect/verdict.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/shaping/shaping.hpp>
#include <wm3d/sphere/bumped_sphere.hpp>
#include <wm3d/sphere/sparse_rows.hpp>

namespace wm3d::watermark {

namespace {

unsigned level_of(const TriangleMesh& mesh, const key::Key& key, const MarkOptions& options) {
    const std::vector<unsigned>& levels = key.parameters().levels;
    const unsigned level = options.level.value_or(default_level(key.parameters(), mesh.positions.size()));
    if (std::ranges::find(levels, level) == levels.end())
        throw ParameterError(
            fmt::format("the key admits marks of level {} and not of {}, so verify would not look for "
                        "it; choose one of them or make a key with `keygen --levels`",
                        fmt::join(levels, ", "), level));
    return level;
}

double gamma_of(double strength, double unit_rms, double diagonal) {
    if (!(unit_rms > 0))
        throw GeometryError(
            "no radial move of this surface shows along its normals, so it can't be marked; a closed "
            "or curved model can");
    return strength / 100 * diagonal / unit_rms;
}

maps::BaseDomain base_domain(const TriangleMesh& canonical, std::size_t vertices, const Progress& progress) {
    simplify::Options options;
    options.target_vertices = vertices;
    return maps::parameterize(canonical, options, progress);
}

Forecast forecast_on(const Examination& host, unsigned level, const key::Key& key,
                     const MarkOptions& options) {
    Sequences sequences(key.secret(), key.parameters().rmax);
    Forecast result;
    result.expected_sigmas = host.expected_sigmas(sequences, level, options.strength);
    result.predicted_miss =
        detect::predicted_miss(result.expected_sigmas, std::log10(options.pf), host.family().size());
    return result;
}

} // namespace

embed::Distortion percent(const embed::Distortion& distortion, double diagonal) {
    const double scale = diagonal > 0 ? 100 / diagonal : 0;
    return {distortion.normal_rms * scale, distortion.vertex_rms * scale, distortion.max * scale};
}

Forecast forecast(const TriangleMesh& mesh, const key::Key& key, const MarkOptions& options,
                  const Progress& progress) {
    const Examination host(mesh, examination_options(key.parameters(), options.vertices), progress);
    return forecast_on(host, level_of(mesh, key, options), key, options);
}

Marker::Marker(const TriangleMesh& mesh, std::size_t vertices, const Progress& progress)
    : mesh_(mesh), frame_(canonical_frame(mesh)), diagonal_(surface_box(mesh).diagonal()),
      canonical_(to_frame(mesh, frame_)), domain_(base_domain(canonical_, vertices, progress)),
      detailed_(canonical_, domain_.mesh, domain_.point) {}

std::vector<Vec3> Marker::bumpy_base(std::span<const double> delta, double gamma) const {
    return embed::mark_base(domain_.mesh.positions, delta, gamma);
}

std::vector<Vec3> Marker::shaped_base(std::span<const double> w, const MarkSetting& setting) const {
    const TriangleMesh& base = domain_.mesh;
    const sphere::SparseRows rows =
        sphere::barycentric_rows(sphere::Icosphere(setting.level), base.positions);
    const double rms = setting.strength / 100 * diagonal_ / frame_.scale;
    const double density =
        static_cast<double>(base.positions.size()) / static_cast<double>(mesh_.positions.size());
    const std::vector<double> moves = shaping::normal_moves(base, rows, w, rms, density);
    const std::vector<Vec3> normals = vertex_normals(base);
    std::vector<Vec3> moved = base.positions;
    for (std::size_t i = 0; i < moved.size(); ++i)
        moved[i] += rms * moves[i] * normals[i];
    // That is the strength on the base; the full mesh's differs by what its details hide.
    const double factor = setting.strength / 100 * (diagonal_ / frame_.scale) / normal_rms(moved);
    for (std::size_t i = 0; i < moved.size(); ++i)
        moved[i] = base.positions[i] + factor * (moved[i] - base.positions[i]);
    return moved;
}

double Marker::normal_rms(std::span<const Vec3> moved_base) const {
    return embed::distortion(canonical_, detailed_.reconstruct(moved_base)).normal_rms;
}

Marked Marker::mark(const key::Secret& secret, const MarkSetting& setting) const {
    const std::vector<Vec3>& base = domain_.mesh.positions;
    const std::vector<double> w =
        payload::mark_sequence(secret, setting.level, setting.rmax, setting.content);
    const sphere::BumpedSphere bumped(sphere::Icosphere(setting.level), w);
    const std::vector<double> delta = bumped.deltas(base);
    Marked marked;
    marked.level = setting.level;
    marked.rmax = setting.rmax;
    marked.frame = frame_;
    marked.diagonal = diagonal_;
    marked.base_vertices = base.size();
    // The move is linear in gamma: one trial tells the gamma of any strength.
    constexpr double trial = 1e-3;
    const double unit = diagonal_ / frame_.scale;
    marked.gamma = setting.gamma
                       ? *setting.gamma
                       : gamma_of(setting.strength, normal_rms(bumpy_base(delta, trial)) / trial, unit);
    marked.profile = setting.gamma ? Profile::paper : setting.profile;
    const std::vector<Vec3> moved = detailed_.reconstruct(
        marked.profile == Profile::robust ? shaped_base(w, setting) : bumpy_base(delta, marked.gamma));
    marked.positions = mesh_.positions;
    for (std::size_t i = 0; i < moved.size(); ++i)
        if (moved[i] != canonical_.positions[i]) // what did not move keeps its exact coordinates
            marked.positions[i] = frame_.from_canonical(moved[i]);
    marked.distortion = embed::distortion(mesh_, marked.positions);
    return marked;
}

Marked mark(const TriangleMesh& mesh, const key::Key& key, const MarkOptions& options,
            const Progress& progress) {
    const unsigned level = level_of(mesh, key, options); // before any work
    const Marker marker(mesh, options.vertices, progress);
    notify(progress, "marking", 0);
    Marked marked =
        marker.mark(key.secret(), {level, options.rmax.value_or(key.parameters().rmax), options.strength,
                                   options.gamma, options.profile, options.content});
    notify(progress, "marking", 1);
    return marked;
}

} // namespace wm3d::watermark
