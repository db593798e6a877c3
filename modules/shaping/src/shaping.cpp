// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/shaping/shaping.hpp>

#include <algorithm>
#include <cmath>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/umbrella.hpp>

namespace wm3d::shaping {

namespace {

/// Divides x by its area-weighted root mean square; false if that is zero.
bool normalize(std::vector<double>& x, std::span<const double> area) {
    double squares = 0, total = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        squares += area[i] * x[i] * x[i];
        total += area[i];
    }
    if (!(squares > 0))
        return false;
    const double scale = std::sqrt(total / squares);
    for (double& value : x)
        value *= scale;
    return true;
}

/// B w, as far as it shows along the normals.
std::vector<double> bumps(const TriangleMesh& base, std::span<const Vec3> normals,
                          const sphere::SparseRows& rows, std::span<const double> w) {
    std::vector<double> x = sphere::multiply(rows, w);
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] *= normals[i].dot(base.positions[i].normalized());
    return x;
}

/// As `normalize`, with what exceeds `most` cut off.
bool normalize_and_limit(std::vector<double>& x, std::span<const double> area, double most) {
    if (!normalize(x, area))
        return false;
    for (double& value : x)
        value = std::clamp(value, -most, most);
    return normalize(x, area);
}

void add(std::vector<double>& sum, std::span<const double> x, double factor) {
    for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] += factor * x[i];
}

/// A marked mesh and what its templates are taken from.
struct Stage {
    TriangleMesh marked;
    Umbrella umbrella;
    std::span<const Vec3> normals;
    std::span<const double> area;
    const sphere::SparseRows& rows;
    std::span<const double> w;

    /// The template of the mark that is left after `steps`, carried back through them: the moves per area
    /// that raise T most for their root mean square.
    std::vector<double> carried_back(int steps, const Blend& blend) const {
        TriangleMesh smoothed = marked;
        smoothed.positions = umbrella.smooth(std::move(smoothed.positions), steps, blend.weight);
        detect::EvidenceOptions options;
        options.filters = {blend.filter};
        const detect::Evidence evidence(smoothed, options);
        const std::vector<Vec3> gradient =
            umbrella.smooth_transposed(evidence.gradient(0, rows, w), steps, blend.weight);
        std::vector<double> moves(gradient.size(), 0.0);
        for (std::size_t i = 0; i < moves.size(); ++i)
            if (area[i] > 0)
                moves[i] = gradient[i].dot(normals[i]) / area[i];
        return moves;
    }
};

/// What `steps` on the full mesh are on the base; those that smooth at all at least one.
int steps_on_base(int steps, double density) {
    return steps == 0 ? 0 : std::max(1, static_cast<int>(std::lround(steps * density)));
}

} // namespace

std::vector<double> normal_moves(const TriangleMesh& base, const sphere::SparseRows& rows,
                                 std::span<const double> w, double rms, double density, const Blend& blend) {
    const std::vector<Vec3> normals = vertex_normals(base);
    const std::vector<double> area = vertex_areas(base);
    const std::vector<double> plain = [&] {
        std::vector<double> x = bumps(base, normals, rows, w);
        return normalize(x, area) ? x : std::vector<double>(x.size(), 0.0);
    }();
    Stage stage{base, Umbrella(base), normals, area, rows, w};
    for (std::size_t i = 0; i < plain.size(); ++i)
        stage.marked.positions[i] += rms * plain[i] * normals[i];

    std::vector<std::vector<double>> parts(blend.templates.size());
    parallel_blocks(parts.size(), 1, [&](std::size_t k, std::size_t) {
        parts[k] = stage.carried_back(steps_on_base(blend.templates[k].steps, density), blend);
        if (!normalize_and_limit(parts[k], area, blend.most))
            parts[k].assign(plain.size(), 0.0);
    });
    std::vector<double> moves(plain.size(), 0.0);
    add(moves, plain, blend.bumps);
    for (std::size_t k = 0; k < parts.size(); ++k)
        add(moves, parts[k], blend.templates[k].share);
    normalize(moves, area);
    return moves;
}

} // namespace wm3d::shaping
