// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/marker.hpp>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/embed/turned_faces.hpp>
#include <wm3d/key/stream.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/payload/sequence.hpp>

#include "marker_parts.hpp"

namespace wm3d::watermark {

namespace {

/// Meshes of more vertices don't fit a processor's caches.
constexpr std::size_t worth_sorting = 20'000;

/// Triangles of meshes of more vertices are too small for a crease to be seen, and their hinges take much memory.
constexpr std::size_t most_creased = 200'000;

} // namespace

void require_move(double rms) {
    if (!(rms > 0))
        throw GeometryError(
            "no radial move of this surface shows along its normals, so it can't be marked; a closed "
            "or curved model can");
}

Marker::Marker(const TriangleMesh& mesh, std::size_t vertices, const Progress& progress)
    : sorted_(mesh.positions.size() > worth_sorting ? along_curve(mesh) : Reordered{}),
      mesh_(sorted_.original.empty() ? mesh : sorted_.mesh), vertices_(vertices), progress_(progress),
      moments_(shape_moments(mesh_)), frame_(principal_frame(mesh_, moments_.own())),
      diagonal_(surface_box(mesh_).diagonal()), made_(std::make_unique<Made>()) {}

Marker::~Marker() = default;

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
    constexpr std::size_t block = 16384;
    parallel_blocks(positions.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            given[sorted_.original[i]] = positions[i];
    });
    return given;
}

double Marker::percent_of_diagonal(double radii) const {
    return 100 * radii * frame_.scale / diagonal_;
}

/// Takes back what folds creases, which the budget doesn't see, and spends nothing of what that saves: it would go
/// into folds again. Returns whether it did, and so has told what is seen.
bool Marker::uncrease(Marked& marked, double visibility,
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
        return false;
    const double seen =
        weighty && !marked.seen_by_few ? budget().followed(positions, *weighty) : budget().visible(positions);
    if (seen > visibility) // where MSDM2 jumps
        return false;
    marked.positions = std::move(positions);
    marked.msdm2 = seen;
    return true;
}

/// Positions of a strength, #V, but of vertices that are to stay, if any are.
std::vector<Vec3> Marker::laid(const Layout& layout, double strength, const std::vector<char>& still) const {
    std::vector<Vec3> positions = layout.positions(strength);
    for (std::size_t i = 0; i < still.size(); ++i)
        if (still[i])
            positions[i] = mesh_.positions[i];
    embed::turn_back(mesh_, positions);
    return positions;
}

/// Lays a mark as strong as a budget of visibility lets it be.
void Marker::keep_to(double visibility, const Layout& layout, Marked& marked) const {
    const masking::MarkOfStrength of_all = [&](double strength) { return laid(layout, strength, {}); };
    masking::Fit fit =
        layout.usual > 0
            ? budget().fit_near(of_all, visibility,
                                masking::Budget::rescaled(layout.usual, default_visibility, visibility))
            : budget().fit(of_all, visibility, first_strength);
    const bool spares_creases = marked.profile == Profile::masked && mesh_.positions.size() <= most_creased;
    const auto lay = [&](const masking::Fit& chosen) { // returns whether the mark was looked at as it lies
        if (!(chosen.strength > 0))
            throw TooVisible(fmt::format(
                "no mark of this surface is seen with MSDM2 {:g} or less, however weak", visibility));
        marked.strength = chosen.strength;
        marked.positions = laid(layout, chosen.strength, fit.still);
        marked.msdm2 = chosen.msdm2;
        marked.seen_by_few = chosen.by_few;
        return (spares_creases && uncrease(marked, visibility, chosen.weighty)) || !chosen.foretold;
    };
    if (!lay(fit))
        lay(budget().looked_at(of_all, fit, visibility)); // nothing has to stay where a strength is foretold
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
    if (setting.visibility && !setting.gamma) {
        keep_to(*setting.visibility, layout, marked);
    } else {
        marked.strength = setting.gamma ? *setting.gamma * layout.unit : setting.strength;
        require_move(marked.strength);
        marked.positions = laid(layout, marked.strength, {});
    }
    marked.gamma = marked.strength / layout.unit;
    marked.base_vertices =
        marked.profile == Profile::masked ? mesh_.positions.size() : domain().mesh.positions.size();
    marked.distortion = marked.profile == Profile::masked
                            ? embed::distortion(mesh_, marked.positions, carriers(setting.level).normals())
                            : embed::distortion(mesh_, marked.positions);
    marked.positions = in_given_order(marked.positions);
    return marked;
}

} // namespace wm3d::watermark
