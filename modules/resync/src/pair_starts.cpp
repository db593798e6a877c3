// SPDX-License-Identifier: GPL-3.0-or-later
#include "pair_starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <wm3d/core/parallel.hpp>

namespace wm3d::resync {

namespace {

constexpr int angle_cells = 12, dihedral_cells = 24; // of 15 degrees
constexpr std::size_t cells = angle_cells * angle_cells * dihedral_cells;

/// Two oriented points: a frame of their own, their distance, and the cell of their three angles.
struct Pair {
    Vec3 middle;
    Mat3 axes; ///< columns: along the line, the normals' mean part across it, and the third
    double length = 0;
    std::size_t cell = 0;
};

std::size_t cell_of(double angle, double range, int count) {
    return static_cast<std::size_t>(std::clamp(static_cast<int>(angle / range * count), 0, count - 1));
}

/// None where the pair has no frame of its own or its angles are unsteady.
std::optional<Pair> make_pair(const Vec3& p, const Vec3& n, const Vec3& q, const Vec3& m) {
    constexpr double least_sine = 0.3;
    const double length = (q - p).norm();
    if (!(length > 0))
        return std::nullopt;
    const Vec3 along = (q - p) / length;
    const Vec3 n_across = n - n.dot(along) * along, m_across = m - m.dot(along) * along;
    const Vec3 across = n_across.normalized() + m_across.normalized();
    if (n_across.norm() < least_sine || m_across.norm() < least_sine || across.norm() < least_sine)
        return std::nullopt;
    Pair pair;
    pair.middle = 0.5 * (p + q);
    pair.length = length;
    pair.axes.col(0) = along;
    pair.axes.col(1) = across.normalized();
    pair.axes.col(2) = pair.axes.col(0).cross(pair.axes.col(1));
    const double dihedral = std::atan2(along.dot(n_across.cross(m_across)), n_across.dot(m_across));
    const std::size_t a = cell_of(std::acos(std::clamp(n.dot(along), -1.0, 1.0)), EIGEN_PI, angle_cells);
    const std::size_t b = cell_of(std::acos(std::clamp(m.dot(along), -1.0, 1.0)), EIGEN_PI, angle_cells);
    const std::size_t c = cell_of(dihedral + EIGEN_PI, 2 * EIGEN_PI, dihedral_cells);
    pair.cell = (a * angle_cells + b) * dihedral_cells + c;
    return pair;
}

/// All ordered pairs of about `count` of the points, between the given distances.
std::vector<Pair> make_pairs(const PointIndex& index, std::size_t count, double least, double most) {
    const std::vector<Vec3>& points = index.points().points;
    const std::vector<Vec3> normals = index.blended_normals(9);
    const std::size_t stride = std::max<std::size_t>(1, points.size() / count);
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < points.size(); i += stride)
        for (std::size_t j = 0; j < points.size(); j += stride) {
            const double length = (points[i] - points[j]).norm();
            if (length < least || length > most)
                continue;
            if (const auto pair = make_pair(points[i], normals[i], points[j], normals[j]))
                pairs.push_back(*pair);
        }
    return pairs;
}

/// Numbers of the pairs in each cell.
std::vector<std::vector<Index>> by_cell(const std::vector<Pair>& pairs) {
    std::vector<std::vector<Index>> table(cells);
    for (Index k = 0; k < pairs.size(); ++k)
        table[pairs[k].cell].push_back(k);
    return table;
}

Similarity from_to(const Pair& part, const Pair& whole) {
    Similarity t;
    t.rotation = whole.axes * part.axes.transpose();
    t.scale = whole.length / part.length;
    t.translation = whole.middle - t.scale * (t.rotation * part.middle);
    return t;
}

/// Poses that pairs of the same cell suggest. Pairs of rare cells say most, so they come first.
std::vector<Similarity> suggestions(const std::vector<Pair>& whole, const std::vector<Pair>& part,
                                    const PairOptions& options) {
    const std::vector<std::vector<Index>> of_whole = by_cell(whole);
    std::vector<Index> order;
    for (Index k = 0; k < part.size(); ++k)
        if (!of_whole[part[k].cell].empty())
            order.push_back(k);
    std::ranges::stable_sort(order, {}, [&](Index k) { return of_whole[part[k].cell].size(); });
    // One in so many: the rarest cells alone would be noise.
    const std::size_t stride = std::max<std::size_t>(1, order.size() / 1200);
    std::vector<Similarity> poses;
    for (std::size_t k = 0; k < order.size() && poses.size() < options.hypotheses; k += stride)
        for (Index w : of_whole[part[order[k]].cell]) {
            const Similarity pose = from_to(part[order[k]], whole[w]);
            if (pose.scale >= options.least_scale && pose.scale <= options.most_scale)
                poses.push_back(pose);
        }
    return poses;
}

bool alike(const Similarity& a, const Similarity& b) {
    return angle_between(a.rotation, b.rotation) < 8 && std::abs(std::log(a.scale / b.scale)) < 0.08 &&
           (a.translation - b.translation).norm() < 0.1;
}

struct Scored {
    Similarity pose;
    double score = 0;
};

/// Scores in parallel and leaves the best, in their order.
void keep_best(std::vector<Scored>& scored, std::size_t count, const PointIndex& whole,
               const PoseTemplate& part, double tolerance, std::size_t stride) {
    parallel_blocks(scored.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            scored[k].score = explained(whole, part, scored[k].pose, tolerance, stride);
    });
    std::ranges::stable_sort(scored, std::ranges::greater{}, &Scored::score);
    scored.resize(std::min(count, scored.size()));
}

} // namespace

double explained(const PointIndex& whole, const PoseTemplate& part, const Similarity& pose, double tolerance,
                 std::size_t stride) {
    constexpr double least_cosine = 0.6;
    const double spacing = 8 * tolerance; // the whole is known at points only
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < part.points.size(); i += stride, ++count) {
        const Vec3 p = pose(part.points[i]);
        const std::size_t near = whole.nearest(p);
        const Vec3 away = p - whole.points().points[near];
        const Vec3& normal = whole.points().normals[near];
        const double distance = std::abs(normal.dot(away)) / tolerance;
        if (distance < 1 && away.norm() < spacing &&
            normal.dot(pose.rotation * part.normals[i]) > least_cosine)
            sum += 1 - distance * distance;
    }
    return count > 0 ? sum / static_cast<double>(count) : 0;
}

std::vector<Similarity> pair_starts(const PointIndex& whole, const PointIndex& part,
                                    const PairOptions& options) {
    const std::vector<Pair> of_whole = make_pairs(whole, options.points, 0.3, 2.5);
    const std::vector<Pair> of_part = make_pairs(part, options.points, 0.8, 3);
    std::vector<Scored> scored;
    for (const Similarity& pose : suggestions(of_whole, of_part, options))
        scored.push_back({pose, 0});
    const std::size_t points = part.points().points.size();
    keep_best(scored, 400, whole, part.points(), 0.12, std::max<std::size_t>(1, points / 40));
    keep_best(scored, 400, whole, part.points(), 0.08, std::max<std::size_t>(1, points / 200));
    std::vector<Similarity> best;
    for (const Scored& candidate : scored) {
        const auto same = [&](const Similarity& known) { return alike(known, candidate.pose); };
        if (best.size() < options.keep && std::ranges::none_of(best, same))
            best.push_back(candidate.pose);
    }
    return best;
}

} // namespace wm3d::resync
