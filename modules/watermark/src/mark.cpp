// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/mark.hpp>

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <wm3d/core/error.hpp>
#include <wm3d/watermark/marker.hpp>

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
    constexpr double aim = 0.998; // of the budget, which tries would else come near from above
    const double budget = *setting.visibility;
    Marked marked;
    bool by_few = false;
    for (int k = 0; k < most_tries; ++k) {
        marked = marker.mark(secret, setting);
        by_few |= marked.seen_by_few; // where few decided, a weaker mark that they don't is looked at as well
        if (!by_few)
            break;
        marked.msdm2 = marker.visible(stored(marked.positions));
        if (*marked.msdm2 <= budget)
            break;
        setting.visibility = *setting.visibility * aim * budget / *marked.msdm2;
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
