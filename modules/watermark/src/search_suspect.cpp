// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/search_suspect.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <wm3d/core/error.hpp>
#include <wm3d/detect/verdict.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/search/centres.hpp>
#include <wm3d/search/pose_search.hpp>
#include <wm3d/sphere/half_turns.hpp>
#include <wm3d/watermark/pieces.hpp>

namespace wm3d::watermark {

namespace {

constexpr double pairs_of_effort_one = 6000; ///< of a centre and a sequence
/// From which no cut that was measured (docs/resync.md) has its centre outside of the places that are tried.
constexpr double exhaustive_effort = 4;
constexpr double pairs_of_whole = 1000; ///< of what has no opening: its centre can't be far away
constexpr double pairs_about_own_centre = 24;
/// Relative distance of two moments below which a stretch of 2 % can turn the axes by more than 6 degrees.
constexpr double steady_gap = 0.2;
/// Of the lattices of centres, in mean radii. At the usual strength a centre 0.03 off still shows a mark
/// clearly; a centre 0.045 off shows most, for a third of the time.
/// A mark of the default visibility needs a centre within 0.03, and within 0.02 to stand out clearly.
constexpr double wide_covering = 0.045, fine_covering = 0.03, close_covering = 0.02;

/// The quick looks at mirror images and pieces have half of the search's share, the lattice of poses the
/// other.
const double log10_half_share = std::log10(search_share / 2);

/// Which centres of a piece are searched.
enum class Extent {
    none, ///< its own axes are clear and nothing was cut off
    near, ///< around its own, at the likeliest levels, as a deformation may have turned its axes
    own,  ///< around its own, as its axes are unclear
    all,  ///< wherever its openings suggest
};

/// Filters whose T is searched, one after the other. What nothing was cut from may be as it was marked, and has few
/// centres.
std::vector<std::size_t> filters(Extent extent) {
    if (extent == Extent::own)
        return {search::SearchOptions{}.filter, detect::folds_as_marked};
    return {search::SearchOptions{}.filter};
}

/// A piece of the suspect that is examined as if it were all.
struct Piece {
    const Suspect* suspect;
    search::Outline outline;
    std::optional<std::size_t> number; ///< none: the suspect itself
    Extent extent = Extent::none;
};

/// The base of a suspect around its centroid, in mean radii.
struct Units {
    search::Outline outline;
    TriangleMesh base;

    explicit Units(const Piece& piece) : outline(piece.outline), base(piece.suspect->base) {
        if (!(outline.radius > 0))
            throw GeometryError("all of the surface lies in one point, so it has no pose to search for");
        for (Vec3& p : base.positions)
            p = (p - outline.centroid) / outline.radius;
    }
    Vec3 in_file(const Vec3& p) const { return outline.centroid + outline.radius * p; }
};

class SuspectSearch {
public:
    SuspectSearch(const Suspect& suspect, const Examination& seen, Sequences& sequences,
                  const SearchEffort& effort, double reference_strength, double log10_pf,
                  const Progress& progress)
        : suspect_(suspect), seen_(seen), sequences_(sequences), effort_(effort),
          reference_strength_(reference_strength), log10_pf_(log10_pf), progress_(progress) {}

    SearchResult run();

private:
    Extent extent(const search::Outline& outline, const Examination& seen) const;
    std::optional<TooFewVertices> too_few(const Piece& piece) const;
    void leave_out_small(std::vector<Piece>& order);
    double pairs_for(const Piece& piece, double wide) const;
    bool look_at_mirror_image();
    bool look_at_piece(Piece& piece);
    void leave_to_whole(std::vector<Piece>& order) const;
    bool search_piece(const Piece& piece, double pairs);
    bool confirm(const Piece& piece, const Units& units, const search::Candidate& candidate);
    bool take(std::unique_ptr<Examination> examination, double log10_price, FoundPose pose);
    std::vector<search::Target> targets(const Piece& piece, const Units& units, double pairs);
    std::vector<Vec3> lattice_of_centres(const Units& units, double covering, double pairs) const;
    std::vector<unsigned> ordered_levels(std::size_t vertices) const;
    const search::KeyFunction& key(unsigned level);
    double expected(const Units& units, const detect::Evidence& evidence, const Suspect& piece,
                    const search::SearchOptions& options);

    const Suspect& suspect_;
    const Examination& seen_;
    Sequences& sequences_;
    const SearchEffort& effort_;
    double reference_strength_, log10_pf_;
    const Progress& progress_;
    std::map<unsigned, sphere::Icosphere> spheres_;
    std::map<unsigned, search::KeyFunction> keys_;
    std::vector<Vec3> wide_, fine_, close_; ///< lattices of centres about the piece that is searched
    std::size_t piece_count_ = 1;
    SearchResult result_;
};

const search::KeyFunction& SuspectSearch::key(unsigned level) {
    const auto found = keys_.find(level);
    if (found != keys_.end())
        return found->second;
    const sphere::Icosphere& sphere = spheres_.try_emplace(level, level).first->second;
    const std::span<const double> w = sequences_(level);
    return keys_.try_emplace(level, sphere, std::vector<double>(w.begin(), w.end()), seen_.options().rmax)
        .first->second;
}

/// Whether the mark is in this pose, everything that was tried and could have been tried paid for.
bool SuspectSearch::take(std::unique_ptr<Examination> examination, double log10_price, FoundPose pose) {
    detect::FamilyScore score = detect::score_family(examination->family(), sequences_.function());
    score.log10_p = std::min(0.0, score.log10_p + log10_price);
    const bool better = !result_.hit || score.log10_p < result_.hit->score.log10_p;
    if (score.log10_p > log10_pf_ || !better)
        return score.log10_p <= log10_pf_;
    result_.report.log10_hypotheses = std::log10(static_cast<double>(score.hypotheses)) + log10_price;
    result_.report.pose = std::move(pose);
    result_.hit = SearchHit{std::move(examination), score};
    return true;
}

/// The mirror image of every pose that was tried: its statistic is the same, of the opposite vertices'
/// heights.
bool SuspectSearch::look_at_mirror_image() {
    std::map<unsigned, std::vector<double>> mirrored;
    const auto sequence = [&](unsigned level) -> std::span<const double> {
        std::vector<double>& w = mirrored[level];
        if (w.empty())
            for (const Index opposite : sphere::inversion(sphere::Icosphere(level)))
                w.push_back(sequences_(level)[opposite]);
        return w;
    };
    const detect::FamilyScore score = detect::score_family(seen_.family(), sequence);
    const double log10_price = std::log10(static_cast<double>(piece_count_)) - log10_half_share;
    if (score.log10_p + log10_price > log10_pf_)
        return false;
    Frame frame = seen_.pose(seen_.family()[score.best.hypothesis].pose).frame;
    frame.axes = -frame.axes;
    ExaminationOptions options = seen_.options();
    options.resync = Resync::icp;
    options.poses = {{frame, "mirror image"}};
    auto examination = std::make_unique<Examination>(suspect_, options, progress_);
    // That is one pose of the many that were tried.
    const double poses =
        static_cast<double>(seen_.family().size()) / static_cast<double>(examination->family().size());
    return take(std::move(examination), log10_price + std::log10(poses), {frame, {}, Mat3::Zero(), true, {}});
}

/// A piece of a scene in the poses that its own axes tell.
bool SuspectSearch::look_at_piece(Piece& piece) {
    ExaminationOptions options = seen_.options();
    options.resync = Resync::pca;
    options.poses.clear();
    auto examination = std::make_unique<Examination>(*piece.suspect, options, progress_);
    piece.extent = extent(piece.outline, *examination);
    const std::size_t best =
        detect::score_family(examination->family(), sequences_.function()).best.hypothesis;
    const Frame frame = examination->pose(examination->family()[best].pose).frame;
    return take(std::move(examination), std::log10(static_cast<double>(piece_count_)) - log10_half_share,
                {frame, {}, Mat3::Zero(), false, piece.number});
}

std::vector<Vec3> SuspectSearch::lattice_of_centres(const Units& units, double covering, double pairs) const {
    search::CentreOptions options;
    options.covering = covering;
    search::Outline unit = units.outline;
    unit.centroid.setZero();
    unit.radius = 1;
    return search::centres(unit, static_cast<std::size_t>(std::clamp(std::ceil(pairs), 0.0, 1e6)), options);
}

/// The levels, the likeliest for a suspect of so many vertices first. A cut copy may have few left.
std::vector<unsigned> SuspectSearch::ordered_levels(std::size_t vertices) const {
    std::vector<unsigned> levels = seen_.options().levels;
    key::PublicParameters parameters;
    parameters.levels = levels;
    const unsigned likely = default_level(parameters, vertices);
    const auto rank = [&](unsigned level) {
        return level == likely ? 0 : level == 5 ? 1 : level == 4 ? 2 : 3;
    };
    std::ranges::stable_sort(levels, {}, rank);
    return levels;
}

/// The likeliest places at the two likeliest levels, and closer together; then the likeliest level on a wide and on a
/// fine lattice of centres in turn, the next level, the mirror image, and the rest. A weak mark shows on the fine one
/// alone, a strong one is found sooner on the wide one.
std::vector<search::Target> SuspectSearch::targets(const Piece& piece, const Units& units, double pairs) {
    const std::vector<unsigned> levels = ordered_levels(piece.suspect->mesh.positions.size());
    const bool everywhere = piece.extent == Extent::all;
    wide_ = lattice_of_centres(units, wide_covering, pairs * (everywhere ? 0.35 : 1));
    fine_ = everywhere ? lattice_of_centres(units, fine_covering, pairs * 0.38) : std::vector<Vec3>{};
    close_ = everywhere ? lattice_of_centres(units, close_covering, pairs * 0.15) : std::vector<Vec3>{};
    std::vector<search::Target> result;
    const auto look = [&](std::size_t level, const std::vector<Vec3>& centres, double from, double to,
                          bool mirrored = false) {
        const auto at = [&](double part) {
            return std::min(centres.size(), static_cast<std::size_t>(std::ceil(part)));
        };
        if (level < levels.size() && at(from) < at(to))
            result.push_back({levels[level], &key(levels[level]), mirrored,
                              std::span(centres).subspan(at(from), at(to) - at(from))});
    };
    const auto fine = static_cast<double>(fine_.size());
    const auto wide = [&](double part) {
        return (everywhere ? part : 1) * static_cast<double>(wide_.size());
    };
    constexpr double soon = 128, likely = 600; // centres of the wide lattice, which has most after these
    look(0, wide_, 0, soon);
    look(1, wide_, 0, std::min(soon, wide(0.35)));
    if (piece.extent == Extent::near)
        return result;
    look(0, close_, 0, static_cast<double>(close_.size()));
    look(0, wide_, soon, likely);
    look(0, fine_, 0, 0.4 * fine);
    look(0, wide_, likely, wide(1));
    look(0, fine_, 0.4 * fine, fine);
    look(1, wide_, soon, wide(0.35));
    look(0, wide_, 0, wide(0.2), true);
    for (std::size_t level = 2; level < levels.size(); ++level)
        look(level, wide_, 0, wide(0.1));
    return result;
}

double SuspectSearch::expected(const Units& units, const detect::Evidence& evidence, const Suspect& piece,
                               const search::SearchOptions& options) {
    const unsigned level = ordered_levels(piece.mesh.positions.size()).front();
    const double move = reference_strength_ / 100 * surface_box(piece.mesh).diagonal() / units.outline.radius;
    const sphere::SparseRows rows = sphere::barycentric_rows(key(level).sphere(), units.base.positions);
    const std::vector<double> mark = evidence.mark_weights_at(options.filter, rows, sequences_(level), move);
    return search::expected_sigmas(units.base.positions, evidence, mark, key(level), fine_covering, options);
}

/// The exact statistic at the nearest pose of the lattice.
bool SuspectSearch::confirm(const Piece& piece, const Units& units, const search::Candidate& candidate) {
    const search::Pose pose = search::PoseLattice{}.nearest(candidate.pose);
    FoundPose found{{units.in_file(pose.centre), pose.turn, 1},
                    pose.deformation,
                    pose.stretch,
                    pose.mirrors(),
                    piece.number};
    Frame frame = found.frame;
    TriangleMesh mesh = piece.suspect->mesh, base = units.base;
    if (pose.deformation != search::Deformation::none) {
        for (Vec3& p : base.positions)
            p = pose.undeformed(p);
        for (Vec3& p : mesh.positions)
            p = pose.undeformed((p - units.outline.centroid) / units.outline.radius);
        frame.centroid.setZero();
    } else {
        base = piece.suspect->base;
    }
    frame.scale = mean_radius(mesh, frame.centroid);
    found.frame.scale =
        pose.deformation == search::Deformation::none ? frame.scale : frame.scale * units.outline.radius;
    ExaminationOptions options = seen_.options();
    options.resync = Resync::icp;
    options.poses = {{frame, "search"}};
    const Suspect undeformed{mesh, std::move(base), piece.suspect->stop, piece.suspect->telling};
    return take(std::make_unique<Examination>(undeformed, options),
                log10_search_price(pose.deformation, piece_count_), std::move(found));
}

bool SuspectSearch::search_piece(const Piece& piece, double pairs) {
    const Units units(piece);
    const detect::Evidence evidence(units.base, seen_.options().evidence);
    search::SearchOptions options;
    options.deformation = effort_.deformation;
    if (piece.extent == Extent::near)
        options.finalists = 2;
    const std::vector<search::Target> wanted = targets(piece, units, pairs);
    SearchReport& report = result_.report;
    const bool is_first = report.centres == 0;
    double expected_here = 0;
    bool found = false;
    for (const std::size_t filter : filters(piece.extent)) {
        options.filter = std::min(filter, evidence.filters() - 1);
        expected_here = std::max(expected_here, expected(units, evidence, *piece.suspect, options));
        const search::SearchOutcome outcome = search::search_poses(
            units.base.positions, evidence, wanted,
            [&](const search::Candidate& candidate) { return confirm(piece, units, candidate); }, options,
            progress_);
        report.centres += outcome.centres;
        report.rotations += outcome.rotations;
        found = outcome.accepted;
        if (found)
            break;
    }
    report.expected_sigmas = is_first ? expected_here : std::min(report.expected_sigmas, expected_here);
    return found;
}

Extent SuspectSearch::extent(const search::Outline& outline, const Examination& seen) const {
    if (effort_.asked || may_be_part(outline))
        return Extent::all;
    if (seen.ambiguity() != resync::Ambiguity::none)
        return Extent::own;
    return seen.moment_gap() < steady_gap ? Extent::near : Extent::none;
}

/// Pairs of a centre and a sequence that a piece gets, if `wide` of them are searched everywhere.
double SuspectSearch::pairs_for(const Piece& piece, double wide) const {
    if (piece.extent != Extent::all)
        return pairs_about_own_centre;
    const bool whole =
        !may_be_part(piece.outline) && piece.outline.opening < search::CentreOptions{}.least_opening;
    return std::min(pairs_of_effort_one / wide, whole ? pairs_of_whole : pairs_of_effort_one);
}

/// Where a piece is nearly all of the suspect, as a cut leaves crumbs, the suspect is searched first, and for it.
void SuspectSearch::leave_to_whole(std::vector<Piece>& order) const {
    constexpr double nearly_all = 0.8;
    const double whole = surface_area(suspect_.mesh);
    const auto large = std::ranges::find_if(order, [&](const Piece& piece) {
        return piece.number && surface_area(piece.suspect->mesh) > nearly_all * whole;
    });
    if (large == order.end() || order.back().extent != Extent::all)
        return;
    large->extent = Extent::none;
    std::rotate(order.begin(), order.end() - 1, order.end());
}

std::optional<TooFewVertices> SuspectSearch::too_few(const Piece& piece) const {
    const std::size_t vertices = piece.suspect->base.positions.size();
    const double needed =
        detect::normal_sigmas(log10_pf_ - log10_search_price(search::Deformation::none, piece_count_));
    const double most = detect::most_sigmas(vertices);
    return most < needed ? std::optional(TooFewVertices{vertices, most, needed}) : std::nullopt;
}

/// Pieces that can show no mark by a search are not searched.
void SuspectSearch::leave_out_small(std::vector<Piece>& order) {
    std::optional<TooFewVertices>& left_out = result_.report.too_few;
    for (Piece& piece : order) {
        const std::optional<TooFewVertices> small = too_few(piece);
        if (piece.extent == Extent::none || !small)
            continue;
        piece.extent = Extent::none;
        if (!left_out || left_out->vertices < small->vertices)
            left_out = small;
    }
    if (std::ranges::any_of(order, [](const Piece& piece) { return piece.extent != Extent::none; }))
        left_out.reset();
}

SearchResult SuspectSearch::run() {
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<TriangleMesh> parts = pieces(suspect_.mesh);
    std::vector<Suspect> suspects;
    for (const TriangleMesh& part : parts)
        suspects.push_back(prepare_suspect(part, seen_.options().vertices, progress_));
    std::vector<Piece> order;
    for (std::size_t k = 0; k < suspects.size(); ++k)
        order.push_back({&suspects[k], suspects[k].whole_surface()->outline, k});
    const search::Outline outline = suspect_.whole_surface()->outline;
    order.push_back({&suspect_, outline, {}, extent(outline, seen_)});
    piece_count_ = order.size();
    result_.report.pieces = order.size();

    bool found = look_at_mirror_image();
    for (std::size_t k = 0; k + 1 < order.size() && !found; ++k)
        found = look_at_piece(order[k]);
    leave_to_whole(order);
    leave_out_small(order);
    const auto wide = std::ranges::count(order, Extent::all, &Piece::extent);
    const bool open = std::ranges::any_of(
        order, [](const Piece& piece) { return piece.extent == Extent::all && may_be_part(piece.outline); });
    result_.report.enough = open ? exhaustive_effort * static_cast<double>(wide) : 1;
    result_.report.complete = effort_.effort >= result_.report.enough;
    for (std::size_t k = 0; k < order.size() && !found && effort_.effort > 0; ++k)
        if (order[k].extent != Extent::none && order[k].suspect->telling > 0)
            found = search_piece(order[k], effort_.effort * pairs_for(order[k], static_cast<double>(wide)));
    result_.report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return std::move(result_);
}

} // namespace

bool may_be_part(const search::Outline& outline) {
    constexpr double tolerated_opening = 0.006;
    return outline.opening > tolerated_opening || outline.stump > search::CentreOptions{}.least_stump ||
           outline.closed > 0;
}

double log10_search_price(search::Deformation deformation, std::size_t pieces) {
    constexpr double deformations = 3; // none, affine, bent
    return search::PoseLattice{}.log10_size(deformation) + std::log10(deformations) +
           std::log10(static_cast<double>(pieces)) - log10_half_share;
}

double beside_search(double log10_p) {
    return std::min(0.0, log10_p - std::log10(1 - search_share));
}

SearchResult search_suspect(const Suspect& suspect, const Examination& seen, Sequences& sequences,
                            const SearchEffort& effort, double reference_strength, double log10_pf,
                            const Progress& progress) {
    if (!(effort.effort >= 0))
        throw ParameterError("the effort of a search can't be negative; 1 is the usual one, 0 is none");
    return SuspectSearch(suspect, seen, sequences, effort, reference_strength, log10_pf, progress).run();
}

} // namespace wm3d::watermark
