// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What every format's reader returns, and how coordinates get back into the file.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <wm3d/io/model.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>

#include "source.hpp"

namespace wm3d::io {

/// The analysis mesh and the slots that were welded into it.
struct Welding {
    const TriangleMesh& mesh;
    std::span<const Index> vertex_of_slot;
};

/// Where a file keeps its coordinates. Holds views of the file's bytes, which outlive it.
class CoordinateStore {
public:
    virtual ~CoordinateStore() = default;

    /// As Model::coordinate_step.
    virtual double step(const Welding& welding) const = 0;
    /// As Model::stored_positions.
    virtual std::vector<Vec3> settle(const Welding& welding, std::span<const Vec3> wanted) const = 0;
    /// As Model::patched_files; without an output name, everything is put inline.
    virtual PatchedFiles patch(const Welding& welding, std::span<const Vec3> wanted,
                               std::string_view output_name) const = 0;
};

/// What a reader finds: the slots' positions, all finite, triangles between slots, and the store.
struct Document {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;
    std::unique_ptr<CoordinateStore> store;
};

/// Largest absolute coordinate along each axis among vertices that a triangle uses.
Vec3 largest_coordinates(const TriangleMesh& mesh);

Document read_obj(const Source& source);
Document read_ply(const Source& source);
Document read_stl(const Source& source);
Document read_off(const Source& source);
Document read_gltf(const Source& source, const Resolver& resolver, const Limits& limits);
Document read_glb(const Source& source, const Resolver& resolver, const Limits& limits);

} // namespace wm3d::io
