// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/mesh_analysis.hpp>

#include <cmath>

#include <wm3d/detect/paper_null.hpp>

namespace wm3d::study {

namespace {

std::vector<double> radii_of(const std::vector<Vec3>& base) {
    std::vector<double> radii;
    for (const Vec3& p : base)
        radii.push_back(p.norm());
    return radii;
}

/// rho - mu_r mean(Delta) on the unmarked base, as a statistic that is linear in the key.
detect::LinearStatistic paper_null(const TrialBench& bench) {
    const std::vector<Vec3> base = bench.base();
    const sphere::Icosphere sphere(bench.setting().level);
    return detect::paper_statistic(radii_of(base), sphere::barycentric_rows(sphere, base),
                                   bench.setting().parameters.rmax);
}

RocCurve whitened_roc(const Response& response, std::span<const double> pf) {
    RocCurve curve;
    curve.kind = RocKind::whitened;
    curve.gamma = response.gamma;
    for (double p : pf) {
        const double log10_pm = log10_miss(response, 1, p);
        curve.points.push_back({.pf = p, .pm = std::pow(10, log10_pm), .log10_pm = log10_pm});
    }
    return curve;
}

} // namespace

MeshStatistics mesh_statistics(const TrialBench& bench, const key::Secret& secret) {
    const std::vector<Vec3> base = bench.base();
    const std::vector<double> radii = radii_of(base);
    const unsigned level = bench.setting().level;
    const double rmax = bench.setting().parameters.rmax;
    const sphere::SparseRows rows = sphere::barycentric_rows(sphere::Icosphere(level), base);
    MeshStatistics s;
    s.level = level;
    s.paper =
        detect::paper_statistics(radii, sphere::multiply(rows, key::watermark_sequence(secret, level, rmax)));
    const double assumed =
        std::sqrt(s.paper.sigma_r2 * s.paper.delta_mean_square / static_cast<double>(s.paper.n));
    s.null_sigma_ratio = detect::paper_statistic(radii, rows, rmax).sigma() / assumed;
    return s;
}

std::vector<RocKind> detectors_for(watermark::Profile profile) {
    using enum RocKind;
    return profile == watermark::Profile::paper ? std::vector{paper, paper_true, whitened}
                                                : std::vector{whitened};
}

std::vector<RocCurve> predicted_rocs(const TrialBench& bench, const MeshStatistics& statistics, double size,
                                     std::span<const double> pf, std::size_t pilots,
                                     const Progress& progress) {
    const Response response = pilot_response(bench, pilot_marks(bench, size, pilots, progress), progress);
    std::vector<RocCurve> curves;
    if (bench.setting().profile == watermark::Profile::paper && !bench.setting().damage) {
        curves.push_back(paper_roc(statistics.paper, response.gamma, pf));
        curves.push_back(true_paper_roc(statistics.paper, paper_null(bench), response.gamma, pf));
    }
    curves.push_back(whitened_roc(response, pf));
    for (RocCurve& curve : curves) {
        curve.vertices = statistics.paper.n;
        const bool by_strength = bench.setting().sizing == Sizing::strength;
        curve.strength = by_strength ? size : response.distortion.normal_rms;
        if (!by_strength)
            curve.visibility = size;
    }
    return curves;
}

} // namespace wm3d::study
