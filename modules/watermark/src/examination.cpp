// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/examination.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/sphere/half_turns.hpp>

namespace wm3d::watermark {

namespace {

/// A suspect of fewer vertices may have been simplified with new places for its vertices.
constexpr std::size_t coarse_vertices = 6000;
constexpr std::size_t cell_samples = 30000;
constexpr double least_telling = 0.5; ///< part of a surface

std::vector<Vec3> turned(std::vector<Vec3> directions, const Mat3& turn) {
    for (Vec3& direction : directions)
        direction = turn * direction;
    return directions;
}

/// The levels that `mark` chooses for meshes of so many vertices or more.
std::vector<unsigned> usual_levels(std::span<const unsigned> levels, std::size_t vertices) {
    key::PublicParameters parameters;
    parameters.levels.assign(levels.begin(), levels.end());
    std::vector<unsigned> usual;
    for (const std::size_t marked : {std::numeric_limits<std::size_t>::max(), vertices})
        for (const Profile profile : {Profile::masked, Profile::robust})
            if (const unsigned level = default_level(parameters, marked, profile);
                std::ranges::find(usual, level) == usual.end())
                usual.push_back(level);
    return usual;
}

} // namespace

unsigned default_level(const key::PublicParameters& parameters, std::size_t vertices, Profile profile) {
    const std::size_t enough = key::sequence_length(profile == Profile::masked ? 4 : 5);
    const int preferred = enough <= vertices ? 5 : 4;
    const auto distance = [&](unsigned level) { return std::abs(static_cast<int>(level) - preferred); };
    return *std::ranges::min_element(parameters.levels, {}, distance);
}

ExaminationOptions examination_options(const key::PublicParameters& parameters, std::size_t vertices) {
    ExaminationOptions options;
    options.vertices = vertices;
    options.levels = parameters.levels;
    options.rmax = parameters.rmax;
    return options;
}

Examination::Examination(const TriangleMesh& suspect, ExaminationOptions options, const Progress& progress)
    : Examination(options.resync == Resync::pca ? prepare_suspect(suspect, options.vertices, progress)
                                                : simplify_suspect(suspect, options.vertices, progress),
                  options, progress) {}

Examination::Examination(const Suspect& suspect, ExaminationOptions options, const Progress& progress)
    : options_(std::move(options)),
      usual_levels_(usual_levels(options_.levels, suspect.mesh.positions.size())),
      finest_(std::ranges::max(options_.levels)), base_vertices_(suspect.base.positions.size()),
      diagonal_(surface_box(suspect.mesh).diagonal()), stop_(suspect.stop), telling_(suspect.telling) {
    notify(progress, "examining the surface", 0);
    make_poses(suspect, progress);
    gather_evidence(suspect.base);
    make_family();
    notify(progress, "examining the surface", 1);
}

void Examination::look(View& view, const TriangleMesh& base) const {
    view.base = to_frame(base, view.frame);
    view.evidence = std::make_unique<detect::Evidence>(view.base, options_.evidence);
}

void Examination::gather_evidence(const TriangleMesh& base) {
    // Views of nearly one scale differ in their centre alone, and that is cheap.
    constexpr double alike = 0.1;
    const View& first = views_.front();
    parallel_blocks(views_.size(), 1, [&](std::size_t v, std::size_t) {
        View& view = views_[v];
        if (view.evidence)
            return;
        if (v == 0 || std::abs(view.frame.scale / first.frame.scale - 1) > alike)
            look(view, base);
        else
            view.base = to_frame(base, view.frame);
    });
    for (View& view : views_)
        if (!view.evidence)
            view.evidence = std::make_unique<detect::Evidence>(
                first.evidence->seen_from(first.frame.to_canonical(view.frame.centroid)));
}

/// The evidence about the first centre waits for no coarser mesh. It comes last where nobody else takes it, since a thread
/// that is done with something else by then can take part in it, and not in the hierarchy.
resync::Hierarchy Examination::first_look(const Suspect& suspect, const WholeSurface& whole,
                                          const Progress& progress) {
    View& first = views_[view_of(whole.axes.front().frame)];
    resync::Hierarchy hierarchy;
    parallel_invoke(
        [&] { look(first, suspect.base); },
        [&] { hierarchy = resync::make_hierarchy(whole.moments, suspect.mesh, suspect.base, {}, progress); });
    return hierarchy;
}

void Examination::add_principal_poses(const Suspect& suspect, const Progress& progress) {
    const std::shared_ptr<const WholeSurface> whole = suspect.whole_surface();
    const resync::Hierarchy hierarchy = first_look(suspect, *whole, progress);
    for (const WholeSurface::Axes& axes : whole->axes) {
        const resync::FrameEstimate estimate =
            resync::estimate_frame(axes.frame, suspect.mesh.positions.size(), hierarchy, axes.substance);
        ambiguity_ = std::max(ambiguity_, estimate.ambiguity);
        moment_gap_ = std::min(moment_gap_, resync::least_gap(estimate.moments));
        for (const resync::CandidatePose& candidate : resync::candidate_poses(estimate))
            add_pose(candidate);
        for (const resync::CandidatePose& before : axes.before_smoothing)
            for (const Frame& choice : sign_choices(before.frame))
                add_pose({choice, before.origin, before.likely});
    }
}

void Examination::make_poses(const Suspect& suspect, const Progress& progress) {
    if (options_.resync == Resync::none)
        add_pose({canonical_frame(suspect.mesh), "canonical frame"});
    if (options_.resync == Resync::pca)
        add_principal_poses(suspect, progress);
    for (const resync::CandidatePose& candidate : options_.poses)
        add_pose(candidate);
    if (poses_.empty())
        throw ParameterError(
            "there is no pose to examine the suspect in; give a receipt or a reference, or let the "
            "suspect's own axes tell it");
}

std::size_t Examination::view_of(const Frame& frame) {
    const auto found = std::ranges::find_if(views_, [&](const View& view) {
        return view.frame.centroid == frame.centroid && view.frame.scale == frame.scale;
    });
    const auto number = static_cast<std::size_t>(found - views_.begin());
    if (found == views_.end())
        views_.push_back({frame, {}, nullptr});
    return number;
}

void Examination::add_pose(const resync::CandidatePose& candidate) {
    Pose pose{candidate, view_of(candidate.frame), Mat3::Identity()};
    pose.turn = candidate.frame.axes * views_[pose.view].frame.axes.transpose();
    poses_.push_back(std::move(pose));
}

std::vector<sphere::SparseRows> Examination::rows(std::size_t pose, std::span<const unsigned> levels) const {
    return sphere::barycentric_rows(finest_, turned(view(pose).base.positions, poses_[pose].turn), levels);
}

sphere::SparseRows Examination::rows(std::size_t pose, unsigned level) const {
    if (pose == 0) {
        const auto found = std::ranges::find(levels_of(0), level);
        if (found != levels_of(0).end())
            return first_rows_[static_cast<std::size_t>(found - levels_of(0).begin())];
    }
    return std::move(rows(pose, std::span(&level, 1)).front());
}

void Examination::make_family() {
    const std::vector<Leader> leaders = leading_poses();
    std::vector<std::vector<detect::Hypothesis>> of_pose(poses_.size());
    parallel_blocks(poses_.size(), 1, [&](std::size_t pose, std::size_t) {
        if (leaders[pose].axis)
            return;
        std::vector<sphere::SparseRows> at_vertices = rows(pose, levels_of(pose));
        add_hypotheses(of_pose[pose], pose, at_vertices, nullptr);
        if (pose == 0)
            first_rows_ = std::move(at_vertices);
        if (base_vertices_ >= coarse_vertices)
            return;
        const detect::CellSamples samples(view(pose).base, cell_samples);
        add_hypotheses(of_pose[pose], pose,
                       sphere::barycentric_rows(finest_, turned(samples.positions(), poses_[pose].turn),
                                                levels_of(pose)),
                       &samples);
    });
    std::array<std::shared_ptr<const std::vector<Index>>, 3> turns;
    if (std::ranges::any_of(leaders, [](const Leader& l) {
            return l.axis.has_value();
        })) // not needed by a receipt's pose alone
        std::ranges::transform(sphere::half_turns(finest_), turns.begin(), [](std::vector<Index>& turn) {
            return std::make_shared<const std::vector<Index>>(std::move(turn));
        });
    for (std::size_t pose = 0; pose < poses_.size(); ++pose) {
        const Leader& leader = leaders[pose];
        if (!leader.axis)
            continue;
        of_pose[pose] = of_pose[leader.pose];
        for (detect::Hypothesis& h : of_pose[pose]) {
            h.pose = pose;
            h.turn = turns[*leader.axis];
        }
    }
    for (std::vector<detect::Hypothesis>& hypotheses : of_pose)
        std::ranges::move(hypotheses, std::back_inserter(family_));
}

/// The choices of axis signs of a frame differ by half turns of the sphere, which only change places of its
/// vertices.
std::vector<Examination::Leader> Examination::leading_poses() const {
    std::vector<Leader> leaders;
    for (std::size_t pose = 0; pose < poses_.size(); ++pose) {
        Leader leader{pose, std::nullopt};
        for (std::size_t other = 0; other < pose && !leader.axis; ++other) {
            if (poses_[other].view != poses_[pose].view || leaders[other].axis)
                continue;
            if (const auto axis = sphere::half_turn_axis(poses_[pose].turn * poses_[other].turn.transpose()))
                leader = {other, static_cast<std::size_t>(*axis)};
        }
        leaders.push_back(leader);
    }
    return leaders;
}

const std::vector<unsigned>& Examination::levels_of(std::size_t pose) const {
    return poses_[pose].candidate.likely ? options_.levels : usual_levels_;
}

void Examination::add_hypotheses(std::vector<detect::Hypothesis>& hypotheses, std::size_t pose,
                                 std::span<const sphere::SparseRows> of_level,
                                 const detect::CellSamples* samples) const {
    const std::vector<unsigned>& levels = levels_of(pose);
    const detect::Evidence& seen = evidence(pose);
    const std::size_t filters = seen.filters();
    std::vector<std::optional<detect::LinearStatistic>> statistics(levels.size() * filters);
    parallel_blocks(statistics.size(), 1, [&](std::size_t k, std::size_t) {
        const std::size_t l = k / filters, f = k % filters;
        statistics[k] = samples ? seen.statistic(f, *samples, of_level[l], options_.rmax)
                                : seen.statistic(f, of_level[l], options_.rmax);
    });
    for (std::size_t k = 0; k < statistics.size(); ++k)
        hypotheses.push_back({*std::move(statistics[k]), levels[k / filters], pose, k % filters,
                              samples ? detect::Source::cells : detect::Source::vertices});
}

double Examination::expected_sigmas(Sequences& sequences, unsigned level, double strength, std::size_t pose,
                                    std::optional<std::size_t> filter) const {
    if (telling_ < least_telling)
        return 0;
    const double move = strength / 100 * diagonal_ / view(pose).frame.scale;
    const detect::Evidence& seen = evidence(pose);
    const sphere::SparseRows weights = rows(pose, level);
    const std::span<const double> w = sequences(level);
    std::vector<double> sigmas(filter ? 1 : seen.filters());
    parallel_blocks(sigmas.size(), 1, [&](std::size_t k, std::size_t) {
        sigmas[k] = seen.expected_sigmas(filter.value_or(k), weights, w, options_.rmax, move);
    });
    return *std::ranges::max_element(sigmas);
}

double Examination::gamma(Sequences& sequences, unsigned level, double strength, std::size_t pose) const {
    return evidence(pose).gamma(rows(pose, level), sequences(level),
                                strength / 100 * diagonal_ / view(pose).frame.scale);
}

std::vector<double> Examination::radii(std::size_t pose) const {
    const std::vector<Vec3>& positions = view(pose).base.positions;
    std::vector<double> r(positions.size());
    std::ranges::transform(positions, r.begin(), [](const Vec3& p) { return p.norm(); });
    return r;
}

} // namespace wm3d::watermark
