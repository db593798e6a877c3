// SPDX-License-Identifier: GPL-3.0-or-later
// This work is based on the proposal of section 4 of the paper: principal components over a hierarchy of
// levels.
#include <wm3d/resync/hierarchical_frame.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include <wm3d/resync/similarity.hpp>
#include <wm3d/simplify/simplify.hpp>

#include "nearest_signs.hpp"

namespace wm3d::resync {

namespace {

constexpr double degrees = 57.29577951308232;
constexpr double widest = 45; // a turn by more is a neighbouring quarter turn's business

/// The rotation that is nearest to the element-wise median of rotations.
Mat3 median_rotation(const std::vector<LevelFrame>& levels) {
    Mat3 median;
    for (int k = 0; k < 9; ++k) {
        std::vector<double> values;
        for (const LevelFrame& level : levels)
            values.push_back(level.axes(k));
        std::ranges::sort(values);
        const std::size_t middle = values.size() / 2;
        median(k) = values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
    }
    const Eigen::JacobiSVD<Mat3> svd(median, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return svd.matrixU() * svd.matrixV().transpose();
}

double relative_gap(const Vec3& moments, int i, int j) {
    return std::abs(moments[i] - moments[j]) / std::max(moments[i], moments[j]);
}

/// Descending.
Vec3 eigenvalues(const Mat3& covariance) {
    return Eigen::SelfAdjointEigenSolver<Mat3>(covariance, Eigen::EigenvaluesOnly).eigenvalues().reverse();
}

/// Turn about axis k that a relative change of the moments can cause, in degrees: perturbation over
/// eigenvalue gap.
double turn_about(const Vec3& moments, int k, double change) {
    const double gap = relative_gap(moments, (k + 1) % 3, (k + 2) % 3);
    return gap > 0 ? std::min(widest, degrees * change / gap) : widest;
}

LevelFrame level_of(const Hierarchy::Level& coarser, const FrameEstimate& estimate,
                    const Mat3& finest_covariance) {
    LevelFrame level;
    level.vertices = coarser.mesh.positions.size();
    const CentralMoments moments = coarser.moments.of(estimate.substance);
    const Mat3& covariance = moments.covariance;
    level.axes = with_signs_of({moments.centroid, principal_axes(covariance), 1}, estimate.finest).axes;
    level.change = (covariance / covariance.trace() - finest_covariance / finest_covariance.trace()).norm();
    return level;
}

Frame turned(const Frame& frame, int axis, double angle) {
    Frame result = frame;
    result.axes = Eigen::AngleAxisd(angle / degrees, Vec3::Unit(axis)).toRotationMatrix() * frame.axes;
    return result;
}

/// Frames without their sign choices, the most likely first, none twice.
class FrameList {
public:
    FrameList(std::size_t most, double step) : most_(most), step_(step) {}

    /// False once the list is full.
    bool add(const Frame& frame, const std::string& origin) {
        for (const CandidatePose& known : frames_)
            for (const Frame& choice : sign_choices(known.frame))
                if (angle_between(choice.axes, frame.axes) < 0.3 * step_)
                    return true;
        if (frames_.size() < most_)
            frames_.push_back({frame, origin, frames_.empty()});
        return frames_.size() < most_;
    }

    const std::vector<CandidatePose>& frames() const { return frames_; }

private:
    std::size_t most_;
    double step_;
    std::vector<CandidatePose> frames_;
};

/// Turns about one axis, from the centre outwards, as wide as the uncertainty.
void add_turns(FrameList& list, const FrameEstimate& estimate, int axis, double step) {
    const double reach = estimate.uncertainty[axis];
    for (double angle = step; angle <= reach; angle += step)
        for (double signed_angle : {angle, -angle})
            if (!list.add(turned(estimate.finest, axis, signed_angle), "turn about a principal axis"))
                return;
}

} // namespace

double least_gap(const Vec3& moments) {
    return std::min(relative_gap(moments, 0, 1), relative_gap(moments, 1, 2));
}

Frame with_signs_of(const Frame& frame, const Frame& like) {
    const std::array<Frame, 4> choices = sign_choices(frame);
    return *std::ranges::min_element(
        choices, {}, [&](const Frame& choice) { return angle_between(choice.axes, like.axes); });
}

Ambiguity ambiguity_of(const CentralMoments& moments, double ambiguous_gap) {
    const Vec3 values = eigenvalues(moments.covariance);
    const int equal =
        (relative_gap(values, 0, 1) < ambiguous_gap) + (relative_gap(values, 1, 2) < ambiguous_gap);
    return equal == 2 ? Ambiguity::all : equal == 1 ? Ambiguity::plane : Ambiguity::none;
}

std::string_view describe(Ambiguity ambiguity) {
    switch (ambiguity) {
    case Ambiguity::none:
        return "its surface has three clear principal axes";
    case Ambiguity::plane:
        return "two of its principal moments are equal, as on a vase of revolution, so its surface doesn't "
               "tell how "
               "it is turned about one axis";
    case Ambiguity::all:
        return "its three principal moments are equal, as on a sphere or a cube, so its surface doesn't tell "
               "how it "
               "is turned";
    }
    return "";
}

Hierarchy make_hierarchy(const TriangleMesh& mesh, const TriangleMesh& base, const HierarchyOptions& options,
                         const Progress& progress) {
    return make_hierarchy(shape_moments(mesh), mesh, base, options, progress);
}

Hierarchy make_hierarchy(const ShapeMoments& moments, const TriangleMesh& mesh, const TriangleMesh& base,
                         const HierarchyOptions& options, const Progress& progress) {
    Hierarchy hierarchy{moments, {}};
    const auto add = [&](TriangleMesh level) {
        ShapeMoments of_level = shape_moments(level);
        hierarchy.coarser.push_back({std::move(level), std::move(of_level)});
    };
    if (base.positions.size() < mesh.positions.size())
        add(base);
    for (std::size_t vertices : options.levels) {
        const TriangleMesh& finer = hierarchy.coarser.empty() ? base : hierarchy.coarser.back().mesh;
        if (vertices >= finer.positions.size())
            continue;
        simplify::Options simplification;
        simplification.target_vertices = vertices;
        add(simplify::simplify(finer, simplification, progress).mesh);
    }
    return hierarchy;
}

FrameEstimate estimate_frame(const TriangleMesh& mesh, const TriangleMesh& base,
                             const HierarchyOptions& options, const Progress& progress) {
    const Hierarchy hierarchy = make_hierarchy(mesh, base, options, progress);
    return estimate_frame(mesh, hierarchy, hierarchy.moments.substance(), options);
}

FrameEstimate estimate_frame(const TriangleMesh& mesh, const Hierarchy& hierarchy, Substance substance,
                             const HierarchyOptions& options) {
    return estimate_frame(principal_frame(mesh, hierarchy.moments.of(substance)), mesh.positions.size(),
                          hierarchy, substance, options);
}

FrameEstimate estimate_frame(const Frame& finest, std::size_t vertices, const Hierarchy& hierarchy,
                             Substance substance, const HierarchyOptions& options) {
    FrameEstimate estimate;
    estimate.substance = substance;
    estimate.finest = finest;
    const Mat3 covariance = hierarchy.moments.of(substance).covariance;
    estimate.moments = eigenvalues(covariance) / (estimate.finest.scale * estimate.finest.scale);
    estimate.levels.push_back({vertices, estimate.finest.axes, 0});
    for (const Hierarchy::Level& level : hierarchy.coarser)
        estimate.levels.push_back(level_of(level, estimate, covariance));

    estimate.robust = estimate.finest;
    estimate.robust.axes = median_rotation(estimate.levels);
    // What one step of the hierarchy changed is of the size of what an attack of that coarseness changes.
    const double change = estimate.levels.size() > 1 ? estimate.levels[1].change : 0;
    for (int k = 0; k < 3; ++k)
        estimate.uncertainty[k] = turn_about(estimate.moments, k, std::max(change, options.least_change));
    estimate.ambiguity = ambiguity_of(hierarchy.moments.of(substance), options.ambiguous_gap);
    return estimate;
}

std::vector<CandidatePose> candidate_poses(const FrameEstimate& estimate, const CandidateOptions& options) {
    FrameList list(options.most, options.step);
    list.add(estimate.finest, "principal axes");
    list.add(estimate.robust, "principal axes, median of the levels");
    for (int k = 0; k < 3; ++k)
        if (estimate.uncertainty[k] >= widest)
            list.add(turned(estimate.finest, k, 90), "principal axes, two exchanged");
    for (int k = 0; k < 3; ++k)
        add_turns(list, estimate, k, options.step);
    std::vector<CandidatePose> poses;
    for (const CandidatePose& candidate : list.frames())
        for (const Frame& choice : sign_choices(candidate.frame))
            poses.push_back({choice, candidate.origin, candidate.likely});
    return poses;
}

} // namespace wm3d::resync
