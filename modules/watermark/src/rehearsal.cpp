// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/rehearsal.hpp>

#include <algorithm>
#include <cmath>

#include <wm3d/core/parallel.hpp>
#include <wm3d/detect/evidence.hpp>
#include <wm3d/detect/tail.hpp>
#include <wm3d/key/stream.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/umbrella.hpp>
#include <wm3d/simplify/simplify.hpp>
#include <wm3d/sphere/sparse_rows.hpp>

namespace wm3d::watermark {

namespace {

TriangleMesh with_noise(TriangleMesh mesh, double percent) {
    Vec3 centre = Vec3::Zero();
    for (const Vec3& p : mesh.positions)
        centre += p / static_cast<double>(mesh.positions.size());
    double distance = 0;
    for (const Vec3& p : mesh.positions)
        distance += (p - centre).norm() / static_cast<double>(mesh.positions.size());
    constexpr std::uint64_t family = 0x6e6f697365;
    std::vector<double> numbers(3 * mesh.positions.size());
    key::Stream(key::null_secret(family, 0), key::Purpose::trial, 0)
        .fill_symmetric(numbers, percent / 100 * distance);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        mesh.positions[i] += Vec3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
    return mesh;
}

TriangleMesh rounded(TriangleMesh mesh, int bits) {
    const Box box = surface_box(mesh);
    const Vec3 step = ((box.max - box.min) / std::ldexp(1.0, bits)).cwiseMax(1e-300);
    for (Vec3& p : mesh.positions)
        p = box.min + (p - box.min).cwiseQuotient(step).array().round().matrix().cwiseProduct(step);
    return mesh;
}

/// As many steps as spread over the base what `steps` spread over the full mesh.
TriangleMesh smoothed(TriangleMesh mesh, int steps, double density) {
    constexpr double weight = 0.1;
    const int on_base = std::max(1, static_cast<int>(std::lround(steps * density)));
    mesh.positions = Umbrella(mesh).smooth(std::move(mesh.positions), on_base, weight);
    return mesh;
}

TriangleMesh coarsened(const TriangleMesh& mesh, std::size_t vertices) {
    simplify::Options options;
    options.target_vertices = vertices;
    return simplify::simplify(mesh, options).mesh;
}

double best_log10_p(const TriangleMesh& mesh, const sphere::Icosphere& sphere, std::span<const double> w,
                    double rmax, std::span<const std::size_t> filters) {
    detect::EvidenceOptions options;
    const std::vector<detect::Filter> bank = std::move(options.filters);
    options.filters.clear();
    for (std::size_t f : filters)
        options.filters.push_back(bank[f]);
    const detect::Evidence evidence(mesh, options);
    const sphere::SparseRows rows = sphere::barycentric_rows(sphere, mesh.positions);
    // By the saddlepoint: no verdict rests on what is rehearsed, and it's within a thousandth of a decade of the exact tail.
    double best = 0;
    for (std::size_t f = 0; f < evidence.filters(); ++f) {
        const detect::LinearStatistic t = evidence.statistic(f, rows, rmax);
        if (t.sigma() > 0)
            best = std::min(best, detect::saddlepoint_log10_tail(t, t.value(w)));
    }
    return best;
}

} // namespace

std::vector<Rehearsed> rehearse(const Suspect& marked, const Frame& frame, Sequences& sequences,
                                unsigned level, double rmax) {
    const TriangleMesh base = to_frame(marked.base, frame);
    const std::size_t vertices = marked.mesh.positions.size();
    const double density = static_cast<double>(base.positions.size()) / static_cast<double>(vertices);
    const std::size_t quarter = std::min(base.positions.size(), vertices / 4);
    struct Attack {
        std::string name;
        std::function<TriangleMesh()> apply;
        std::vector<std::size_t> filters; ///< of the bank, those that such damage leaves the most to
    };
    using namespace detect; // the places of the bank
    const std::vector<Attack> attacks{
        {"noise 0.3 %",
         [&] { return with_noise(base, 0.3); },
         {folds_under_noise, folds_after_simplification}},
        {"smoothing 10", [&] { return smoothed(base, 10, density); }, {folds_as_marked}},
        {"8 bits", [&] { return rounded(base, 8); }, {folds_under_noise}},
        {"1/4 of the vertices",
         [&] { return coarsened(base, std::max<std::size_t>(quarter, 4)); },
         {folds_as_marked, folds_after_simplification}}};
    std::vector<Rehearsed> results(attacks.size());
    const sphere::Icosphere sphere(level);
    const std::span<const double> w = sequences(level);
    parallel_tasks(attacks.size(), [&](std::size_t k) {
        const Attack& attack = attacks[k];
        results[k] = {attack.name, best_log10_p(attack.apply(), sphere, w, rmax, attack.filters)};
    });
    return results;
}

std::vector<Rehearsed> paid_for(std::vector<Rehearsed> rehearsed, std::size_t hypotheses) {
    for (Rehearsed& r : rehearsed)
        r.log10_p = std::min(0.0, r.log10_p + std::log10(static_cast<double>(hypotheses)));
    return rehearsed;
}

} // namespace wm3d::watermark
