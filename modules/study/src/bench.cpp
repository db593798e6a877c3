// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/bench.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>

#include <fmt/format.h>

#include <wm3d/attack/apply.hpp>
#include <wm3d/attack/random.hpp>
#include <wm3d/core/error.hpp>
#include <wm3d/core/fnv.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/detect/tail.hpp>
#include <wm3d/metrics/compare.hpp>
#include <wm3d/payload/reading.hpp>
#include <wm3d/payload/uncoded.hpp>
#include <wm3d/study/bench_log.hpp>
#include <wm3d/watermark/alignment.hpp>
#include <wm3d/watermark/closer_look.hpp>
#include <wm3d/watermark/content_statistic.hpp>
#include <wm3d/watermark/marker.hpp>
#include <wm3d/watermark/search_suspect.hpp>

namespace wm3d::study {

namespace {

/// A seed for everything random about what `text` names.
std::uint64_t seed_of(std::uint64_t seed, const std::string& text) {
    Fnv hash;
    for (unsigned char c : text)
        hash.add(c);
    return attack::RandomStream(seed, hash.value()).word(0);
}

/// What is asked of a search, and above which the quick look calls for a closer one and for a search. Not the probability that the
/// tables ask for, so that they can be made anew for another.
constexpr double log10_searched_pf = -9;

/// One model with what all of its marks share.
class ModelBench {
public:
    ModelBench(const TriangleMesh& mesh, const BenchSetting& setting, const Progress& progress)
        : mesh_(mesh), setting_(setting),
          level_(watermark::default_level(setting.parameters, mesh.positions.size(), setting.profile)),
          marker_(mesh, setting.vertices, progress) {}

    TriangleMesh marked(const MarkName& name, watermark::MarkSetting mark, BenchMark& figures) const {
        mark.level = level_;
        mark.rmax = setting_.parameters.rmax;
        mark.profile = setting_.profile;
        mark.content.message = message(name);
        const watermark::Marked marked = marker_.mark(key::null_secret(setting_.seed, name.key), mark);
        figures.strength = marked.strength;
        figures.gamma = marked.gamma;
        figures.normal_rms = watermark::percent(marked.distortion, marked.diagonal).normal_rms;
        return {marked.positions, mesh_.triangles};
    }

    TriangleMesh marked(const MarkName& name, double strength, BenchMark& figures) const {
        watermark::MarkSetting mark;
        mark.strength = strength;
        return marked(name, mark, figures);
    }

    /// The payload of a mark, drawn anew for every model and key.
    std::optional<payload::Message> message(const MarkName& name) const {
        if (setting_.payload == 0)
            return {};
        attack::RandomStream random(seed_of(setting_.seed, name.model + "/payload"), name.key);
        std::string digits = "0x";
        for (std::size_t k = 0; k < setting_.payload / 4; ++k)
            digits += fmt::format("{:x}", random.word(k) >> 60);
        return payload::parse_message(digits);
    }

    /// As strong as its visibility allows.
    TriangleMesh budgeted_mark(const MarkName& name, BenchMark& figures) const {
        watermark::MarkSetting mark;
        mark.visibility = name.size.value;
        return marked(name, mark, figures);
    }

    /// A new mark with its figures.
    TriangleMesh new_mark(const MarkName& name, BenchMark& figures) const {
        using Unit = MarkSize::Unit;
        TriangleMesh result = name.size.unit == Unit::mrms         ? limited_mark(name, figures)
                              : name.size.unit == Unit::visibility ? budgeted_mark(name, figures)
                                                                   : marked(name, name.size.value, figures);
        const metrics::Report report = metrics::compare(mesh_, result);
        figures.mrms = report.percent(report.mrms);
        figures.msdm2 = report.msdm2.value_or(0);
        figures.msdm2_both = report.msdm2_both;
        return result;
    }

    BenchItem item(const ItemName& name, const TriangleMesh& marked) const;

private:
    TriangleMesh limited_mark(const MarkName& name, BenchMark& figures) const;
    PayloadResult payload_result(const MarkName& name, unsigned level,
                                 const detect::LinearStatistic& statistic) const;
    void tell(BenchItem& item, const MarkName& name, const watermark::Examination& examination,
              const detect::FamilyScore& score, watermark::Sequences& sequences) const;
    void score_wrong_keys(BenchItem& item, const ItemName& name, const watermark::Examination& suspect) const;
    void search(BenchItem& item, const MarkName& name, const watermark::Suspect& suspect,
                const watermark::Examination& seen, watermark::Sequences& sequences) const;
    AssistedResult assisted(const watermark::Suspect& suspect, const key::Secret& secret) const;

    const TriangleMesh& mesh_;
    const BenchSetting& setting_;
    unsigned level_;
    watermark::Marker marker_;
};

double mrms_percent(const TriangleMesh& a, const TriangleMesh& b) {
    metrics::Options options;
    options.perceptual = false;
    const metrics::Report report = metrics::compare(a, b, options);
    return report.percent(report.mrms);
}

/// MRMS grows in proportion to the strength but for the second order, so that a few corrections reach the
/// limit from below.
TriangleMesh ModelBench::limited_mark(const MarkName& name, BenchMark& figures) const {
    constexpr double aim = 0.999, near_enough = 0.995;
    constexpr int most_trials = 6;
    const double limit = name.size.value;
    double strength = limit;
    TriangleMesh mesh = marked(name, strength, figures);
    for (int trial = 0; trial < most_trials; ++trial) {
        const double mrms = mrms_percent(mesh_, mesh);
        if (mrms <= limit && mrms >= near_enough * limit)
            break;
        if (!(mrms > 0))
            throw GeometryError(
                "the mark doesn't move the surface, so no strength reaches the limit of MRMS");
        strength *= aim * limit / mrms;
        mesh = marked(name, strength, figures);
    }
    return mesh;
}

void ModelBench::score_wrong_keys(BenchItem& item, const ItemName& name,
                                  const watermark::Examination& suspect) const {
    const std::uint64_t seed =
        seed_of(setting_.seed, name.mark.model + '/' + to_string(name.mark.size) + '/' +
                                   std::to_string(name.mark.key) + '/' + name.attack + "/wrong keys");
    const detect::Hypothesis& first = suspect.family().front();
    for (std::size_t k = 0; k < setting_.wrong_keys; ++k) {
        watermark::Sequences sequences(key::null_secret(seed, k), setting_.parameters.rmax);
        item.wrong.push_back(detect::score_family(suspect.family(), sequences.function()).log10_p);
        item.wrong_one.push_back(
            detect::saddlepoint_log10_tail(first.statistic, first.statistic.value(sequences(first.level))));
    }
}

/// As `verify` reads it: where the common part shows best, and believed at its usual P_f.
PayloadResult ModelBench::payload_result(const MarkName& name, unsigned level,
                                         const detect::LinearStatistic& statistic) const {
    const key::Secret secret = key::null_secret(setting_.seed, name.key);
    const payload::Message sent = *message(name);
    const payload::UncodedErrors raw = payload::uncoded_errors(secret, level, sent, statistic.coefficients());
    PayloadResult result{raw.bits, raw.errors, false, false, 0};
    if (const auto reading = payload::read_payload(secret, level, statistic)) {
        const bool believed = reading->log10_p <= std::log10(watermark::default_pf);
        result.read = believed && reading->message == sent;
        result.wrong = believed && reading->message != sent;
        result.log10_p = reading->log10_p;
    }
    return result;
}

AssistedResult ModelBench::assisted(const watermark::Suspect& suspect, const key::Secret& secret) const {
    watermark::ExaminationOptions options =
        watermark::examination_options(setting_.parameters, setting_.vertices);
    const watermark::ReferenceView reference = watermark::compare_with_reference(mesh_, suspect);
    options.poses = reference.known.poses;
    const watermark::Examination examination(suspect, options);
    std::vector<detect::Hypothesis> family(examination.family().begin(), examination.family().end());
    std::ranges::move(watermark::reference_family(reference, examination), std::back_inserter(family));
    watermark::Sequences sequences(secret, setting_.parameters.rmax);
    return {detect::score_family(family, sequences.function()).log10_p,
            reference.known.registration && reference.known.registration->aligned,
            reference.difference.covered};
}

void ModelBench::tell(BenchItem& item, const MarkName& name, const watermark::Examination& examination,
                      const detect::FamilyScore& score, watermark::Sequences& sequences) const {
    const detect::Hypothesis& best = examination.family()[score.best.hypothesis];
    const detect::Filter& filter = examination.evidence(best.pose).filter(best.filter);
    item.log10_p = score.log10_p;
    item.sigmas = score.best.sigmas;
    item.hypotheses = score.hypotheses;
    item.level = best.level;
    item.pose = best.pose;
    item.filter_t = filter.t;
    item.filter_power = filter.power;
    item.filter_hinges = filter.hinges;
    if (setting_.payload > 0)
        item.payload = payload_result(
            name, best.level,
            watermark::content_statistic(examination.family(), score.best.hypothesis, sequences(best.level)));
}

/// As verify goes on where the quick look found nothing.
void ModelBench::search(BenchItem& item, const MarkName& name, const watermark::Suspect& suspect,
                        const watermark::Examination& seen, watermark::Sequences& sequences) const {
    watermark::SearchEffort effort;
    effort.effort = setting_.search_effort;
    const watermark::SearchResult found = watermark::search_suspect(
        suspect, seen, sequences, effort, watermark::usual_strength, log10_searched_pf);
    item.searched = SearchedResult{found.hit.has_value(), found.report.centres};
    if (found.hit)
        tell(item, name, *found.hit->examination, found.hit->score, sequences);
}

BenchItem ModelBench::item(const ItemName& name, const TriangleMesh& marked) const {
    const auto begin = std::chrono::steady_clock::now();
    AttackChain chain = attack::parse_chain(name.attack);
    chain.push_back(attack::parse("similarity"));
    // Of the key and the attack alone: models and sizes suffer the same noise, as far as they can.
    const std::uint64_t seed = seed_of(setting_.seed, name.attack + '/' + std::to_string(name.mark.key));
    const TriangleMesh mesh = attack::apply(marked, chain, seed);
    const watermark::Suspect suspect = watermark::prepare_suspect(mesh, setting_.vertices);
    const watermark::Examination examination(
        suspect, watermark::examination_options(setting_.parameters, setting_.vertices));
    const key::Secret secret = key::null_secret(setting_.seed, name.mark.key);
    watermark::Sequences sequences(secret, setting_.parameters.rmax);

    BenchItem item;
    const bool may_look_closer = watermark::can_look_closer(suspect);
    const auto score_of = [&](const watermark::Examination& look) {
        return watermark::score_look(look.family(), sequences, may_look_closer, setting_.search_effort > 0);
    };
    const detect::FamilyScore first = score_of(examination);
    tell(item, name.mark, examination, first, sequences);
    if (may_look_closer && watermark::is_close_call(first, log10_searched_pf)) {
        const watermark::Examination closer = watermark::look_closer(suspect, examination);
        const detect::FamilyScore second = score_of(closer);
        if (second.log10_p < first.log10_p)
            tell(item, name.mark, closer, second, sequences);
    }
    if (setting_.search_effort > 0 && item.log10_p > log10_searched_pf)
        search(item, name.mark, suspect, examination, sequences);
    item.vertices = mesh.positions.size();
    score_wrong_keys(item, name, examination);
    if (setting_.assisted)
        item.assisted = assisted(suspect, secret);
    item.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return item;
}

/// The marked meshes, in the order of `names`; without positions where the mesh can't be marked.
std::vector<TriangleMesh> make_marks(const ModelBench& bench, const std::vector<MarkName>& names,
                                     BenchLog& log) {
    const std::map<MarkName, BenchMark> known = log.results().marks;
    std::vector<TriangleMesh> meshes(names.size());
    parallel_tasks(names.size(), [&](std::size_t i) {
        BenchMark mark;
        if (const auto found = known.find(names[i]); found != known.end()) {
            if (found->second.error.empty())
                meshes[i] = bench.marked(names[i], found->second.strength, mark);
            return;
        }
        try {
            meshes[i] = bench.new_mark(names[i], mark);
        } catch (const Error& error) {
            mark = {};
            mark.error = error.what();
        }
        log.add(names[i], mark);
    });
    return meshes;
}

BenchItem item_or_error(const ModelBench& bench, const ItemName& name, const TriangleMesh& marked) {
    try {
        return bench.item(name, marked);
    } catch (const Error& error) {
        BenchItem item;
        item.error = error.what();
        return item;
    }
}

/// Marks of one size at a time, so that only their meshes are in memory.
void run_size(const ModelBench& bench, const BenchWork& work, const MarkSize& size, BenchLog& log,
              const BenchSink& sink) {
    std::vector<MarkName> marks;
    std::ranges::copy_if(work.marks, std::back_inserter(marks),
                         [&](const MarkName& name) { return name.size == size; });
    if (marks.empty())
        return;
    const std::vector<TriangleMesh> meshes = make_marks(bench, marks, log);
    std::vector<const ItemName*> items;
    for (const ItemName& name : work.items)
        if (name.mark.size == size)
            items.push_back(&name);
    std::mutex guard; // of the sink
    parallel_tasks(items.size(), [&](std::size_t i) {
        const auto mark = static_cast<std::size_t>(std::ranges::find(marks, items[i]->mark) - marks.begin());
        if (!meshes[mark].positions.empty())
            log.add(*items[i], item_or_error(bench, *items[i], meshes[mark]));
        const std::lock_guard lock(guard);
        if (sink)
            sink();
    });
}

/// Whether an item is still to be made, or to be made anew for what the original tells.
bool lacks(const BenchResults& done, const ItemName& name, bool assisted) {
    const auto found = done.items.find(name);
    return found == done.items.end() || (assisted && !found->second.assisted && found->second.error.empty());
}

} // namespace

std::vector<AttackChain> default_attacks() {
    std::vector<AttackChain> chains;
    for (attack::AttackSpec& spec : attack::published_benchmark())
        chains.push_back({std::move(spec)});
    for (std::string_view text :
         {"taubin:10", "flips:30", "delaunay", "remeshing", "voxels:256", "scale:1.02,1,0.98", "shear:0.02",
          "bend:5", "rounding:3,size=100", "quantization:14+simplification:50"})
        chains.push_back(attack::parse_chain(text));
    std::erase_if(chains, [](const AttackChain& chain) {
        return std::ranges::any_of(chain, [](const attack::AttackSpec& spec) {
            return !std::ranges::find(attack::known_attacks(), spec.name, &attack::AttackInfo::name)
                        ->available;
        });
    });
    return chains;
}

BenchWork missing_work(const std::string& model, const BenchSetting& setting, const BenchResults& done) {
    BenchWork work{model, {}, {}};
    for (const MarkSize& size : setting.sizes)
        for (std::size_t key = 0; key < setting.keys; ++key) {
            const MarkName mark{model, size, key};
            const auto known = done.marks.find(mark);
            if (known != done.marks.end() && !known->second.error.empty())
                continue;
            const std::size_t before = work.items.size();
            for (const AttackChain& chain : setting.attacks)
                if (ItemName item{mark, attack::to_string(chain)}; lacks(done, item, setting.assisted))
                    work.items.push_back(std::move(item));
            if (known == done.marks.end() || work.items.size() > before)
                work.marks.push_back(mark);
        }
    return work;
}

void run_bench(const TriangleMesh& mesh, const BenchSetting& setting, const BenchWork& work, BenchLog& log,
               const BenchSink& sink, const Progress& progress) {
    if (work.marks.empty())
        return;
    const ModelBench bench(mesh, setting, progress);
    for (const MarkSize& size : setting.sizes)
        run_size(bench, work, size, log, sink);
}

} // namespace wm3d::study
