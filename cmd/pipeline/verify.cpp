// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/verify.hpp"

#include <algorithm>
#include <cmath>

#include <wm3d/detect/tail.hpp>

#include "pipeline/null_keys.hpp"

namespace wm3d::pipeline {

namespace {

ExaminationOptions examination_options(const key::Key& key, const VerifyOptions& options) {
    ExaminationOptions result;
    result.vertices = options.vertices;
    result.levels = key.parameters().levels;
    result.rmax = key.parameters().rmax;
    result.resync = options.resync;
    return result;
}

/// The paper's statistic in every pose and at every level, as a family of its own.
std::vector<detect::Hypothesis> paper_family(const Examination& suspect) {
    std::vector<detect::Hypothesis> family;
    for (std::size_t pose = 0; pose < suspect.poses(); ++pose)
        for (unsigned level : suspect.options().levels)
            family.push_back(
                {detect::paper_statistic(suspect.radii(pose), suspect.rows(pose, level), suspect.options().rmax), level, pose, 0});
    return family;
}

PaperReport paper_report(const Examination& suspect, std::size_t pose, unsigned level, Sequences& sequences,
                         double pf) {
    const std::vector<double> radii = suspect.radii(pose);
    const sphere::SparseRows rows = suspect.rows(pose, level);
    PaperReport report;
    report.statistics = detect::paper_statistics(radii, sphere::multiply(rows, sequences(level)));
    const detect::PaperStatistics& s = report.statistics;
    report.threshold = detect::threshold(pf, s.n, s.sigma_r2, s.delta_mean_square, s.delta_mean, s.mu_r);
    const detect::LinearStatistic linear = detect::paper_statistic(radii, rows, suspect.options().rmax);
    report.log10_true_pf = detect::log10_true_pf(linear, s, pf);
    report.log10_p = detect::exact_tail(linear, s.rho - s.mu_r * s.delta_mean).log10_p;
    return report;
}

void decide_whitened(VerifyReport& report, const Examination& suspect, const key::Key& key, Sequences& sequences,
                     const VerifyOptions& options) {
    report.filter = suspect.evidence().filter(suspect.family()[report.score.best.hypothesis].filter);
    report.expected_sigmas =
        suspect.expected_sigmas(sequences, default_level(key.parameters()), key.parameters().reference_strength);
    report.predicted_miss =
        detect::predicted_miss(report.expected_sigmas, std::log10(options.pf), report.score.hypotheses);
    report.verdict = detect::decide(report.score.log10_p, std::log10(options.pf), report.predicted_miss);
}

/// Eq. (6) word for word. Its own prediction, eq. (5), says whether "absent" can be said.
void decide_paper(VerifyReport& report, const Examination& suspect, const key::Key& key, Sequences& sequences,
                  const VerifyOptions& options) {
    const detect::PaperStatistics& s = report.paper.statistics;
    const double gamma = suspect.gamma(sequences, report.level, key.parameters().reference_strength);
    report.predicted_miss =
        detect::miss_probability(gamma, s.n, s.delta_mean_square, std::sqrt(s.sigma_r2), options.pf);
    if (s.rho > report.paper.threshold)
        report.verdict = detect::Verdict::present;
    else
        report.verdict = report.predicted_miss <= 0.01 ? detect::Verdict::absent : detect::Verdict::inconclusive;
}

} // namespace

VerifyReport verify(const TriangleMesh& mesh, const key::Key& key, const VerifyOptions& options,
                    const Progress& progress) {
    const Examination suspect(mesh, examination_options(key, options), progress);
    Sequences sequences(key.secret(), key.parameters().rmax);

    const bool paper = options.detector == Detector::paper;
    const std::vector<detect::Hypothesis> of_paper = paper ? paper_family(suspect) : std::vector<detect::Hypothesis>{};
    const std::span<const detect::Hypothesis> family = paper ? std::span(of_paper) : suspect.family();

    VerifyReport report;
    report.base_vertices = suspect.base_vertices();
    report.score = detect::score_family(family, sequences.function());
    const detect::Hypothesis& best = family[report.score.best.hypothesis];
    report.level = best.level;
    report.pose = best.pose;
    report.paper = paper_report(suspect, best.pose, best.level, sequences, options.pf);
    if (paper)
        decide_paper(report, suspect, key, sequences, options);
    else
        decide_whitened(report, suspect, key, sequences, options);
    if (options.null_keys > 0)
        report.null = score_null_keys(family, suspect.options().rmax, options.pf, options.null_keys, options.null_seed,
                                      progress);
    return report;
}

} // namespace wm3d::pipeline
