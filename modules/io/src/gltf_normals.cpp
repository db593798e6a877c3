// SPDX-License-Identifier: GPL-3.0-or-later
// Normals of a patched glTF asset. They are written as positions are: through a store whose blocks are the
// accessors of normals, each shown once at the origin, for positions and normals turn in the mesh's own
// coordinates.
#include <map>
#include <numeric>
#include <set>

#include "gltf_accessor.hpp"
#include "gltf_primitive.hpp"
#include "gltf_scene.hpp"
#include "gltf_store.hpp"
#include "normals.hpp"

namespace wm3d::io {

namespace {

class GltfNormals {
public:
    GltfNormals(GltfFile before, GltfFile after) : before_(std::move(before)), after_(std::move(after)) {
        std::set<std::size_t> meshes;
        for (const PlacedMesh& placed : gltf_placed_meshes(after_))
            meshes.insert(placed.mesh);
        for (std::size_t mesh : meshes)
            for (const Json& primitive :
                 gltf_array(source(), gltf_entry(source(), after_.json(), "meshes", mesh), "primitives"))
                add(primitive);
        refuse_several_files();
    }

    bool empty() const { return values_.empty(); }

    /// The asset with its normals turned; empties this object.
    PatchedFiles patch(std::string_view output_name) {
        const TriangleMesh points{values_, {}};
        std::vector<Index> itself(values_.size());
        std::iota(itself.begin(), itself.end(), Index{0});
        const GltfStore store(std::move(after_), std::move(blocks_), std::move(instances_));
        return store.patch({points, itself}, turned(values_, uses_), output_name);
    }

private:
    const Source& source() const { return after_.source(); }

    void add(const Json& primitive) {
        const Json& attributes = primitive.at("attributes");
        if (!gltf_is_surface(source(), primitive) || !attributes.contains("NORMAL"))
            return;
        const std::size_t position = gltf_size(source(), attributes, "POSITION", 0);
        const GltfAccessor accessor = gltf_position_accessor(after_, position);
        const GltfBlock& block = blocks_[block_of(gltf_size(source(), attributes, "NORMAL", 0))];
        if (block.accessor.count < accessor.count)
            source().fail("a primitive has fewer normals than positions; the file is damaged");
        buffers_.insert(accessor.buffer);
        buffers_.insert(block.accessor.buffer);

        const Index first = first_point(position, accessor);
        for (const Triangle& triangle : gltf_triangles(after_, primitive, accessor.count)) {
            for (Index corner : triangle) {
                uses_.faces.corners.push_back(first + corner);
                uses_.normal_of_corner.push_back(static_cast<Index>(block.first_element + corner));
            }
            uses_.faces.close_face();
        }
    }

    /// Place of an accessor's positions among all, before and after; primitives that share it share them.
    Index first_point(std::size_t number, const GltfAccessor& accessor) {
        const auto [place, is_new] =
            first_of_accessor_.try_emplace(number, static_cast<Index>(uses_.after.size()));
        if (is_new) {
            append(uses_.before,
                   GltfStore::local_positions(before_, gltf_position_accessor(before_, number)));
            append(uses_.after, GltfStore::local_positions(after_, accessor));
        }
        return place->second;
    }

    std::size_t block_of(std::size_t number) {
        const auto [place, is_new] = block_of_accessor_.try_emplace(number, blocks_.size());
        if (is_new) {
            const GltfAccessor accessor =
                gltf_position_accessor(after_, number); // VEC3 too, and perhaps normalized
            blocks_.push_back({accessor, {number}, values_.size()});
            instances_.push_back({place->second, {}, values_.size()});
            append(values_, GltfStore::local_positions(after_, accessor));
        }
        return place->second;
    }

    static void append(std::vector<Vec3>& all, const std::vector<Vec3>& part) {
        all.insert(all.end(), part.begin(), part.end());
    }

    /// Side files are named by their number among those that change, which has to be the same both times.
    void refuse_several_files() const {
        std::size_t external = 0;
        for (std::size_t b : buffers_)
            external += after_.buffers()[b].home == GltfFile::Home::external ? 1 : 0;
        if (external > 1)
            source().fail(
                "its positions and normals lie in several external buffers, so its normals can't be "
                "recomputed; keep them, or save the file as GLB");
    }

    GltfFile before_, after_;
    std::vector<GltfBlock> blocks_;
    std::vector<GltfInstance> instances_;
    std::map<std::size_t, std::size_t> block_of_accessor_;
    std::map<std::size_t, Index> first_of_accessor_;
    std::set<std::size_t> buffers_; ///< of positions and normals
    std::vector<Vec3> values_;
    NormalUses uses_;
};

/// Finds side files before they are written.
Resolver with_side_files(const PatchedFiles& files, const Resolver& beside) {
    return [&files, &beside](std::string_view uri) {
        for (const SideFile& side : files.side_files)
            if (side.name == uri)
                return side.bytes;
        return beside(uri);
    };
}

} // namespace

PatchedFiles with_turned_gltf_normals(PatchedFiles files, bool binary, const Source& original,
                                      const Resolver& resolver, std::string_view output_name) {
    const Source patched{original.name, files.bytes};
    GltfNormals normals(GltfFile::open(original, binary, resolver),
                        GltfFile::open(patched, binary, with_side_files(files, resolver)));
    if (normals.empty())
        return files;
    PatchedFiles turned = normals.patch(output_name);
    if (turned.side_files.empty())
        turned.side_files = std::move(files.side_files);
    return turned;
}

} // namespace wm3d::io
