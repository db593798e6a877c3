// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/verify.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/detect/tail.hpp>
#include <wm3d/search/centres.hpp>
#include <wm3d/search/pose_search.hpp>
#include <wm3d/watermark/closer_look.hpp>
#include <wm3d/watermark/content_statistic.hpp>
#include <wm3d/watermark/null_keys.hpp>

namespace wm3d::watermark {

namespace {

/// The paper's statistic in every pose and at every level, as a family of its own.
std::vector<detect::Hypothesis> paper_family(const Examination& suspect) {
    std::vector<detect::Hypothesis> family;
    for (std::size_t pose = 0; pose < suspect.poses(); ++pose)
        for (unsigned level : suspect.options().levels)
            family.push_back({detect::paper_statistic(suspect.radii(pose), suspect.rows(pose, level),
                                                      suspect.options().rmax),
                              level, pose, 0});
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

detect::Verdict whitened_verdict(const VerifyReport& report, const VerifyOptions& options) {
    return detect::decide(report.score.log10_p, std::log10(options.pf), report.predicted_miss);
}

void decide_whitened(VerifyReport& report, const Examination& suspect, const key::Key& key,
                     Sequences& sequences, const VerifyOptions& options) {
    // Where the mark is found, the power only illustrates: the filter that found it is enough.
    std::optional<std::size_t> filter;
    if (report.score.log10_p <= std::log10(options.pf) &&
        report.score.best.hypothesis < suspect.family().size())
        filter = suspect.family()[report.score.best.hypothesis].filter;
    // Of several looks the one that sees most says what would have been missed.
    report.expected_sigmas = std::max(
        report.expected_sigmas,
        suspect.expected_sigmas(sequences, default_level(key.parameters(), suspect.base_vertices()),
                                std::min(key.parameters().reference_strength, usual_strength), 0, filter));
    report.predicted_miss =
        detect::predicted_miss(report.expected_sigmas, std::log10(options.pf), report.score.hypotheses);
    report.verdict = whitened_verdict(report, options);
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
        report.verdict =
            report.predicted_miss <= 0.01 ? detect::Verdict::absent : detect::Verdict::inconclusive;
}

/// The hypotheses of a verdict: those of the suspect alone and, with a reference, of the difference.
struct Hypotheses {
    Examination suspect;
    std::vector<detect::Hypothesis> family;
    resync::Ambiguity ambiguity = resync::Ambiguity::none; ///< of the suspect's axes, where they were asked
    std::optional<resync::Registration> registration;
    double reference_coverage = 0;
};

void require_own_receipt(const resync::Receipt& receipt, const key::Key& key) {
    if (receipt.key_commitment != key.commitment())
        throw ParameterError(
            fmt::format("the receipt was written for key {} and not for key {}; give the receipt of "
                        "this key's mark",
                        receipt.key_name, key.fingerprint()),
            ErrorCode::wrong_key);
}

Hypotheses hypotheses(const Suspect& mesh, const key::Key& key, const VerifyOptions& options,
                      const Progress& progress) {
    ExaminationOptions examination = examination_options(key.parameters(), options.vertices);
    examination.resync = options.resync;
    std::optional<resync::Registration> registration;
    std::optional<ReferenceView> reference;
    const auto take = [&](const KnownPose& known) {
        examination.poses.insert(examination.poses.end(), known.poses.begin(), known.poses.end());
        if (known.registration)
            registration = known.registration;
    };
    if (options.receipt) {
        require_own_receipt(*options.receipt, key);
        take(pose_by_receipt(*options.receipt, mesh, options.align_receipt, progress));
    }
    if (options.reference) {
        reference = compare_with_reference(*options.reference, mesh, progress);
        take(reference->known);
    }
    if (examination.resync == Resync::icp && examination.poses.empty())
        examination.resync = Resync::pca; // registration failed: the suspect's own axes are all there is
    Hypotheses result{Examination(mesh, examination, progress), {}, {}, registration, 0};
    const Examination& suspect = result.suspect;
    result.ambiguity = suspect.ambiguity();
    result.family = options.detector == Detector::paper
                        ? paper_family(suspect)
                        : std::vector<detect::Hypothesis>(suspect.family().begin(), suspect.family().end());
    if (reference) {
        result.reference_coverage = reference->difference.covered;
        if (options.detector == Detector::whitened)
            std::ranges::move(reference_family(*reference, suspect), std::back_inserter(result.family));
    }
    return result;
}

/// Whether a mark of the usual strength would have come out of the search, but for one in a hundred.
bool searched_in_earnest(const VerifyReport& report) {
    constexpr double one_in_a_hundred = 2.33;
    return report.search && report.search->complete &&
           report.search->expected_sigmas > search::SearchOptions{}.worth_a_climb + one_in_a_hundred;
}

/// What keeps a report whose verdict is not "present" from saying "absent".
Doubt doubt(const VerifyReport& report, resync::Ambiguity ambiguity) {
    if (report.verdict == detect::Verdict::present)
        return Doubt::none;
    if (report.registration && !report.registration->aligned)
        return Doubt::alignment;
    const bool unclear = report.may_be_part || ambiguity != resync::Ambiguity::none;
    if (unclear && report.search && report.search->too_few)
        return Doubt::vertices;
    if (report.verdict == detect::Verdict::inconclusive)
        return Doubt::power;
    if (report.registration || searched_in_earnest(report))
        return Doubt::none;
    if (report.may_be_part)
        return Doubt::opening;
    return ambiguity != resync::Ambiguity::none ? Doubt::axes : Doubt::none;
}

/// Takes "absent" back where it can't be said.
void settle(VerifyReport& report, resync::Ambiguity ambiguity) {
    report.doubt = doubt(report, ambiguity);
    if (report.doubt != Doubt::none)
        report.verdict = detect::Verdict::inconclusive;
}

/// The payload where the common part shows best: that was chosen without a look at the payload's streams.
std::optional<payload::Reading> read_payload(const VerifyReport& report, const key::Key& key,
                                             const VerifyOptions& options) {
    if (!options.read_payload)
        return {};
    std::optional<payload::Reading> reading =
        payload::read_payload(key.secret(), report.level, report.statistic);
    return reading && reading->log10_p <= std::log10(options.pf) ? reading : std::nullopt;
}

/// The report on the best hypothesis of a family whose score is known.
void tell(VerifyReport& report, const Hypotheses& all, const key::Key& key, Sequences& sequences,
          const VerifyOptions& options) {
    const detect::Hypothesis& best = all.family[report.score.best.hypothesis];
    report.base_vertices = all.suspect.base_vertices();
    report.level = best.level;
    report.statistic = content_statistic(all.family, report.score.best.hypothesis, sequences(best.level));
    report.pose = best.pose;
    report.pose_origin = all.suspect.pose(best.pose).origin;
    report.frame = all.suspect.pose(best.pose).frame;
    const auto read_as_paper = [&] {
        report.paper = paper_report(all.suspect, best.pose, best.level, sequences, options.pf);
    };
    if (options.detector == Detector::paper) {
        read_as_paper();
        decide_paper(report, all.suspect, key, sequences, options);
    } else {
        report.by_difference = best.source == detect::Source::reference;
        if (!report.by_difference)
            report.filter = all.suspect.evidence().filter(best.filter);
        parallel_invoke([&] { report.payload = read_payload(report, key, options); },
                        [&] {
                            parallel_invoke(read_as_paper, [&] {
                                decide_whitened(report, all.suspect, key, sequences, options);
                            });
                        });
    }
    settle(report, all.ambiguity);
}

/// Whether the suspect is looked at twice where the first look finds nothing.
bool may_look_closer(const Suspect& suspect, const VerifyOptions& options) {
    return options.look_closer && options.detector == Detector::whitened && can_look_closer(suspect);
}

bool may_search(const VerifyOptions& options) {
    return options.search != SearchUse::never && options.detector == Detector::whitened &&
           options.resync == Resync::pca && !options.receipt && !options.reference;
}

SearchEffort effort_of(const VerifyOptions& options) {
    SearchEffort effort;
    effort.effort = options.effort;
    effort.asked = options.search == SearchUse::always;
    if (effort.asked)
        effort.deformation = search::Deformation::bent;
    return effort;
}

detect::FamilyScore score_of_look(const Hypotheses& look, const Suspect& suspect, Sequences& sequences,
                                  const VerifyOptions& options) {
    return score_look(look.family, sequences, may_look_closer(suspect, options), may_search(options));
}

/// The same hypotheses on all of the suspect's vertices; those of a difference from a reference stay as they are.
Hypotheses closer_hypotheses(const Suspect& suspect, const Hypotheses& first) {
    Examination examination = look_closer(suspect, first.suspect);
    std::vector<detect::Hypothesis> family(examination.family().begin(), examination.family().end());
    return {std::move(examination), std::move(family), first.ambiguity, first.registration,
            first.reference_coverage};
}

/// The report on the second look, or again on the first where that shows more.
void tell_better(VerifyReport& report, const Hypotheses& first, const Hypotheses& second,
                 const Suspect& suspect, const key::Key& key, Sequences& sequences,
                 const VerifyOptions& options) {
    const detect::FamilyScore of_first = report.score;
    report.score = score_of_look(second, suspect, sequences, options);
    const bool better = report.score.log10_p < of_first.log10_p;
    tell(report, second, key, sequences, options); // for its power, if for nothing else
    if (better)
        return;
    report.score = of_first;
    tell(report, first, key, sequences, options);
}

/// Random keys on what the verdict was made from.
NullReport null_report(const Hypotheses& first, const Hypotheses* second, const Suspect& suspect,
                       const VerifyOptions& options, const Progress& progress) {
    std::vector<detect::Hypothesis> tried = first.family;
    if (second)
        tried.insert(tried.end(), second->family.begin(), second->family.end());
    const double share = !second && may_look_closer(suspect, options) ? 0.5 : 1;
    return score_null_keys(tried, first.suspect.options().rmax, share * options.pf, options.null_keys,
                           options.null_seed, progress);
}

void search_further(VerifyReport& report, const Suspect& suspect, const Hypotheses& all, const key::Key& key,
                    Sequences& sequences, const VerifyOptions& options, const Progress& progress) {
    SearchResult found = search_suspect(suspect, all.suspect, sequences, effort_of(options),
                                        std::min(key.parameters().reference_strength, usual_strength),
                                        std::log10(options.pf), progress);
    report.search = found.report;
    if (found.hit) {
        report.score = found.hit->score;
        Examination& there = *found.hit->examination;
        std::vector<detect::Hypothesis> family(there.family().begin(), there.family().end());
        tell(report, {std::move(there), std::move(family), {}, {}, 0}, key, sequences, options);
        if (found.report.pose->piece || found.report.pose->deformation != search::Deformation::none)
            report.frame.reset();
    } else {
        report.verdict = whitened_verdict(report, options);
        settle(report, all.ambiguity); // a search that found nothing may dispel a doubt
    }
}

void require_effort(const VerifyOptions& options) {
    if (!(options.effort >= 0))
        throw ParameterError("the effort of a search can't be negative; 1 is the usual one, 0 is none");
}

} // namespace

VerifyReport verify(const TriangleMesh& mesh, const key::Key& key, const VerifyOptions& options,
                    const Progress& progress) {
    require_effort(options);
    return verify(prepare_suspect(mesh, options.vertices, progress), key, options, progress);
}

VerifyReport verify(const Suspect& suspect, const key::Key& key, const VerifyOptions& options,
                    const Progress& progress) {
    require_effort(options);
    if (!suspect.whole)
        return verify({suspect.mesh, suspect.base, suspect.stop, suspect.telling, suspect.whole_surface()},
                      key, options, progress);
    const search::Outline outline = suspect.whole_surface()->outline;
    const Hypotheses all = hypotheses(suspect, key, options, progress);
    Sequences sequences(key.secret(), key.parameters().rmax);

    VerifyReport report;
    report.registration = all.registration;
    report.reference_coverage = all.reference_coverage;
    report.largest_opening = outline.opening;
    report.lone_flat = outline.closed;
    report.may_be_part = may_be_part(outline);
    report.score = score_of_look(all, suspect, sequences, options);
    tell(report, all, key, sequences, options);
    std::optional<Hypotheses> closer;
    if (may_look_closer(suspect, options) && is_close_call(report.score, std::log10(options.pf))) {
        notify(progress, "looking closer", 0);
        closer.emplace(closer_hypotheses(suspect, all));
        tell_better(report, all, *closer, suspect, key, sequences, options);
    }
    if (may_search(options) && report.verdict != detect::Verdict::present)
        search_further(report, suspect, all, key, sequences, options, progress);
    if (options.null_keys > 0)
        report.null = null_report(all, closer ? &*closer : nullptr, suspect, options, progress);
    return report;
}

} // namespace wm3d::watermark
