// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Normals that a file stores, turned with the surface after its positions were patched.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "document.hpp"
#include "polygons.hpp"

namespace wm3d::io {

/// Normals of a file and where they stand in it.
struct NormalTable {
    std::vector<Vec3> values;               ///< #N, as stored: not always finite or of length 1
    std::unique_ptr<CoordinateStore> store; ///< of their numbers
};

/// Which corners of the surface show which normal.
struct NormalUses {
    std::vector<Vec3> before, after;     ///< points of the surface, before and after the patch
    Polygons faces;                      ///< of points
    std::vector<Index> normal_of_corner; ///< #corners; no_index where a corner has none
};

/// Each normal turned as its faces turned: as the area-weighted sum of their normals, with the twist that
/// their edges tell. Stored normals needn't be those sums (creases, smoothing groups, an artist's hand): what
/// they differ by is kept.
std::vector<Vec3> turned(const std::vector<Vec3>& normals, const NormalUses& uses);

/// `files` with the normals turned, where the format has any.
/// \param original  bytes of the file before the patch
/// \param mesh, vertex_of_slot  as Model's, before the patch
/// \throw InputError  if a normal or what refers to it can't be understood
PatchedFiles with_turned_normals(PatchedFiles files, Format format, const Source& original,
                                 const Welding& welding, const Resolver& resolver,
                                 std::string_view output_name);

/// The normals of a patched file; none if it stores none. Those of PLY and OFF stand in the order of the
/// slots, those of STL in that of the facets.
/// \throw InputError
std::optional<NormalTable> ply_normals(const Source& patched);
std::optional<NormalTable> off_normals(const Source& patched);
NormalTable stl_normals(const Source& patched);

/// The normals of a patched OBJ file and the faces that use them; `uses` gets its faces and normals from
/// here.
std::optional<NormalTable> obj_normals(const Source& patched, NormalUses& uses);

/// As with_turned_normals, for glTF and GLB.
PatchedFiles with_turned_gltf_normals(PatchedFiles files, bool binary, const Source& original,
                                      const Resolver& resolver, std::string_view output_name);

} // namespace wm3d::io
