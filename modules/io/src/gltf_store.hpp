// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Positions of a glTF asset: stored once in local coordinates, shown by any number of instances.
#pragma once

#include <vector>

#include "document.hpp"
#include "gltf_accessor.hpp"
#include "gltf_scene.hpp"
#include "json_text.hpp"

namespace wm3d::io {

/// Positions in a buffer; its *elements* are numbered through all blocks.
struct GltfBlock {
    GltfAccessor accessor;
    std::vector<std::size_t> accessors; ///< numbers of all accessors that describe these bytes
    std::size_t first_element = 0;
};

/// A block as one node shows it; its elements are slots in the same order.
struct GltfInstance {
    std::size_t block = 0;
    Placement placement;
    std::size_t first_slot = 0;
};

class GltfStore final : public CoordinateStore {
public:
    GltfStore(GltfFile file, std::vector<GltfBlock> blocks, std::vector<GltfInstance> instances);

    /// Local positions as the accessor stores them.
    static std::vector<Vec3> local_positions(GltfFile& file, const GltfAccessor& accessor);

    double step(const Welding& welding) const override;
    std::vector<Vec3> settle(const Welding& welding, std::span<const Vec3> wanted) const override;
    PatchedFiles patch(const Welding& welding, std::span<const Vec3> wanted,
                       std::string_view output_name) const override;

private:
    struct Moves;
    Moves plan(const Welding& welding, std::span<const Vec3> wanted) const;
    void average_instances(const Welding& welding, std::span<const Vec3> wanted, Moves& moves) const;
    void keep_seams_closed(const Welding& welding, Moves& moves) const;
    std::vector<std::string> moved_buffers(const Moves& moves) const;
    void edit_bounds(const Moves& moves, const GltfBlock& block, std::span<const JsonSpan> accessors,
                     JsonEdits& edits) const;
    std::string moved_text(const Moves& moves, std::span<const std::string> uris) const;

    GltfFile file_;
    std::vector<GltfBlock> blocks_;
    std::vector<GltfInstance> instances_;
    std::vector<Vec3> local_; ///< #elements
};

} // namespace wm3d::io
