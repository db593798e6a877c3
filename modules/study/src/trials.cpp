// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/trials.hpp>

#include <algorithm>
#include <cmath>
#include <mutex>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/detect/tail.hpp>

namespace wm3d::study {

namespace {

void score_paper(Trial& trial, const watermark::Examination& suspect, std::size_t pose,
                 const TrialSetting& setting, std::span<const double> w) {
    const std::vector<double> radii = suspect.radii(pose);
    const sphere::SparseRows& rows = suspect.rows(pose, setting.level);
    const detect::PaperStatistics s = detect::paper_statistics(radii, sphere::multiply(rows, w));
    const double above_mean = s.rho - s.mu_r * s.delta_mean;
    const double nominal_sigma = std::sqrt(s.sigma_r2 * s.delta_mean_square / static_cast<double>(s.n));
    trial.paper_nominal_p =
        std::erfc(above_mean / (std::sqrt(2.0) * nominal_sigma)) / 2; // eq. (6) solved for P_f
    trial.paper_log10_p = detect::saddlepoint_log10_tail(
        detect::paper_statistic(radii, rows, setting.parameters.rmax), above_mean);
}

/// The pose whose axes are nearest to the frame's: the trace of the rotation between them falls as its angle
/// grows.
std::size_t nearest_pose(const watermark::Examination& suspect, const Frame& frame) {
    std::vector<double> trace(suspect.poses());
    for (std::size_t pose = 0; pose < trace.size(); ++pose)
        trace[pose] = (suspect.pose(pose).frame.axes * frame.axes.transpose()).trace();
    return static_cast<std::size_t>(std::ranges::max_element(trace) - trace.begin());
}

/// Per filter: the statistic of a pose and a level.
std::vector<detect::LinearStatistic> statistics_of(const watermark::Examination& suspect, std::size_t pose,
                                                   unsigned level) {
    std::vector<detect::LinearStatistic> statistics;
    for (const detect::Hypothesis& h : suspect.family())
        if (h.pose == pose && h.level == level && h.source == detect::Source::vertices)
            statistics.push_back(detect::own_statistic(h));
    return statistics;
}

/// Sum over the filters of the correlation of their coefficients.
double alikeness(const std::vector<detect::LinearStatistic>& a,
                 const std::vector<detect::LinearStatistic>& b) {
    double sum = 0;
    for (std::size_t f = 0; f < a.size(); ++f) {
        const double scale = a[f].sigma() * b[f].sigma();
        sum += scale > 0 ? a[f].value(b[f].coefficients()) / scale : 0; // but for a factor they all share
    }
    return sum;
}

/// Splits T = c.w into the host's part and the mark's. The simplification of the marked mesh picks somewhat
/// other vertices, so only a share of the host's c is found in the suspect's: its projection.
void separate_mark(Trial& trial, const std::vector<detect::LinearStatistic>& suspect,
                   const std::vector<detect::LinearStatistic>& host, std::span<const double> w) {
    trial.mark.resize(static_cast<Eigen::Index>(host.size()));
    trial.variance.resize(trial.mark.size());
    for (std::size_t f = 0; f < host.size(); ++f) {
        const double norm = host[f].value(host[f].coefficients());
        const double share = norm > 0 ? suspect[f].value(host[f].coefficients()) / norm : 0;
        const auto i = static_cast<Eigen::Index>(f);
        trial.mark[i] = suspect[f].value(w) - share * host[f].value(w);
        trial.variance[i] = suspect[f].sigma() * suspect[f].sigma() - host[f].sigma() * host[f].sigma();
    }
}

bool missed(RocKind kind, const Trial& trial, double pf) {
    switch (kind) {
    case RocKind::paper:
        return trial.paper_nominal_p > pf;
    case RocKind::paper_true:
        return trial.paper_log10_p > std::log10(pf);
    default:
        return trial.log10_p > std::log10(pf);
    }
}

} // namespace

std::string_view name(Sizing sizing) {
    return sizing == Sizing::visibility ? "visibility" : "strength";
}

TrialBench::TrialBench(const TriangleMesh& mesh, TrialSetting setting, const Progress& progress)
    : mesh_(mesh), setting_(std::move(setting)),
      marker_(std::make_shared<const watermark::Marker>(mesh, setting_.vertices, progress)) {
    if (std::ranges::find(setting_.parameters.levels, setting_.level) == setting_.parameters.levels.end())
        throw ParameterError(
            fmt::format("the key admits marks of level {} and not of {}, so verify would not look for "
                        "it; choose one of them",
                        fmt::join(setting_.parameters.levels, ", "), setting_.level));
    const Frame frame = canonical_frame(mesh);
    const watermark::Suspect simplified = watermark::prepare_suspect(mesh, setting_.vertices, progress);
    simplified_ = to_frame(simplified.base, frame).positions;
    const watermark::Examination unharmed(
        simplified, watermark::examination_options(setting_.parameters, setting_.vertices), progress);
    hypotheses_ = unharmed.family().size();
    unharmed_ = host_ = statistics_of(unharmed, nearest_pose(unharmed, frame), setting_.level);
    damage_host(progress);
}

TrialBench::TrialBench(const TrialBench& other, Damage damage, const Progress& progress)
    : mesh_(other.mesh_), setting_(other.setting_), marker_(other.marker_), simplified_(other.simplified_),
      hypotheses_(other.hypotheses_), unharmed_(other.unharmed_), host_(other.unharmed_) {
    setting_.damage = std::move(damage);
    damage_host(progress);
}

void TrialBench::damage_host(const Progress& progress) {
    if (!setting_.damage)
        return;
    const watermark::Examination damaged = examination(setting_.damage(mesh_, 0), progress);
    hypotheses_ = damaged.family().size();
    host_ = statistics_of(damaged, true_pose(damaged), setting_.level);
}

watermark::Examination TrialBench::examination(const TriangleMesh& suspect, const Progress& progress) const {
    return {suspect, watermark::examination_options(setting_.parameters, setting_.vertices), progress};
}

std::vector<Vec3> TrialBench::base() const {
    return setting_.profile == watermark::Profile::masked ? simplified_ : marker_->domain().mesh.positions;
}

std::size_t TrialBench::true_pose(const watermark::Examination& suspect) const {
    // Mostly c comes from the host, so it is like the host's in the pose of the mark, wherever that was
    // moved.
    std::size_t likest = 0;
    double best = -1;
    for (std::size_t pose = 0; pose < suspect.poses(); ++pose) {
        const double likeness = alikeness(statistics_of(suspect, pose, setting_.level), unharmed_);
        if (likeness > best) {
            best = likeness;
            likest = pose;
        }
    }
    return likest;
}

watermark::Marked TrialBench::mark(double size, std::uint64_t seed, std::size_t number) const {
    watermark::MarkSetting mark;
    mark.level = setting_.level;
    mark.rmax = setting_.parameters.rmax;
    mark.profile = setting_.profile;
    mark.content = setting_.content;
    if (setting_.sizing == Sizing::visibility)
        mark.visibility = size;
    else
        mark.strength = size;
    return marker_->mark(key::null_secret(seed, number), mark);
}

Trial TrialBench::run(double size, std::uint64_t seed, std::size_t number) const {
    return examine(mark(size, seed, number), seed, number);
}

Trial TrialBench::examine(const watermark::Marked& marked, std::uint64_t seed, std::size_t number) const {
    TriangleMesh suspect_mesh{marked.positions, mesh_.triangles};
    if (setting_.damage)
        suspect_mesh = setting_.damage(suspect_mesh, number);
    const watermark::Examination suspect = examination(suspect_mesh);
    watermark::Sequences sequences(key::null_secret(seed, number), setting_.parameters.rmax);

    Trial trial;
    trial.number = number;
    trial.gamma = marked.gamma;
    trial.distortion = watermark::percent(marked.distortion, marked.diagonal);
    trial.log10_p = detect::score_family(suspect.family(), sequences.function()).log10_p;
    const std::size_t pose = true_pose(suspect);
    separate_mark(trial, statistics_of(suspect, pose, setting_.level), host_, sequences(setting_.level));
    score_paper(trial, suspect, pose, setting_, sequences(setting_.level));
    return trial;
}

std::vector<Trial> run_trials(const TrialBench& bench, double size, std::uint64_t seed,
                              const std::vector<std::size_t>& numbers, const TrialSink& sink,
                              const Progress& progress) {
    std::vector<Trial> trials(numbers.size());
    std::mutex guard;
    std::size_t done = 0;
    notify(progress, "trying marks", 0);
    parallel_tasks(numbers.size(), [&](std::size_t i) {
        trials[i] = bench.run(size, seed, numbers[i]);
        const std::lock_guard lock(guard);
        if (sink)
            sink(trials[i]);
        notify(progress, "trying marks", static_cast<double>(++done) / static_cast<double>(numbers.size()));
    });
    return trials;
}

MeasuredCurve measured_roc(RocKind kind, const std::vector<Trial>& trials, const TrialBench& bench,
                           double size, std::span<const double> pf) {
    MeasuredCurve curve;
    curve.kind = kind;
    curve.vertices = bench.base().size();
    curve.trials = trials.size();
    for (const Trial& trial : trials) {
        curve.gamma += trial.gamma / static_cast<double>(trials.size());
        curve.strength += trial.distortion.normal_rms / static_cast<double>(trials.size());
    }
    if (bench.setting().sizing == Sizing::visibility)
        curve.visibility = size;
    else
        curve.strength = size;
    for (double p : pf) {
        const auto count = std::ranges::count_if(trials, [&](const Trial& t) { return missed(kind, t, p); });
        curve.points.push_back(measured_point(p, static_cast<std::size_t>(count), trials.size()));
    }
    return curve;
}

} // namespace wm3d::study
