// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/metrics/msdm2.hpp>

#include <algorithm>
#include <cmath>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>

#include "curvature.hpp"
#include "vertex_adjacency.hpp"

namespace wm3d::metrics {

namespace {

/// Weighted moments of C and C^ in one window.
struct Window {
    double mu = 0, mu_hat = 0, sigma = 0, sigma_hat = 0, sigma_c = 0;
};

Window window_at(const TriangleMesh& mesh, BallWalk& walk, Index vertex, double h, double deviation,
                 const std::vector<double>& c, const std::vector<double>& c_hat) {
    const auto members = walk.gather(vertex, h);
    const auto weight = [&](Index q) {
        return std::exp(-(mesh.positions[q] - mesh.positions[vertex]).squaredNorm() /
                        (2 * deviation * deviation));
    };
    Window window;
    double total = 0;
    for (Index q : members) {
        const double w = weight(q);
        total += w;
        window.mu += w * c[q];
        window.mu_hat += w * c_hat[q];
    }
    window.mu /= total;
    window.mu_hat /= total;
    double squares = 0, squares_hat = 0;
    for (Index q : members) {
        const double w = weight(q) / total;
        const double x = c[q] - window.mu, y = c_hat[q] - window.mu_hat;
        squares += w * x * x;
        squares_hat += w * y * y;
        window.sigma_c += w * x * y;
    }
    window.sigma = std::sqrt(squares);
    window.sigma_hat = std::sqrt(squares_hat);
    return window;
}

double local_distance(const Window& w, const Msdm2Options& o) {
    const double luminance = std::abs(w.mu - w.mu_hat) / (std::max(w.mu, w.mu_hat) + o.stabilizer);
    const double contrast = std::abs(w.sigma - w.sigma_hat) / (std::max(w.sigma, w.sigma_hat) + o.stabilizer);
    const double product = w.sigma * w.sigma_hat;
    const double structure = std::abs(product - w.sigma_c) / (product + o.stabilizer);
    return (o.weight_luminance * luminance + o.weight_contrast * contrast + o.weight_structure * structure) /
           (o.weight_luminance + o.weight_contrast + o.weight_structure);
}

std::vector<SurfacePoint> closest_points(const TriangleMesh& mesh, const SurfaceTree& reference) {
    std::vector<SurfacePoint> points(mesh.positions.size());
    parallel_blocks(points.size(), 512, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            points[v] = reference.closest(mesh.positions[v]).at;
    });
    return points;
}

/// Values at the corners of the reference, interpolated at each point.
std::vector<double> interpolate(const std::vector<double>& values, const TriangleMesh& mesh,
                                const std::vector<SurfacePoint>& points) {
    std::vector<double> result;
    result.reserve(points.size());
    for (const SurfacePoint& p : points) {
        const Triangle& t = mesh.triangles[p.triangle];
        result.push_back(p.barycentric.dot(Vec3(values[t[0]], values[t[1]], values[t[2]])));
    }
    return result;
}

/// C at every vertex: free of scale by the longest side of the box.
std::vector<double> scaled_curvature(const TriangleMesh& mesh, const VertexAdjacency& adjacency,
                                     double radius, double side) {
    std::vector<double> c = curvature_magnitude(mesh, adjacency, radius);
    for (double& value : c)
        value *= side;
    return c;
}

double minkowski_mean(const TriangleMesh& mesh, const std::vector<double>& field, double exponent) {
    const std::vector<double> areas = vertex_areas(mesh);
    double sum = 0, total = 0;
    for (std::size_t v = 0; v < field.size(); ++v) {
        sum += areas[v] * std::pow(field[v], exponent);
        total += areas[v];
    }
    return std::pow(sum / total, 1 / exponent);
}

} // namespace

std::vector<double> msdm2_field(const TriangleMesh& distorted, const SurfaceTree& reference,
                                const Msdm2Options& options) {
    const TriangleMesh& original = reference.mesh();
    const Box box = surface_box(original);
    const double side = (box.max - box.min).maxCoeff();
    const VertexAdjacency around(distorted), around_original(original);
    const std::vector<SurfacePoint> matches = closest_points(distorted, reference);

    std::vector<double> field(distorted.positions.size(), 0.0);
    for (double scale : options.scales) {
        const double h = scale * side, radius = options.curvature_ratio * h;
        const std::vector<double> c = scaled_curvature(distorted, around, radius, side);
        const std::vector<double> c_hat =
            interpolate(scaled_curvature(original, around_original, radius, side), original, matches);
        parallel_blocks(field.size(), 16384, [&](std::size_t begin, std::size_t end) {
            BallWalk walk(distorted, around);
            for (std::size_t v = begin; v < end; ++v) {
                const Window window =
                    window_at(distorted, walk, static_cast<Index>(v), h, options.spread * h, c, c_hat);
                field[v] += local_distance(window, options) / static_cast<double>(options.scales.size());
            }
        });
    }
    return field;
}

double msdm2(const SurfaceTree& a, const SurfaceTree& b, const Msdm2Options& options) {
    const double forward = minkowski_mean(b.mesh(), msdm2_field(b.mesh(), a, options), options.exponent);
    const double backward = minkowski_mean(a.mesh(), msdm2_field(a.mesh(), b, options), options.exponent);
    return (forward + backward) / 2;
}

} // namespace wm3d::metrics
