// SPDX-License-Identifier: GPL-3.0-or-later
// glTF 2.0 and GLB: the triangles that the default scene shows, in world coordinates.
#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "document.hpp"
#include "gltf_accessor.hpp"
#include "gltf_file.hpp"
#include "gltf_overlap.hpp"
#include "gltf_primitive.hpp"
#include "gltf_scene.hpp"
#include "gltf_store.hpp"

namespace wm3d::io {

namespace {

class SceneReader {
public:
    explicit SceneReader(GltfFile file) : file_(std::move(file)) {}

    Document run() {
        for (const PlacedMesh& placed : gltf_placed_meshes(file_))
            read_mesh(placed);
        refuse_overlaps();
        document_.store =
            std::make_unique<GltfStore>(std::move(file_), std::move(blocks_), std::move(instances_));
        return std::move(document_);
    }

private:
    /// Buffer, offset, stride, count, type and unit of an accessor.
    using Bytes = std::tuple<std::size_t, std::size_t, std::size_t, std::size_t, Scalar, double>;

    const Source& source() const { return file_.source(); }

    void read_mesh(const PlacedMesh& placed) {
        const Json& mesh = gltf_entry(source(), file_.json(), "meshes", placed.mesh);
        std::map<std::size_t, std::size_t> first_slots; // of this node's blocks: primitives may share one
        for (const Json& primitive : gltf_array(source(), mesh, "primitives")) {
            file_.check_shown(static_cast<double>(++primitives_), "primitives");
            if (!primitive.is_object())
                source().fail(fmt::format("a primitive of mesh {} is no object", placed.mesh));
            if (!gltf_is_surface(source(), primitive))
                continue;
            const std::size_t accessor = position_accessor(primitive, placed.mesh);
            const std::size_t block = block_of(accessor);
            const auto [slot, is_new] = first_slots.try_emplace(block, document_.positions.size());
            if (is_new)
                add_instance(block, placed.placement);
            add_triangles(primitive, slot->second, blocks_[block].accessor.count);
        }
    }

    std::size_t position_accessor(const Json& primitive, std::size_t mesh) const {
        if (const auto extensions = primitive.find("extensions");
            extensions != primitive.end() && extensions->contains("KHR_draco_mesh_compression"))
            source().fail(
                fmt::format("mesh {} is compressed with Draco, which wm3d does not read; save the file "
                            "without compression",
                            mesh));
        const auto attributes = primitive.find("attributes");
        if (attributes == primitive.end() || !attributes->is_object() || !attributes->contains("POSITION"))
            source().fail(fmt::format("a primitive of mesh {} has no positions", mesh));
        return gltf_size(source(), *attributes, "POSITION", 0);
    }

    /// The block of an accessor; accessors that describe the same bytes share one.
    std::size_t block_of(std::size_t accessor_number) {
        if (const auto known = block_of_accessor_.find(accessor_number); known != block_of_accessor_.end())
            return known->second;
        const GltfAccessor a = gltf_position_accessor(file_, accessor_number);
        const auto [place, is_new] = block_of_bytes_.try_emplace(
            Bytes{a.buffer, a.offset, a.stride, a.count, a.type, a.unit}, blocks_.size());
        const std::size_t block = place->second;
        if (is_new) {
            file_.check_shown(static_cast<double>(elements_) + static_cast<double>(a.count), "vertices");
            blocks_.push_back({a, {}, elements_});
            elements_ += a.count;
            local_.push_back(GltfStore::local_positions(file_, a));
        }
        blocks_[block].accessors.push_back(accessor_number);
        block_of_accessor_[accessor_number] = block;
        return block;
    }

    void add_instance(std::size_t block, const Placement& placement) {
        file_.check_shown(static_cast<double>(document_.positions.size() + local_[block].size()), "vertices");
        instances_.push_back({block, placement, document_.positions.size()});
        for (std::size_t i = 0; i < local_[block].size(); ++i) {
            const Vec3 position = placement(local_[block][i]);
            if (!position.allFinite())
                source().fail(
                    fmt::format("element {} of accessor {} is not finite; wm3d needs finite coordinates", i,
                                blocks_[block].accessor.number));
            document_.positions.push_back(position);
        }
    }

    void add_triangles(const Json& primitive, std::size_t first_slot, std::size_t vertices) {
        std::vector<Triangle>& triangles = document_.triangles;
        const std::vector<Triangle> own = gltf_triangles(file_, primitive, vertices);
        file_.check_shown(static_cast<double>(triangles.size() + own.size()), "triangles");
        for (Triangle triangle : own) {
            for (Index& corner : triangle)
                corner += static_cast<Index>(first_slot);
            triangles.push_back(triangle);
        }
    }

    /// Accessors that share some bytes but not all could not be changed one by one.
    void refuse_overlaps() const {
        std::vector<GltfAccessor> accessors;
        for (const GltfBlock& block : blocks_)
            accessors.push_back(block.accessor);
        if (const auto pair = gltf_overlap(std::move(accessors)))
            source().fail(fmt::format("the positions of accessors {} and {} overlap in their buffer, so they "
                                      "can't be changed one by one",
                                      pair->first, pair->second));
    }

    GltfFile file_;
    Document document_;
    std::vector<GltfBlock> blocks_;
    std::vector<std::vector<Vec3>> local_;
    std::vector<GltfInstance> instances_;
    std::map<std::size_t, std::size_t> block_of_accessor_;
    std::map<Bytes, std::size_t> block_of_bytes_;
    std::size_t elements_ = 0;
    std::size_t primitives_ = 0;
};

Document read_asset(const Source& source, bool binary, const Resolver& resolver, const Limits& limits) {
    try {
        return SceneReader(GltfFile::open(source, binary, resolver, limits)).run();
    } catch (const Json::exception& error) {
        source.fail(fmt::format("its JSON is not as glTF has it ({})", error.what()));
    }
}

} // namespace

Document read_gltf(const Source& source, const Resolver& resolver, const Limits& limits) {
    return read_asset(source, false, resolver, limits);
}
Document read_glb(const Source& source, const Resolver& resolver, const Limits& limits) {
    return read_asset(source, true, resolver, limits);
}

} // namespace wm3d::io
