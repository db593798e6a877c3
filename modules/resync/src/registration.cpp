// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/resync/registration.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>

#include "icp.hpp"

namespace wm3d::resync {

bool has_registration() {
    return true;
}

namespace {

/// Points about their mean, in units of their mean distance from it, and their principal axes.
struct Unit {
    Similarity to_unit;
    Mat3 axes; ///< rows, from largest to smallest; right-handed
};

Unit unit_of(const PoseTemplate& points) {
    const auto count = static_cast<double>(points.points.size());
    Vec3 centre = Vec3::Zero();
    for (const Vec3& p : points.points)
        centre += p / count;
    double radius = 0;
    Mat3 covariance = Mat3::Zero();
    for (const Vec3& p : points.points) {
        radius += (p - centre).norm() / count;
        covariance += (p - centre) * (p - centre).transpose() / count;
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> eigen(covariance);
    Unit unit;
    unit.to_unit = {Mat3::Identity(), 1 / radius, -centre / radius};
    unit.axes.row(0) = eigen.eigenvectors().col(2).transpose();
    unit.axes.row(1) = eigen.eigenvectors().col(1).transpose();
    unit.axes.row(2) = unit.axes.row(0).cross(unit.axes.row(1));
    return unit;
}

std::vector<Similarity> axis_starts(const Unit& whole, const Unit& part) {
    std::vector<Similarity> starts;
    for (const Frame& choice : sign_choices({Vec3::Zero(), part.axes, 1}))
        starts.push_back({whole.axes.transpose() * choice.axes, 1, Vec3::Zero()});
    return starts;
}

/// Whether normals point inwards on the whole: files of inside-out triangles are common, and a mirror image
/// may have kept the order of its corners.
bool inside_out(const PoseTemplate& unit_points) {
    double flux = 0;
    for (std::size_t i = 0; i < unit_points.points.size(); ++i)
        flux += unit_points.points[i].dot(unit_points.normals[i]);
    return flux < 0;
}

TriangleMesh outward(TriangleMesh mesh, const PoseTemplate& unit_points) {
    if (inside_out(unit_points))
        for (Triangle& t : mesh.triangles)
            std::swap(t[1], t[2]);
    return mesh;
}

PoseTemplate outward(PoseTemplate unit_points) {
    if (inside_out(unit_points))
        for (Vec3& n : unit_points.normals)
            n = -n;
    return unit_points;
}

/// The suspect in units of its own mean radius.
class Part {
public:
    Part(const TriangleMesh& suspect, std::size_t points)
        : unit_(unit_of(make_template(suspect, points))), mesh_(in_unit(suspect, points)),
          points_(make_template(mesh_, points)), index_(points_), surface_(mesh_) {}

    const Unit& unit() const { return unit_; }
    const PoseTemplate& points() const { return points_; }
    const PointIndex& index() const { return index_; }
    const ContactSurface& surface() const { return surface_; }

private:
    TriangleMesh in_unit(const TriangleMesh& suspect, std::size_t points) const {
        TriangleMesh mesh = suspect;
        for (Vec3& p : mesh.positions)
            p = unit_.to_unit(p);
        const PoseTemplate sampled = make_template(mesh, points);
        return outward(std::move(mesh), sampled);
    }

    Unit unit_;
    TriangleMesh mesh_;
    PoseTemplate points_;
    PointIndex index_;
    ContactSurface surface_;
};

struct Attempt {
    Similarity pose; ///< part -> whole
    double coverage = 0;
};

double coverage(const PointIndex& whole, const PoseTemplate& part, const Similarity& pose,
                const RegistrationOptions& options) {
    if (pose.scale < 0.8 * options.least_scale)
        return 0;
    std::size_t on_it = 0;
    for (std::size_t i = 0; i < part.points.size(); ++i) {
        const Vec3 p = pose(part.points[i]);
        const std::size_t near = whole.nearest(p);
        const Vec3 away = p - whole.points().points[near];
        const Vec3& normal = whole.points().normals[near];
        on_it += std::abs(normal.dot(away)) < options.tolerance && away.norm() < 0.2 &&
                 normal.dot(pose.rotation * part.normals[i]) > 0.6;
    }
    return static_cast<double>(on_it) / static_cast<double>(part.points.size());
}

void refine_all(std::vector<Attempt>& attempts, const std::vector<Similarity>& starts,
                const PointIndex& whole, const Part& part, const RegistrationOptions& options) {
    constexpr std::size_t points = 250;
    const std::size_t stride = std::max<std::size_t>(1, part.points().points.size() / points);
    const std::size_t before = attempts.size();
    attempts.resize(before + starts.size());
    parallel_blocks(starts.size(), 1, [&](std::size_t k, std::size_t) {
        Attempt& attempt = attempts[before + k];
        attempt.pose = refine_on_points(whole, part.points(), starts[k], stride);
        attempt.coverage = coverage(whole, part.points(), attempt.pose, options);
    });
    std::ranges::stable_sort(attempts, std::ranges::greater{}, &Attempt::coverage);
}

/// Best coverage of a pose that is clearly another one.
double rival_coverage(const std::vector<Attempt>& attempts) {
    constexpr double another = 10; // degrees
    for (const Attempt& attempt : attempts)
        if (angle_between(attempt.pose.rotation, attempts.front().pose.rotation) > another)
            return attempt.coverage;
    return 0;
}

Registration register_proper(const PoseTemplate& original, const Part& part,
                             const RegistrationOptions& options) {
    const Unit unit = unit_of(original);
    const PoseTemplate whole = outward(moved(original, unit.to_unit));
    const PointIndex index(whole);

    Registration result;
    std::vector<Attempt> attempts;
    refine_all(attempts, axis_starts({{}, unit.axes}, {{}, part.unit().axes}), index, part, options);
    if (attempts.front().coverage < options.sure_coverage) {
        result.searched = true;
        PairOptions pairs;
        pairs.least_scale = options.least_scale;
        refine_all(attempts, pair_starts(index, part.index(), pairs), index, part, options);
    }
    result.starts = attempts.size();
    const SurfaceFit fit =
        refine_on_surface(whole, part.surface(), attempts.front().pose.inverse(), options.iterations);
    result.coverage = coverage(index, part.points(), fit.pose.inverse(), options);
    result.confidence = std::max(0.0, result.coverage - rival_coverage(attempts));
    result.residual = fit.residual / fit.pose.scale; // in the whole's units
    result.transform = part.unit().to_unit.inverse() * fit.pose * unit.to_unit;
    result.aligned = result.coverage >= options.least_coverage;
    return result;
}

} // namespace

Registration register_template(const PoseTemplate& pose_template, const TriangleMesh& suspect,
                               const RegistrationOptions& options, const Progress& progress) {
    if (pose_template.points.empty())
        throw ParameterError("the pose template holds no point, so nothing can be aligned with it");
    notify(progress, "aligning", 0);
    const Part part(suspect, options.suspect_points);
    Registration result = register_proper(pose_template, part, options);
    if (!result.aligned && options.try_mirrored) {
        notify(progress, "aligning", 0.5);
        const Similarity mirror{Vec3(-1, 1, 1).asDiagonal().toDenseMatrix(), 1, Vec3::Zero()};
        Registration mirrored = register_proper(moved(pose_template, mirror), part, options);
        mirrored.transform = mirrored.transform * mirror;
        if (mirrored.aligned)
            result = mirrored;
    }
    notify(progress, "aligning", 1);
    return result;
}

} // namespace wm3d::resync
