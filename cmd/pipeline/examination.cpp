// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/examination.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/parallel.hpp>

namespace wm3d::pipeline {

unsigned default_level(const key::PublicParameters& parameters) {
    constexpr int preferred = 5;
    const auto distance = [](unsigned level) { return std::abs(static_cast<int>(level) - preferred); };
    return *std::ranges::min_element(parameters.levels, {}, distance);
}

namespace {

/// Turns that take the canonical frame to its other sign choices.
std::vector<Mat3> turns(Resync resync) {
    if (resync == Resync::none)
        return {Mat3::Identity()};
    std::vector<Mat3> result;
    for (const Frame& frame : sign_choices(Frame{}))
        result.push_back(frame.axes);
    return result;
}

} // namespace

Examination::Examination(const TriangleMesh& suspect, ExaminationOptions options, const Progress& progress)
    : options_(std::move(options)), turns_(turns(options_.resync)) {
    frame_ = canonical_frame(suspect);
    diagonal_ = surface_box(suspect).diagonal() / frame_.scale;
    simplify::Options simplification;
    simplification.target_vertices = options_.vertices;
    simplify::Result simplified = simplify::simplify(suspect, simplification, progress);
    stop_ = simplified.stop;
    base_ = to_frame(simplified.mesh, frame_);
    report(progress, "examining the surface", 0);
    parallel_invoke([&] { evidence_ = std::make_unique<detect::Evidence>(base_, options_.evidence); },
                    [&] { make_rows(); });
    make_family();
    report(progress, "examining the surface", 1);
}

std::size_t Examination::level_number(unsigned level) const {
    return static_cast<std::size_t>(std::ranges::find(options_.levels, level) - options_.levels.begin());
}

const sphere::SparseRows& Examination::rows(std::size_t pose, unsigned level) const {
    return rows_[pose * options_.levels.size() + level_number(level)];
}

void Examination::make_rows() {
    const sphere::Icosphere finest(std::ranges::max(options_.levels));
    for (const Mat3& turn : turns_) {
        std::vector<Vec3> directions(base_.positions.size());
        std::ranges::transform(base_.positions, directions.begin(), [&](const Vec3& p) -> Vec3 { return turn * p; });
        std::ranges::move(sphere::barycentric_rows(finest, directions, options_.levels), std::back_inserter(rows_));
    }
}

void Examination::make_family() {
    for (std::size_t pose = 0; pose < turns_.size(); ++pose)
        for (unsigned level : options_.levels)
            for (std::size_t f = 0; f < evidence_->filters(); ++f)
                family_.push_back({evidence_->statistic(f, rows(pose, level), options_.rmax), level, pose, f});
}

double Examination::expected_sigmas(Sequences& sequences, unsigned level, double strength) const {
    const double move = strength / 100 * diagonal_;
    std::vector<double> sigmas(evidence_->filters());
    const std::span<const double> w = sequences(level);
    parallel_blocks(sigmas.size(), 1, [&](std::size_t f, std::size_t) {
        sigmas[f] = evidence_->expected_sigmas(f, rows(0, level), w, options_.rmax, move);
    });
    return *std::ranges::max_element(sigmas);
}

double Examination::gamma(Sequences& sequences, unsigned level, double strength) const {
    return evidence_->gamma(rows(0, level), sequences(level), strength / 100 * diagonal_);
}

std::vector<double> Examination::radii() const {
    std::vector<double> r(base_.positions.size());
    std::ranges::transform(base_.positions, r.begin(), [](const Vec3& p) { return p.norm(); });
    return r;
}

} // namespace wm3d::pipeline
