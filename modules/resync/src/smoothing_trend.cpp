// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/resync/smoothing_trend.hpp>

#include <wm3d/core/error.hpp>
#include <wm3d/mesh/umbrella.hpp>
#include <wm3d/resync/similarity.hpp>

#include "nearest_signs.hpp"

namespace wm3d::resync {

namespace {

/// `frame` moved and turned on by `times` of what leads from `smoothed` to it.
Frame extrapolated(const Frame& frame, const Frame& smoothed, double times) {
    constexpr double most_turn =
        0.1; // more, in radians, is no trend: the axes of a shape that hardly has any
    const Eigen::AngleAxisd turn(Mat3(frame.axes * smoothed.axes.transpose()));
    Frame before = frame;
    if (turn.angle() < most_turn)
        before.axes = Eigen::AngleAxisd(times * turn.angle(), turn.axis()).toRotationMatrix() * frame.axes;
    before.centroid += times * (frame.centroid - smoothed.centroid);
    return before;
}

bool differ(const Frame& a, const Frame& b, const TrendOptions& options) {
    return angle_between(a.axes, b.axes) >= options.least_turn ||
           (a.centroid - b.centroid).norm() >= options.least_shift * a.scale;
}

} // namespace

std::vector<CandidatePose> frames_before_smoothing(const TriangleMesh& mesh, const Frame& frame,
                                                   Substance substance, const TrendOptions& options) {
    if (mesh.positions.size() > options.most_vertices)
        return {};
    TriangleMesh smooth = mesh;
    smooth.positions = Umbrella(mesh).smooth(mesh.positions, options.steps, options.weight);
    Frame smoothed = frame;
    try {
        const CentralMoments moments = central_moments(smooth, substance);
        smoothed = with_signs_of({moments.centroid, principal_axes(moments.covariance), frame.scale}, frame);
    } catch (const GeometryError&) {
        return {}; // nothing was left of a tiny mesh
    }
    std::vector<CandidatePose> candidates;
    for (double times : options.back) {
        const Frame before = extrapolated(frame, smoothed, times);
        if (differ(before, frame, options))
            candidates.push_back({before, "principal axes before smoothing", false});
    }
    return candidates;
}

} // namespace wm3d::resync
