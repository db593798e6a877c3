// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Applying attacks by name.
#pragma once

#include <cstdint>
#include <span>

#include <wm3d/attack/spec.hpp>
#include <wm3d/core/progress.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::attack {

/// The mesh after the attack. Positions that coincide are welded first, so that no attack opens a seam.
/// Attacks that need a manifold (subdivision, simplification, remeshing) first orient the triangles and split
/// the vertices where the surface is not one. Same mesh, spec and seed: same bytes.
/// \throw ParameterError if the spec names an attack that this build lacks, or values that don't belong to it
/// \throw GeometryError if the mesh has no surface or infinite coordinates, or if nothing of it would be left
TriangleMesh apply(const TriangleMesh& mesh, const AttackSpec& spec, std::uint64_t seed,
                   const Progress& progress = {});

/// One attack after the other; each step draws random numbers of its own, the first those of `seed` itself.
TriangleMesh apply(const TriangleMesh& mesh, std::span<const AttackSpec> chain, std::uint64_t seed,
                   const Progress& progress = {});

} // namespace wm3d::attack
