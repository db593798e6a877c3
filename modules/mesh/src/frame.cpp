// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/frame.hpp>

#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>

namespace wm3d {

namespace {

constexpr std::size_t block = 16384;

// A mesh of less sphericity or more openness isn't taken for a solid. Attacks change them by factors of a
// few: noise of 0.5 % turns the 0.054 of a lattice into 0.015.
constexpr double least_sphericity = 0.003;
constexpr double most_openness = 0.1;
constexpr double doubt = 3; ///< factor by which an attack may have moved them

struct Corners {
    Vec3 a, b, c;
    double area;
};

Corners corners(const TriangleMesh& mesh, std::size_t f, const Vec3& origin) {
    const Triangle& t = mesh.triangles[f];
    return {mesh.positions[t[0]] - origin, mesh.positions[t[1]] - origin, mesh.positions[t[2]] - origin,
            0.5 * area_vector(mesh, f).norm()};
}

/// Moments of order 0 and 1; the origin is any point near the mesh, to keep digits far from zero.
struct FirstMoments {
    double area = 0;
    Vec3 moment = Vec3::Zero();
    FirstMoments& operator+=(const FirstMoments& o) {
        area += o.area;
        moment += o.moment;
        return *this;
    }
};

FirstMoments first_moments(const TriangleMesh& mesh, const Vec3& origin) {
    return parallel_sum(mesh.triangles.size(), block, FirstMoments{},
                        [&](std::size_t begin, std::size_t end) {
                            FirstMoments sum;
                            for (std::size_t f = begin; f < end; ++f) {
                                const Corners t = corners(mesh, f, origin);
                                sum.area += t.area;
                                sum.moment += t.area / 3 * (t.a + t.b + t.c);
                            }
                            return sum;
                        });
}

/// Integral of p p^T over the surface: on a triangle, area/12 (s s^T + a a^T + b b^T + c c^T), s = a + b + c.
Mat3 second_moments(const TriangleMesh& mesh, const Vec3& origin) {
    const Mat3 zero = Mat3::Zero();
    return parallel_sum(mesh.triangles.size(), block, zero, [&](std::size_t begin, std::size_t end) -> Mat3 {
        Mat3 sum = Mat3::Zero();
        for (std::size_t f = begin; f < end; ++f) {
            const Corners t = corners(mesh, f, origin);
            const Vec3 s = t.a + t.b + t.c;
            sum +=
                t.area / 12 *
                (s * s.transpose() + t.a * t.a.transpose() + t.b * t.b.transpose() + t.c * t.c.transpose());
        }
        return sum;
    });
}

struct Cone {
    Vec3 a, b, c;
    double volume; ///< of the tetrahedron between the triangle and the apex, signed
};

Cone cone(const TriangleMesh& mesh, std::size_t f, const Vec3& apex) {
    const Triangle& t = mesh.triangles[f];
    Cone result{mesh.positions[t[0]] - apex, mesh.positions[t[1]] - apex, mesh.positions[t[2]] - apex, 0};
    result.volume = result.a.dot(result.b.cross(result.c)) / 6;
    return result;
}

/// What the volume and the first moment about any apex follow from: sums over the triangles of the signed
/// volumes v under them, of the area vectors n, of v s and of s n^T, with s the sum of the corners.
struct ApexSums {
    double volume = 0;
    Vec3 area_vector = Vec3::Zero(), moment = Vec3::Zero();
    Mat3 mixed = Mat3::Zero();

    ApexSums& operator+=(const ApexSums& o) {
        volume += o.volume;
        area_vector += o.area_vector;
        moment += o.moment;
        mixed += o.mixed;
        return *this;
    }

    double volume_about(const Vec3& apex) const { return volume - apex.dot(area_vector) / 3; }

    Vec3 moment_about(const Vec3& apex) const {
        return (moment - mixed * apex / 3 - 3 * volume_about(apex) * apex) / 4;
    }
};

ApexSums apex_sums(const TriangleMesh& mesh, const Vec3& origin) {
    return parallel_sum(mesh.triangles.size(), block, ApexSums{}, [&](std::size_t begin, std::size_t end) {
        ApexSums sum;
        for (std::size_t f = begin; f < end; ++f) {
            const Cone t = cone(mesh, f, origin);
            const Vec3 n = 0.5 * (t.b - t.a).cross(t.c - t.a), s = t.a + t.b + t.c;
            sum += {t.volume, n, t.volume * s, s * n.transpose()};
        }
        return sum;
    });
}

/// Integral of p p^T over the tetrahedra between the triangles and the apex.
Mat3 solid_second_moments(const TriangleMesh& mesh, const Vec3& apex) {
    const Mat3 zero = Mat3::Zero();
    return parallel_sum(mesh.triangles.size(), block, zero, [&](std::size_t begin, std::size_t end) -> Mat3 {
        Mat3 sum = Mat3::Zero();
        for (std::size_t f = begin; f < end; ++f) {
            const Cone t = cone(mesh, f, apex);
            const Vec3 s = t.a + t.b + t.c;
            sum +=
                t.volume / 20 *
                (s * s.transpose() + t.a * t.a.transpose() + t.b * t.b.transpose() + t.c * t.c.transpose());
        }
        return sum;
    });
}

/// The apex that is the centroid of what the surface and the cone over its openings enclose; none without
/// volume.
std::optional<Vec3> own_apex(const ApexSums& sums, double size) {
    Vec3 apex = Vec3::Zero();
    // The apex of a closed surface makes no difference, so one step ends it; small holes take a few.
    constexpr int most_steps = 30;
    for (int step = 0; step < most_steps; ++step) {
        const Vec3 move = sums.moment_about(apex) / sums.volume_about(apex);
        if (!move.allFinite() || move.norm() > size)
            return std::nullopt;
        apex += move;
        if (move.norm() < 1e-12 * size)
            break;
    }
    return apex;
}

bool is_solid(const SolidMoments& moments, double margin) {
    return moments.sphericity > margin * least_sphericity && moments.openness * margin < most_openness;
}

/// Integral of x^3 over the surface for each axis: on a triangle, area/10 times the sum of all products
/// of degree 3 of the corners' coordinates.
Vec3 third_moments(const TriangleMesh& mesh, const Vec3& origin, const Mat3& axes) {
    const Vec3 zero = Vec3::Zero();
    return parallel_sum(mesh.triangles.size(), block, zero, [&](std::size_t begin, std::size_t end) -> Vec3 {
        Vec3 sum = Vec3::Zero();
        for (std::size_t f = begin; f < end; ++f) {
            const Corners t = corners(mesh, f, origin);
            const Eigen::Array3d a = (axes * t.a).array(), b = (axes * t.b).array(), c = (axes * t.c).array();
            // complete homogeneous polynomial h3(a, b, c)
            const Eigen::Array3d h2ab = a * a + a * b + b * b;
            const Eigen::Array3d h3 = a * a * a + b * h2ab + c * (h2ab + c * (a + b) + c * c);
            sum += t.area / 10 * h3.matrix();
        }
        return sum;
    });
}

/// Sixth powers of lengths have to stay within the range of double.
void require_usual_size(const Box& box) {
    constexpr double least = 1e-50, most = 1e50;
    const double extent = (box.max - box.min).maxCoeff();
    if (extent > 0 && !(extent >= least && extent <= most))
        throw GeometryError(
            fmt::format("the mesh is {:.0e} units large, but lengths have to lie between {:.0e} and {:.0e}, "
                        "or their powers "
                        "leave the range of double precision; scale the model to a usual unit first",
                        extent, least, most));
}

} // namespace

namespace {

/// Area and centroid: the covariance is left out.
SurfaceMoments first_surface_moments(const TriangleMesh& mesh) {
    const Box box = surface_box(mesh);
    require_usual_size(box);
    const Vec3 origin = 0.5 * (box.min + box.max);
    const FirstMoments first = first_moments(mesh, origin);
    if (!(first.area > 0))
        throw GeometryError(
            "the mesh has no surface area: all its triangles are degenerate, so there is nothing "
            "to mark or to examine; check that the file holds the model that you mean");
    SurfaceMoments moments;
    moments.area = first.area;
    moments.centroid = origin + first.moment / first.area;
    return moments;
}

SolidMoments solid_within(const TriangleMesh& mesh, const SurfaceMoments& surface) {
    const double area = surface.area;
    const Vec3 origin = surface.centroid;
    const ApexSums sums = apex_sums(mesh, origin);
    SolidMoments solid;
    solid.openness = sums.area_vector.norm() / area;
    const std::optional<Vec3> apex = own_apex(sums, std::sqrt(area));
    if (!apex)
        return solid;
    solid.volume = sums.volume_about(*apex);
    solid.centroid = origin + *apex;
    solid.covariance = solid_second_moments(mesh, solid.centroid) / solid.volume;
    solid.sphericity = 36 * std::numbers::pi * solid.volume * solid.volume / (area * area * area);
    return solid;
}

} // namespace

SurfaceMoments surface_moments(const TriangleMesh& mesh) {
    SurfaceMoments moments = first_surface_moments(mesh);
    moments.covariance = second_moments(mesh, moments.centroid) / moments.area;
    return moments;
}

double mean_radius(const TriangleMesh& mesh, const Vec3& centre) {
    // Radon's seven-point rule, exact for polynomials of degree 5.
    static const double root15 = std::sqrt(15.0);
    const double w0 = 0.225, w1 = (155 - root15) / 1200, w2 = (155 + root15) / 1200;
    const double p1 = (6 - root15) / 21, p2 = (6 + root15) / 21;
    double area = 0;
    const double sum =
        parallel_sum(mesh.triangles.size(), block, 0.0, [&](std::size_t begin, std::size_t end) {
            double s = 0;
            for (std::size_t f = begin; f < end; ++f) {
                const Corners t = corners(mesh, f, centre);
                const Vec3 total = t.a + t.b + t.c;
                double radius = w0 * (total / 3).norm();
                for (const Vec3* corner : {&t.a, &t.b, &t.c}) {
                    radius += w1 * (p1 * total + (1 - 3 * p1) * *corner).norm();
                    radius += w2 * (p2 * total + (1 - 3 * p2) * *corner).norm();
                }
                s += t.area * radius;
            }
            return s;
        });
    area = surface_area(mesh);
    return area > 0 ? sum / area : 0;
}

SolidMoments solid_moments(const TriangleMesh& mesh) {
    return solid_within(mesh, first_surface_moments(mesh));
}

ShapeMoments shape_moments(const TriangleMesh& mesh) {
    const SurfaceMoments surface = surface_moments(mesh);
    return {surface, solid_within(mesh, surface)};
}

CentralMoments central_moments(const TriangleMesh& mesh, Substance substance) {
    if (substance == Substance::surface)
        return ShapeMoments{surface_moments(mesh), {}}.of(substance);
    return ShapeMoments{{}, solid_moments(mesh)}.of(substance);
}

Substance ShapeMoments::substance() const {
    return is_solid(solid, 1) ? Substance::solid : Substance::surface;
}

std::vector<Substance> ShapeMoments::possible_substances() const {
    const bool perhaps = is_solid(solid, 1 / doubt), surely = is_solid(solid, doubt);
    if (perhaps == surely)
        return {substance()};
    return substance() == Substance::solid ? std::vector{Substance::solid, Substance::surface}
                                           : std::vector{Substance::surface, Substance::solid};
}

CentralMoments ShapeMoments::of(Substance substance) const {
    if (substance == Substance::solid)
        return {solid.centroid, solid.covariance};
    return {surface.centroid, surface.covariance};
}

Mat3 principal_axes(const Mat3& covariance) {
    const Eigen::SelfAdjointEigenSolver<Mat3> eigen(covariance); // ascending
    Mat3 axes;
    axes.row(0) = eigen.eigenvectors().col(2).transpose();
    axes.row(1) = eigen.eigenvectors().col(1).transpose();
    axes.row(2) = axes.row(0).cross(axes.row(1));
    return axes;
}

Frame principal_frame(const TriangleMesh& mesh, const CentralMoments& moments) {
    Frame frame;
    frame.centroid = moments.centroid;
    frame.scale = mean_radius(mesh, frame.centroid);
    if (!(frame.scale > 0))
        throw GeometryError(
            "all points of the surface coincide, so the mesh has no shape to mark or to examine");

    Mat3 axes = principal_axes(moments.covariance);
    const Vec3 skew = third_moments(mesh, frame.centroid, axes);
    for (int k : {0, 1})
        if (skew[k] < 0)
            axes.row(k) = -axes.row(k);
    axes.row(2) = axes.row(0).cross(axes.row(1));
    frame.axes = axes;
    return frame;
}

Frame canonical_frame(const TriangleMesh& mesh) {
    return principal_frame(mesh, shape_moments(mesh).own());
}

Frame canonical_frame(const TriangleMesh& mesh, Substance substance) {
    return principal_frame(mesh, central_moments(mesh, substance));
}

std::array<Frame, 4> sign_choices(const Frame& frame) {
    std::array<Frame, 4> choices{frame, frame, frame, frame};
    for (int turn = 1; turn < 4; ++turn)
        for (int k = 0; k < 3; ++k)
            if (k != turn - 1)
                choices[turn].axes.row(k) = -frame.axes.row(k);
    return choices;
}

TriangleMesh to_frame(const TriangleMesh& mesh, const Frame& frame) {
    TriangleMesh moved = mesh;
    parallel_blocks(moved.positions.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            moved.positions[v] = frame.to_canonical(moved.positions[v]);
    });
    return moved;
}

} // namespace wm3d
