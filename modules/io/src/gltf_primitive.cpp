// SPDX-License-Identifier: GPL-3.0-or-later
#include "gltf_primitive.hpp"

#include <numeric>

#include "gltf_accessor.hpp"
#include "polygons.hpp"

namespace wm3d::io {

namespace {

constexpr std::size_t mode_triangles = 4, mode_strip = 5, mode_fan = 6;

std::size_t mode_of(const Source& source, const Json& primitive) {
    return gltf_size(source, primitive, "mode", mode_triangles);
}

} // namespace

bool gltf_is_surface(const Source& source, const Json& primitive) {
    const std::size_t mode = mode_of(source, primitive);
    return mode >= mode_triangles && mode <= mode_fan;
}

std::vector<Triangle> gltf_triangles(GltfFile& file, const Json& primitive, std::size_t vertices) {
    std::vector<Index> corners;
    if (primitive.contains("indices")) {
        corners = gltf_indices(file, gltf_size(file.source(), primitive, "indices", 0), vertices);
    } else {
        corners.resize(vertices);
        std::iota(corners.begin(), corners.end(), Index{0});
    }
    std::vector<Triangle> triangles;
    const std::size_t mode = mode_of(file.source(), primitive);
    if (mode == mode_strip) {
        append_strip(corners, triangles);
    } else if (mode == mode_fan) {
        for (std::size_t i = 1; i + 1 < corners.size(); ++i)
            triangles.push_back({corners[0], corners[i], corners[i + 1]});
    } else {
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
            triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    }
    return triangles;
}

} // namespace wm3d::io
