// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/apply.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <wm3d/attack/random.hpp>
#include <wm3d/core/error.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/weld.hpp>

#include "registry.hpp"

namespace wm3d::attack {

namespace {

void require_finite(const TriangleMesh& mesh) {
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        if (!mesh.positions[v].allFinite())
            throw GeometryError(
                fmt::format("vertex {} has a coordinate that is not a finite number; mend the file "
                            "in a mesh editor",
                            v));
}

void require_values(const RegistryEntry& entry, const AttackSpec& spec) {
    if (!entry.info.available)
        throw ParameterError(
            fmt::format("this build has no attack {}: install OpenVDB and build wm3d again", spec.name));
    const auto& parameters = entry.info.parameters;
    if (spec.values.size() != parameters.size())
        throw ParameterError(fmt::format("attack {} needs {} values, not {}", spec.name, parameters.size(),
                                         spec.values.size()));
    for (std::size_t i = 0; i < parameters.size(); ++i)
        if (!(spec.values[i] >= parameters[i].min && spec.values[i] <= parameters[i].max))
            throw ParameterError(fmt::format("attack {}: {}={} lies outside {} to {}", spec.name,
                                             parameters[i].name, spec.values[i], parameters[i].min,
                                             parameters[i].max));
}

/// One step on a welded mesh.
TriangleMesh run(const TriangleMesh& mesh, const AttackSpec& spec, std::uint64_t seed) {
    const RegistryEntry& entry = find_entry(spec.name);
    require_values(entry, spec);
    TriangleMesh attacked = entry.run(mesh, spec.values, seed);
    if (!(surface_area(attacked) > 0))
        throw GeometryError(
            fmt::format("attack {} leaves nothing of the model; choose a weaker one", to_string(spec)));
    return attacked;
}

} // namespace

TriangleMesh apply(const TriangleMesh& mesh, const AttackSpec& spec, std::uint64_t seed,
                   const Progress& progress) {
    return apply(mesh, std::span(&spec, 1), seed, progress);
}

TriangleMesh apply(const TriangleMesh& mesh, std::span<const AttackSpec> chain, std::uint64_t seed,
                   const Progress& progress) {
    require_finite(mesh);
    TriangleMesh current = weld(mesh.positions, mesh.triangles).mesh;
    if (!(surface_area(current) > 0))
        throw GeometryError(
            "the mesh has no surface area, so there is nothing to attack; check that the file "
            "holds the model that you mean");
    const RandomStream seeds(seed, 0);
    for (std::size_t i = 0; i < chain.size(); ++i) {
        notify(progress, chain[i].name, static_cast<double>(i) / static_cast<double>(chain.size()));
        current = run(current, chain[i], i == 0 ? seed : seeds.word(i));
    }
    notify(progress, "attack", 1);
    return current;
}

} // namespace wm3d::attack
