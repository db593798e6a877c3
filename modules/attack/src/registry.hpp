// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The table behind the catalogue: what an attack is called, what it takes, and what it runs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <wm3d/attack/spec.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::attack {

struct RegistryEntry {
    AttackInfo info;
    TriangleMesh (*run)(const TriangleMesh& mesh, std::span<const double> values, std::uint64_t seed);
};

const std::vector<RegistryEntry>& registry();

/// The entry of that name or alias.
/// \throw ParameterError  listing the known, if there is none
const RegistryEntry& find_entry(std::string_view name);

} // namespace wm3d::attack
