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

/// A triangle, its corners seen from an origin near the mesh, which keeps digits far from zero.
struct Corners {
    Vec3 a, b, c;

    Corners(const TriangleMesh& mesh, std::size_t f, const Vec3& origin)
        : a(mesh.positions[mesh.triangles[f][0]] - origin), b(mesh.positions[mesh.triangles[f][1]] - origin),
          c(mesh.positions[mesh.triangles[f][2]] - origin) {}

    Vec3 sum() const { return a + b + c; }
    /// Of the tetrahedron between the triangle and the origin, signed.
    double volume() const { return a.dot(b.cross(c)) / 6; }
};

/// Moments of order 0 and 1.
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
                                const double area = triangle_area(mesh, f);
                                sum.area += area;
                                sum.moment += area / 3 * Corners(mesh, f, origin).sum();
                            }
                            return sum;
                        });
}

/// A symmetric matrix.
struct Symmetric {
    Eigen::Array3d squares = Eigen::Array3d::Zero();  ///< xx, yy, zz
    Eigen::Array3d products = Eigen::Array3d::Zero(); ///< xy, yz, zx

    Symmetric& operator+=(const Symmetric& o) {
        squares += o.squares;
        products += o.products;
        return *this;
    }

    Mat3 matrix() const {
        Mat3 full = squares.matrix().asDiagonal();
        full(0, 1) = full(1, 0) = products[0];
        full(1, 2) = full(2, 1) = products[1];
        full(2, 0) = full(0, 2) = products[2];
        return full;
    }
};

/// Sum over the triangles of weight(corners, f) (s s^T + a a^T + b b^T + c c^T), s = a + b + c: the integral of p p^T over a
/// triangle with area/12 as its weight, and over the tetrahedron between it and the origin with volume/20.
template<typename Weight>
Mat3 second_moments(const TriangleMesh& mesh, const Vec3& origin, Weight&& weight) {
    const auto next = [](const Vec3& v) { return Eigen::Array3d(v.y(), v.z(), v.x()); };
    return parallel_sum(mesh.triangles.size(), block, Symmetric{},
                        [&](std::size_t begin, std::size_t end) {
                            Symmetric sum;
                            for (std::size_t f = begin; f < end; ++f) {
                                const Corners t(mesh, f, origin);
                                const Vec3 s = t.sum();
                                const double w = weight(t, f);
                                sum.squares += w * (s.array().square() + t.a.array().square() +
                                                    t.b.array().square() + t.c.array().square());
                                sum.products += w * (s.array() * next(s) + t.a.array() * next(t.a) +
                                                     t.b.array() * next(t.b) + t.c.array() * next(t.c));
                            }
                            return sum;
                        })
        .matrix();
}

Mat3 surface_second_moments(const TriangleMesh& mesh, const Vec3& origin) {
    return second_moments(mesh, origin,
                          [&](const Corners&, std::size_t f) { return triangle_area(mesh, f) / 12; });
}

Mat3 solid_second_moments(const TriangleMesh& mesh, const Vec3& apex) {
    return second_moments(mesh, apex, [](const Corners& t, std::size_t) { return t.volume() / 20; });
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
            const Corners t(mesh, f, origin);
            const Vec3 n = 0.5 * (t.b - t.a).cross(t.c - t.a), s = t.sum();
            const double volume = t.volume();
            sum.volume += volume;
            sum.area_vector += n;
            sum.moment += volume * s;
            sum.mixed += s * n.transpose();
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

/// Integral over a triangle of the distance from the origin, over its area: Radon's seven-point rule, exact for polynomials of
/// degree 5. The roots are taken together with that of `square`.
/// \param root  set to the root of `square`
double mean_distance(const Corners& t, double square, double& root) {
    static const double root15 = std::sqrt(15.0);
    static const double w0 = 0.225, w1 = (155 - root15) / 1200, w2 = (155 + root15) / 1200;
    static const double p1 = (6 - root15) / 21, p2 = (6 + root15) / 21;
    const Vec3 s = t.sum(), s1 = p1 * s, s2 = p2 * s;
    Eigen::Array<double, 8, 1> lengths;
    lengths << square, (s / 3).squaredNorm(), (s1 + (1 - 3 * p1) * t.a).squaredNorm(),
        (s2 + (1 - 3 * p2) * t.a).squaredNorm(), (s1 + (1 - 3 * p1) * t.b).squaredNorm(),
        (s2 + (1 - 3 * p2) * t.b).squaredNorm(), (s1 + (1 - 3 * p1) * t.c).squaredNorm(),
        (s2 + (1 - 3 * p2) * t.c).squaredNorm();
    lengths = lengths.sqrt();
    root = lengths[0];
    double mean = w0 * lengths[1];
    for (const int k : {2, 4, 6})
        mean = mean + w1 * lengths[k] + w2 * lengths[k + 1];
    return mean;
}

/// What the scale of a frame and the signs of its axes are taken from.
struct Outreach {
    double area = 0, radius = 0;                   ///< integrals of 1 and of the distance from the centre
    Eigen::Array2d cubes = Eigen::Array2d::Zero(); ///< of x^3 and y^3 along the first two axes

    Outreach& operator+=(const Outreach& o) {
        area += o.area;
        radius += o.radius;
        cubes += o.cubes;
        return *this;
    }
    double mean_radius() const { return area > 0 ? radius / area : 0; }
};

/// Integral of x^3 over a triangle, over its area, is a tenth of the sum of all products of degree 3 of the corners'
/// coordinates.
Eigen::Array2d tenfold_cubes(const Corners& t, const Eigen::Matrix<double, 2, 3>& axes) {
    const Eigen::Array2d a = axes * t.a, b = axes * t.b, c = axes * t.c;
    const Eigen::Array2d h2ab = a * a + a * b + b * b;
    return a * a * a + b * h2ab + c * (h2ab + c * (a + b) + c * c);
}

Outreach outreach(const TriangleMesh& mesh, const Vec3& centre, const Mat3& all_axes) {
    const Eigen::Matrix<double, 2, 3> axes = all_axes.topRows<2>();
    return parallel_sum(mesh.triangles.size(), block, Outreach{}, [&](std::size_t begin, std::size_t end) {
        Outreach sum;
        for (std::size_t f = begin; f < end; ++f) {
            const Corners t(mesh, f, centre);
            double double_area = 0;
            const double distance = mean_distance(t, area_vector(mesh, f).squaredNorm(), double_area);
            const double area = 0.5 * double_area;
            sum.area += area;
            sum.radius += area * distance;
            sum.cubes += area / 10 * tenfold_cubes(t, axes);
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
    moments.covariance = surface_second_moments(mesh, moments.centroid) / moments.area;
    return moments;
}

double mean_radius(const TriangleMesh& mesh, const Vec3& centre) {
    return outreach(mesh, centre, Mat3::Identity()).mean_radius();
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
    Mat3 axes = principal_axes(moments.covariance);
    const Outreach reach = outreach(mesh, frame.centroid, axes);
    frame.scale = reach.mean_radius();
    if (!(frame.scale > 0))
        throw GeometryError(
            "all points of the surface coincide, so the mesh has no shape to mark or to examine");
    for (int k : {0, 1})
        if (reach.cubes[k] < 0)
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
