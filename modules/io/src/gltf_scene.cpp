// SPDX-License-Identifier: GPL-3.0-or-later
#include "gltf_scene.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace wm3d::io {

namespace {

/// N numbers of a member, or `missing`.
template<std::size_t N>
std::array<double, N> numbers(const Source& source, const Json& node, const char* key,
                              std::array<double, N> missing) {
    const Json& array = gltf_array(source, node, key);
    if (!node.contains(key))
        return missing;
    if (array.size() != N)
        source.fail(fmt::format("\"{}\" of a node has {} numbers, but should have {}", key, array.size(), N));
    std::array<double, N> values{};
    for (std::size_t i = 0; i < N; ++i) {
        if (!array[i].is_number())
            source.fail(fmt::format("\"{}\" of a node holds something that is no number", key));
        values[i] = array[i].get<double>();
    }
    return values;
}

Placement local_placement(const Source& source, const Json& node) {
    Placement local;
    if (node.contains("matrix")) { // by columns
        const auto m = numbers<16>(source, node, "matrix", {});
        local.linear = Eigen::Map<const Eigen::Matrix4d>(m.data()).topLeftCorner<3, 3>();
        local.translation = {m[12], m[13], m[14]};
        if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1)
            source.fail("the matrix of a node is a projection, which glTF does not allow");
        return local;
    }
    const auto t = numbers<3>(source, node, "translation", {0, 0, 0});
    const auto r = numbers<4>(source, node, "rotation", {0, 0, 0, 1});
    const auto s = numbers<3>(source, node, "scale", {1, 1, 1});
    const Eigen::Quaterniond rotation = Eigen::Quaterniond(r[3], r[0], r[1], r[2]).normalized();
    local.linear = rotation.toRotationMatrix() * Vec3(s[0], s[1], s[2]).asDiagonal();
    local.translation = {t[0], t[1], t[2]};
    return local;
}

std::vector<std::size_t> numbers_of_nodes(const Source& source, const Json& owner, const char* key) {
    std::vector<std::size_t> nodes;
    for (const Json& node : gltf_array(source, owner, key)) {
        if (!node.is_number_unsigned())
            source.fail(fmt::format("\"{}\" in its JSON holds something that is no node", key));
        nodes.push_back(node.get<std::size_t>());
    }
    return nodes;
}

std::vector<std::size_t> roots(const GltfFile& file) {
    const Source& source = file.source();
    const Json& json = file.json();
    if (!gltf_array(source, json, "scenes").empty())
        return numbers_of_nodes(
            source, gltf_entry(source, json, "scenes", gltf_size(source, json, "scene", 0)), "nodes");
    const std::size_t count = gltf_array(source, json, "nodes").size();
    std::vector<bool> is_child(count, false);
    for (std::size_t n = 0; n < count; ++n)
        for (std::size_t child : numbers_of_nodes(source, gltf_entry(source, json, "nodes", n), "children"))
            if (child < count)
                is_child[child] = true;
    std::vector<std::size_t> nodes;
    for (std::size_t n = 0; n < count; ++n)
        if (!is_child[n])
            nodes.push_back(n);
    return nodes;
}

} // namespace

std::vector<PlacedMesh> gltf_placed_meshes(const GltfFile& file) {
    const Source& source = file.source();
    const Json& json = file.json();
    std::vector<PlacedMesh> placed;
    std::vector<bool> seen(gltf_array(source, json, "nodes").size(), false);
    std::vector<std::pair<std::size_t, Placement>> open; // a stack: the next node is its last
    const auto push = [&](std::vector<std::size_t> nodes, const Placement& parent) {
        std::reverse(nodes.begin(), nodes.end());
        for (std::size_t node : nodes)
            open.emplace_back(node, parent);
    };
    push(roots(file), {});
    while (!open.empty()) {
        const auto [number, parent] = open.back();
        open.pop_back();
        const Json& node = gltf_entry(source, json, "nodes", number);
        if (seen[number])
            source.fail(fmt::format("node {} has two parents or is its own ancestor", number));
        seen[number] = true;
        const Placement local = local_placement(source, node);
        const Placement world{parent.linear * local.linear, parent(local.translation)};
        if (node.contains("mesh"))
            placed.push_back(
                {gltf_size(source, node, "mesh", 0), node.contains("skin") ? Placement{} : world});
        push(numbers_of_nodes(source, node, "children"), world);
    }
    if (placed.empty())
        for (std::size_t mesh = 0; mesh < gltf_array(source, json, "meshes").size(); ++mesh)
            placed.push_back({mesh, {}});
    return placed;
}

} // namespace wm3d::io
