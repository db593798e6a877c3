// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/identify.hpp>

#include <algorithm>
#include <cmath>

#include <wm3d/watermark/closer_look.hpp>
#include <wm3d/watermark/content_statistic.hpp>

namespace wm3d::watermark {

namespace {

/// Part of P_f that all receipts together have, whether they will be needed or not.
constexpr double receipts_share = 0.001;

/// A verdict at a part of P_f, whose p then counts for the whole.
VerifyReport verify_at_share(const Suspect& suspect, const key::Key& key, VerifyOptions options, double share,
                             const Progress& progress) {
    options.pf *= share;
    VerifyReport report = verify(suspect, key, options, progress);
    report.score.log10_p = std::min(0.0, report.score.log10_p - std::log10(share));
    return report;
}

/// The first receipt whose pose shows the mark.
void try_receipts(IdentifyReport& report, const Suspect& suspect, const key::Key& key,
                  const IdentifyOptions& options, const Progress& progress) {
    VerifyOptions by_receipt = options.verify;
    by_receipt.search = SearchUse::never;
    by_receipt.look_closer = false;  // at each of what may be a thousand works
    by_receipt.resync = Resync::icp; // the receipt's poses alone
    by_receipt.align_receipt = resync::has_registration();
    const double share = receipts_share / static_cast<double>(options.receipts.size());
    for (std::size_t k = 0; k < options.receipts.size(); ++k) {
        by_receipt.receipt = &options.receipts[k];
        ++report.receipts_tried;
        VerifyReport found = verify_at_share(suspect, key, by_receipt, share, progress);
        if (found.verdict != detect::Verdict::present)
            continue;
        report.mark = std::move(found);
        report.receipt = k;
        return;
    }
}

/// Whether the mark is there, and where: by a quick look, then by what is known of the works, then by a search.
void look_for_mark(IdentifyReport& report, const Suspect& suspect, const key::Key& key,
                   const IdentifyOptions& options, const Progress& progress) {
    if (options.receipts.empty() || options.verify.detector != Detector::whitened) {
        report.mark = verify(suspect, key, options.verify, progress);
        return;
    }
    VerifyOptions quick = options.verify;
    quick.search = SearchUse::never;
    const bool may_search = options.verify.search != SearchUse::never;
    const double share = (1 - receipts_share) * (may_search ? 1 - search_share : 1);
    report.mark = verify_at_share(suspect, key, quick, share, progress);
    if (report.mark.verdict != detect::Verdict::present)
        try_receipts(report, suspect, key, options, progress);
    if (may_search && report.mark.verdict != detect::Verdict::present)
        report.mark = verify_at_share(suspect, key, options.verify, 1 - receipts_share, progress);
}

/// What the copies are compared with: all filters on up to `most_examined` vertices, where the mark was found on fewer.
/// The pose and level were chosen by the common part alone, so the copies' signs are still unknown to it.
detect::LinearStatistic content(const TriangleMesh& suspect, const VerifyReport& mark, const key::Key& key,
                                const Progress& progress) {
    const bool closer = mark.verdict == detect::Verdict::present && mark.frame &&
                        mark.base_vertices < std::min(suspect.positions.size(), most_examined);
    if (!closer)
        return mark.statistic;
    ExaminationOptions options = examination_options(key.parameters(), most_examined);
    options.levels = {mark.level};
    options.resync = Resync::icp; // no pose but this
    options.poses = {{*mark.frame, mark.pose_origin}};
    const Examination examination(suspect, options, progress);
    Sequences sequences(key.secret(), key.parameters().rmax);
    const detect::FamilyScore score = detect::score_family(examination.family(), sequences.function());
    return content_statistic(examination.family(), score.best.hypothesis, sequences(mark.level));
}

} // namespace

IdentifyReport identify(const TriangleMesh& suspect, const key::Key& key, std::span<const IssuedCopy> copies,
                        const IdentifyOptions& options, const Progress& progress) {
    IdentifyReport report;
    look_for_mark(report, prepare_suspect(suspect, options.verify.vertices, progress), key, options,
                  progress);
    report.content = content(suspect, report.mark, key, progress);
    std::vector<std::uint64_t> numbers;
    std::vector<std::size_t> place; // of each number among the copies
    for (std::size_t k = 0; k < copies.size(); ++k)
        if (copies[k].level == report.mark.level) {
            numbers.push_back(copies[k].number);
            place.push_back(k);
        }
    const std::vector<double> scores = payload::copy_scores(key.secret(), report.content, numbers, progress);
    report.compared = numbers.size();
    report.best_sigmas = scores.empty() ? 0 : *std::ranges::max_element(scores);
    report.accused = payload::accuse(report.content, scores, std::log10(options.verify.pf), copies.size());
    for (payload::Accusation& accusation : report.accused)
        accusation.copy = place[accusation.copy];
    return report;
}

} // namespace wm3d::watermark
