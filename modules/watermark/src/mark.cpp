// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/mark.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/detect/verdict.hpp>
#include <wm3d/embed/turned_faces.hpp>
#include <wm3d/masking/creases.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/shaping/shaping.hpp>
#include <wm3d/sphere/bumped_sphere.hpp>
#include <wm3d/sphere/sparse_rows.hpp>

namespace wm3d::watermark {

namespace {

Profile profile_of(const MarkOptions& options) {
    return options.gamma ? Profile::paper : options.profile;
}

unsigned level_of(const TriangleMesh& mesh, const key::Key& key, const MarkOptions& options) {
    const std::vector<unsigned>& levels = key.parameters().levels;
    const unsigned level =
        options.level.value_or(default_level(key.parameters(), mesh.positions.size(), profile_of(options)));
    if (std::ranges::find(levels, level) == levels.end())
        throw ParameterError(
            fmt::format("the key admits marks of level {} and not of {}, so verify would not look for "
                        "it; choose one of them or make a key with `keygen --levels`",
                        fmt::join(levels, ", "), level));
    return level;
}

void require_move(double rms) {
    if (!(rms > 0))
        throw GeometryError(
            "no radial move of this surface shows along its normals, so it can't be marked; a closed "
            "or curved model can");
}

/// Trial marks of the masks: a family that no key and no trial draws from.
constexpr std::uint64_t mask_family = 0x6d61736b;

/// RMS move of the first trial, % of the diagonal: about what a visibility of 0.1 comes to on a scan.
constexpr double first_strength = 0.02;

/// Meshes of more vertices don't fit a processor's caches.
constexpr std::size_t worth_sorting = 20'000;

/// On meshes of more vertices nothing is made at once that takes memory while it is made.
constexpr std::size_t large = 60'000;

/// Triangles of meshes of more vertices are too small for a crease to be seen, and their hinges take much memory.
constexpr std::size_t most_creased = 200'000;

maps::BaseDomain base_domain(const TriangleMesh& canonical, std::size_t vertices, const Progress& progress) {
    simplify::Options options;
    options.target_vertices = vertices;
    return maps::parameterize(canonical, options, progress);
}

} // namespace

std::string_view name(Profile profile) {
    switch (profile) {
    case Profile::masked:
        return "masked";
    case Profile::robust:
        return "robust";
    default:
        return "paper";
    }
}

embed::Distortion percent(const embed::Distortion& distortion, double diagonal) {
    const double scale = diagonal > 0 ? 100 / diagonal : 0;
    return {distortion.normal_rms * scale, distortion.vertex_rms * scale, distortion.max * scale};
}

/// The base domain and the details over it.
struct Marker::Base {
    maps::BaseDomain domain;
    embed::DetailedMesh detailed; ///< refers to `domain`

    Base(const TriangleMesh& canonical, std::size_t vertices, const Progress& progress)
        : domain(base_domain(canonical, vertices, progress)), detailed(canonical, domain.mesh, domain.point) {
    }
};

/// The carriers of a level.
struct Marker::Carried {
    std::optional<sphere::SparseRows> rows; ///< B for all vertices, unless they are many
    masking::Carriers carriers;
    std::optional<masking::Creases> creases; ///< unless the mesh is large
    double usual_factor =
        0; ///< of moves that are seen about as much as `default_visibility`; 0 where unknown
};

/// What was needed so far.
struct Marker::Made {
    std::mutex guard;
    std::optional<TriangleMesh> canonical;
    std::unique_ptr<Base> base;
    std::unique_ptr<masking::Budget> budget;
    std::map<unsigned, Carried> carried;
};

Marker::Marker(const TriangleMesh& mesh, std::size_t vertices, const Progress& progress)
    : sorted_(mesh.positions.size() > worth_sorting ? along_curve(mesh) : Reordered{}),
      mesh_(sorted_.original.empty() ? mesh : sorted_.mesh), vertices_(vertices), progress_(progress),
      moments_(shape_moments(mesh_)), frame_(principal_frame(mesh_, moments_.own())),
      diagonal_(surface_box(mesh_).diagonal()), made_(std::make_unique<Made>()) {}

Marker::~Marker() = default;

const TriangleMesh& Marker::canonical() const {
    if (!made_->canonical)
        made_->canonical = to_frame(mesh_, frame_);
    return *made_->canonical;
}

const Marker::Base& Marker::base() const {
    const std::lock_guard lock(made_->guard);
    if (!made_->base)
        made_->base = std::make_unique<Base>(canonical(), vertices_, progress_);
    return *made_->base;
}

const masking::Budget& Marker::budget() const {
    const std::lock_guard lock(made_->guard);
    return made_budget();
}

const masking::Budget& Marker::made_budget() const {
    if (!made_->budget)
        made_->budget = std::make_unique<masking::Budget>(mesh_);
    return *made_->budget;
}

/// What doesn't depend on each other is made at once, but on large meshes, where each takes memory while it is made.
Marker::Carried Marker::fresh_carriers(unsigned level) const {
    std::optional<Carried> fresh;
    const auto make = [&] { fresh = Carried{std::nullopt, masking::Carriers(mesh_, frame_), std::nullopt}; };
    if (mesh_.positions.size() <= large) {
        parallel_invoke([&] { made_budget(); }, make);
        fresh->rows = rows(level, 0, mesh_.positions.size());
    } else {
        made_budget();
        make();
    }
    return *std::move(fresh);
}

/// Weighs the mask by a trial mark.
void Marker::weigh(Carried& carried, unsigned level) const {
    masking::Carriers& carriers = carried.carriers;
    const std::vector<double> moves = carriers.carry(
        bumps(carried, level, key::watermark_sequence(key::null_secret(mask_family, 0), level, 0.1)));
    const double rms = percent_of_diagonal(carriers.rms(moves));
    if (!(rms > 0))
        return;
    const auto trial = [&](double strength) { return moved(carriers, moves, strength / rms); };
    carried.usual_factor = made_budget().equalize(carriers, trial, default_visibility, first_strength) / rms;
}

/// \param meanwhile  done with the carriers, while they are weighed if they are new
const Marker::Carried& Marker::carried(unsigned level, const Meanwhile& meanwhile) const {
    const std::lock_guard lock(made_->guard);
    auto found = made_->carried.find(level);
    if (found == made_->carried.end()) {
        Carried fresh = fresh_carriers(level);
        parallel_invoke(
            [&] {
                if (meanwhile)
                    meanwhile(fresh);
                if (mesh_.positions.size() <= large)
                    fresh.creases.emplace(mesh_, fresh.carriers.normals());
            },
            [&] { weigh(fresh, level); });
        found = made_->carried.emplace(level, std::move(fresh)).first;
    } else if (meanwhile) {
        meanwhile(found->second);
    }
    return found->second;
}

/// B for some vertices.
sphere::SparseRows Marker::rows(unsigned level, std::size_t begin, std::size_t end) const {
    std::vector<Vec3> places(end - begin);
    std::transform(mesh_.positions.begin() + static_cast<std::ptrdiff_t>(begin),
                   mesh_.positions.begin() + static_cast<std::ptrdiff_t>(end), places.begin(),
                   [&](const Vec3& p) { return frame_.to_canonical(p); });
    return sphere::barycentric_rows(sphere::Icosphere(level), places);
}

std::vector<double> Marker::bumps(const Carried& with, unsigned level, std::span<const double> w) const {
    if (with.rows)
        return with.carriers.bumps(*with.rows, w);
    constexpr std::size_t some = 1 << 17; // whose rows are held at a time
    std::vector<double> heights;
    heights.reserve(mesh_.positions.size());
    for (std::size_t begin = 0; begin < mesh_.positions.size(); begin += some) {
        const std::vector<double> next =
            sphere::multiply(rows(level, begin, std::min(begin + some, mesh_.positions.size())), w);
        heights.insert(heights.end(), next.begin(), next.end());
    }
    return with.carriers.bumps(std::move(heights));
}

const maps::BaseDomain& Marker::domain() const {
    return base().domain;
}

const masking::Carriers& Marker::carriers(unsigned level) const {
    return carried(level).carriers;
}

double Marker::visible(const std::vector<Vec3>& positions) const {
    if (sorted_.original.empty())
        return budget().visible(positions);
    std::vector<Vec3> sorted(positions.size());
    std::ranges::transform(sorted_.original, sorted.begin(), [&](Index v) { return positions[v]; });
    return budget().visible(sorted);
}

std::vector<Vec3> Marker::in_given_order(const std::vector<Vec3>& positions) const {
    if (sorted_.original.empty())
        return positions;
    std::vector<Vec3> given(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
        given[sorted_.original[i]] = positions[i];
    return given;
}

double Marker::percent_of_diagonal(double radii) const {
    return 100 * radii * frame_.scale / diagonal_;
}

std::vector<Vec3> Marker::in_file(std::span<const Vec3> moved) const {
    std::vector<Vec3> positions = mesh_.positions;
    for (std::size_t i = 0; i < moved.size(); ++i)
        if (moved[i] != made_->canonical->positions[i]) // what did not move keeps its exact coordinates
            positions[i] = frame_.from_canonical(moved[i]);
    return positions;
}

std::vector<Vec3> Marker::moved(const masking::Carriers& carriers, std::span<const double> moves,
                                double factor) const {
    constexpr std::size_t block = 16384;
    std::vector<Vec3> positions = mesh_.positions;
    parallel_blocks(positions.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            positions[i] += factor * frame_.scale * moves[i] * carriers.normals()[i];
    });
    return positions;
}

namespace {

/// The shaped mark on a base domain, of about `rms` mean radii.
std::vector<Vec3> shaped_base(const TriangleMesh& base, std::span<const double> w, unsigned level, double rms,
                              double density) {
    const sphere::SparseRows rows = sphere::barycentric_rows(sphere::Icosphere(level), base.positions);
    const std::vector<double> moves = shaping::normal_moves(base, rows, w, rms, density);
    const std::vector<Vec3> normals = vertex_normals(base);
    std::vector<Vec3> moved = base.positions;
    for (std::size_t i = 0; i < moved.size(); ++i)
        moved[i] += rms * moves[i] * normals[i];
    return moved;
}

} // namespace

/// A mark whose size is still open.
struct Marker::Layout {
    masking::MarkOfStrength positions; ///< in the coordinates of the mesh, of a strength in % of the diagonal
    double unit = 0;                   ///< strength of the bumps of gamma 1
    double usual = 0; ///< strength that is seen about as much as `default_visibility`; 0 where unknown
};

Marker::Layout Marker::masked(std::span<const double> w, unsigned level) const {
    std::vector<double> smooth;
    double unit = 0;
    const Carried& with = carried(level, [&](const Carried& made) {
        smooth = bumps(made, level, w);
        unit = percent_of_diagonal(made.carriers.rms(smooth));
        smooth = made.carriers.smooth(std::move(smooth));
    });
    std::vector<double> moves = with.carriers.masked(std::move(smooth));
    const double rms = percent_of_diagonal(with.carriers.rms(moves));
    require_move(rms);
    return {[this, &with, moves = std::move(moves), rms](double strength) {
                return moved(with.carriers, moves, strength / rms);
            },
            unit, with.usual_factor * rms};
}

Marker::Layout Marker::bumpy(std::span<const double> w, unsigned level) const {
    const Base& on = base();
    const std::vector<Vec3>& base_positions = on.domain.mesh.positions;
    const sphere::BumpedSphere bumped(sphere::Icosphere(level), {w.begin(), w.end()});
    const auto marked = [&on, delta = bumped.deltas(base_positions)](double gamma) {
        return on.detailed.reconstruct(embed::mark_base(on.domain.mesh.positions, delta, gamma));
    };
    // The move is linear in gamma: one trial tells the gamma of any strength.
    constexpr double trial = 1e-3;
    const double unit = normal_rms(marked(trial)) / trial;
    require_move(unit);
    return {[this, marked, unit](double strength) { return in_file(marked(strength / unit)); }, unit};
}

Marker::Layout Marker::shaped(std::span<const double> w, unsigned level) const {
    const Base& on = base();
    const double density =
        static_cast<double>(on.domain.mesh.positions.size()) / static_cast<double>(mesh_.positions.size());
    Layout layout;
    layout.unit = bumpy(w, level).unit;
    layout.positions = [this, &on, density, level, w = std::vector(w.begin(), w.end())](double strength) {
        const std::vector<Vec3>& still = on.domain.mesh.positions;
        const double rms = strength / 100 * diagonal_ / frame_.scale;
        std::vector<Vec3> moved = shaped_base(on.domain.mesh, w, level, rms, density);
        // That is the strength on the base; the full mesh's differs by what its details hide.
        const double factor = strength / normal_rms(on.detailed.reconstruct(moved));
        for (std::size_t i = 0; i < moved.size(); ++i)
            moved[i] = still[i] + factor * (moved[i] - still[i]);
        return in_file(on.detailed.reconstruct(moved));
    };
    return layout;
}

Marker::Layout Marker::layout(std::span<const double> w, Profile profile, unsigned level) const {
    switch (profile) {
    case Profile::masked:
        return masked(w, level);
    case Profile::robust:
        return shaped(w, level);
    default:
        return bumpy(w, level);
    }
}

double Marker::normal_rms(std::span<const Vec3> moved) const {
    return percent_of_diagonal(embed::distortion(*made_->canonical, moved).normal_rms);
}

/// Takes back what folds creases, which the budget doesn't see, and spends nothing of what that saves: it would go
/// into folds again.
void Marker::uncrease(Marked& marked, double visibility,
                      const std::optional<masking::WeightyWindows>& weighty) const {
    masking::CreaseOptions options;
    options.flat *= visibility / default_visibility;
    options.share *= visibility / default_visibility;
    const Carried& with = carried(marked.level);
    const std::vector<Vec3>& normals = with.carriers.normals();
    std::optional<masking::Creases> of_large;
    const masking::Creases& creases = with.creases ? *with.creases : of_large.emplace(mesh_, normals);
    std::vector<Vec3> positions =
        masking::without_creases(creases, mesh_, normals, marked.positions, options);
    embed::turn_back(mesh_, positions);
    if (positions == marked.positions)
        return;
    const double seen =
        weighty && !marked.seen_by_few ? budget().followed(positions, *weighty) : budget().visible(positions);
    if (seen > visibility) // where MSDM2 jumps
        return;
    marked.positions = std::move(positions);
    marked.msdm2 = seen;
}

Marked Marker::mark(const key::Secret& secret, const MarkSetting& setting) const {
    return mark(payload::mark_sequence(secret, setting.level, setting.rmax, setting.content, setting.shares),
                setting);
}

Marked Marker::mark(std::span<const double> w, const MarkSetting& setting) const {
    if (w.size() != key::sequence_length(setting.level))
        throw ParameterError(fmt::format("a mark of level {} takes {} numbers, but there are {}",
                                         setting.level, key::sequence_length(setting.level), w.size()));
    Marked marked;
    marked.level = setting.level;
    marked.rmax = setting.rmax;
    marked.frame = frame_;
    marked.ambiguity = resync::ambiguity_of(moments_.own());
    marked.diagonal = diagonal_;
    marked.profile = setting.gamma ? Profile::paper : setting.profile;
    const Layout layout = this->layout(w, marked.profile, setting.level);
    std::vector<char> still;
    std::optional<masking::WeightyWindows> weighty;
    const auto laid = [&](double strength) {
        std::vector<Vec3> positions = layout.positions(strength);
        for (std::size_t i = 0; i < still.size(); ++i)
            if (still[i])
                positions[i] = mesh_.positions[i];
        embed::turn_back(mesh_, positions);
        return positions;
    };
    double strength = setting.gamma ? *setting.gamma * layout.unit : setting.strength;
    if (setting.visibility && !setting.gamma) {
        const double seen = *setting.visibility;
        masking::Fit fit =
            layout.usual > 0
                ? budget().fit_near(laid, seen,
                                    masking::Budget::rescaled(layout.usual, default_visibility, seen))
                : budget().fit(laid, seen, first_strength);
        if (!(fit.strength > 0))
            throw TooVisible(fmt::format("no mark of this surface is seen with MSDM2 {:g} or less, however "
                                         "weak",
                                         seen));
        strength = fit.strength;
        still = std::move(fit.still);
        weighty = std::move(fit.weighty);
        marked.msdm2 = fit.msdm2;
        marked.seen_by_few = fit.by_few;
    }
    require_move(strength);
    marked.strength = strength;
    marked.gamma = strength / layout.unit;
    marked.base_vertices =
        marked.profile == Profile::masked ? mesh_.positions.size() : domain().mesh.positions.size();
    marked.positions = laid(strength);
    if (setting.visibility && marked.profile == Profile::masked && mesh_.positions.size() <= most_creased)
        uncrease(marked, *setting.visibility, weighty);
    marked.distortion = marked.profile == Profile::masked
                            ? embed::distortion(mesh_, marked.positions, carriers(setting.level).normals())
                            : embed::distortion(mesh_, marked.positions);
    marked.positions = in_given_order(marked.positions);
    return marked;
}

MarkSetting mark_setting(const TriangleMesh& mesh, const key::Key& key, const MarkOptions& options) {
    MarkSetting setting;
    setting.level = level_of(mesh, key, options);
    if (!(options.visibility > 0 && options.visibility <= 1))
        throw ParameterError(fmt::format("the visibility is {}, but MSDM2 lies above 0 and up to 1, for "
                                         "example 0.1",
                                         options.visibility));
    setting.rmax = options.rmax.value_or(key.parameters().rmax);
    setting.profile = options.profile;
    setting.gamma = options.gamma;
    setting.content = options.content;
    setting.shares = options.shares;
    if (options.strength)
        setting.strength = *options.strength;
    else
        setting.visibility = options.visibility;
    return setting;
}

namespace {

/// The mark, weaker where what a file makes of its positions is seen more than its budget allows.
Marked mark_as_stored(const Marker& marker, const key::Secret& secret, MarkSetting setting,
                      const Stored& stored) {
    constexpr int most_tries = 6;
    const double budget = *setting.visibility;
    Marked marked;
    for (int k = 0; k < most_tries; ++k) {
        marked = marker.mark(secret, setting);
        if (!marked.seen_by_few)
            break;
        marked.msdm2 = marker.visible(stored(marked.positions));
        if (*marked.msdm2 <= budget)
            break;
        setting.visibility = *setting.visibility * budget / *marked.msdm2;
    }
    return marked;
}

} // namespace

Marked mark(const TriangleMesh& mesh, const key::Key& key, const MarkOptions& options,
            const Progress& progress, const Stored& stored) {
    const MarkSetting setting = mark_setting(mesh, key, options); // before any work
    const Marker marker(mesh, options.vertices, progress);
    notify(progress, "marking", 0);
    Marked marked = stored && setting.visibility ? mark_as_stored(marker, key.secret(), setting, stored)
                                                 : marker.mark(key.secret(), setting);
    if (!marked.msdm2)
        marked.msdm2 = marker.visible(marked.positions);
    notify(progress, "marking", 1);
    return marked;
}

} // namespace wm3d::watermark
