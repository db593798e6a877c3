// SPDX-License-Identifier: GPL-3.0-or-later
#include "encode_gltf.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include <wm3d/core/base64.hpp>

#include "binary.hpp"

namespace wm3d::io {

namespace {

using OrderedJson = nlohmann::ordered_json;

/// Vertices of the asset: those of the mesh, or one per corner where faces have colours of their own.
struct Vertices {
    std::vector<Index> position; ///< vertex of the mesh
    std::vector<Color> color;    ///< empty, or one each
    std::vector<Triangle> triangles;
};

Vertices shared_vertices(const TriangleMesh& mesh, const EncodeOptions& options) {
    Vertices vertices{{}, options.vertex_colors, mesh.triangles};
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        vertices.position.push_back(static_cast<Index>(v));
    return vertices;
}

Vertices corner_vertices(const TriangleMesh& mesh, const EncodeOptions& options) {
    Vertices vertices;
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const auto first = static_cast<Index>(3 * f);
        vertices.triangles.push_back({first, first + 1, first + 2});
        for (Index v : mesh.triangles[f]) {
            vertices.position.push_back(v);
            vertices.color.push_back(options.face_colors[f]);
        }
    }
    return vertices;
}

OrderedJson bounds(const TriangleMesh& mesh, const Vertices& vertices, bool least) {
    Vec3 bound = mesh.positions[vertices.position.front()];
    for (Index v : vertices.position)
        bound = least ? bound.cwiseMin(mesh.positions[v]).eval() : bound.cwiseMax(mesh.positions[v]).eval();
    OrderedJson array = OrderedJson::array();
    for (int k = 0; k < 3; ++k)
        array.push_back(nearest(Scalar::f32, bound[k]));
    return array;
}

/// Collects buffer views and accessors while the buffer grows.
struct Builder {
    std::string buffer;
    OrderedJson views = OrderedJson::array(), accessors = OrderedJson::array();

    /// Declares what was appended since `begin`.
    /// \return the accessor's number
    std::size_t declare(std::size_t begin, int target, OrderedJson accessor) {
        views.push_back({{"buffer", 0},
                         {"byteOffset", begin},
                         {"byteLength", buffer.size() - begin},
                         {"target", target}});
        accessor["bufferView"] = views.size() - 1;
        accessors.push_back(std::move(accessor));
        return accessors.size() - 1;
    }
};

OrderedJson build_asset(const TriangleMesh& mesh, const Vertices& vertices, const EncodeOptions& options,
                        Builder& builder) {
    constexpr int array_buffer = 34962, element_array_buffer = 34963;
    OrderedJson primitive{{"attributes", OrderedJson::object()}};
    for (Index v : vertices.position)
        for (int k = 0; k < 3; ++k)
            put(builder.buffer, Scalar::f32, mesh.positions[v][k]);
    OrderedJson positions{{"componentType", 5126}, {"count", vertices.position.size()}, {"type", "VEC3"}};
    if (!vertices.position.empty()) {
        positions["min"] = bounds(mesh, vertices, true);
        positions["max"] = bounds(mesh, vertices, false);
    }
    primitive["attributes"]["POSITION"] = builder.declare(0, array_buffer, std::move(positions));
    if (!vertices.color.empty()) {
        const std::size_t begin = builder.buffer.size();
        for (const Color& color : vertices.color) {
            for (std::uint8_t channel : color)
                put(builder.buffer, Scalar::u8, channel);
            put(builder.buffer, Scalar::u8, 255); // opaque; also aligns to four bytes
        }
        primitive["attributes"]["COLOR_0"] = builder.declare(begin, array_buffer,
                                                             {{"componentType", 5121},
                                                              {"normalized", true},
                                                              {"count", vertices.color.size()},
                                                              {"type", "VEC4"}});
    }
    const std::size_t begin = builder.buffer.size();
    for (const Triangle& t : vertices.triangles)
        for (Index v : t)
            put(builder.buffer, Scalar::u32, v);
    primitive["indices"] = builder.declare(
        begin, element_array_buffer,
        {{"componentType", 5125}, {"count", 3 * vertices.triangles.size()}, {"type", "SCALAR"}});
    return {
        {"asset", {{"version", "2.0"}, {"generator", options.comment.empty() ? "wm3d" : options.comment}}},
        {"scene", 0},
        {"scenes", {{{"nodes", {0}}}}},
        {"nodes", {{{"mesh", 0}}}},
        {"meshes", {{{"primitives", OrderedJson::array({std::move(primitive)})}}}},
        {"accessors", builder.accessors},
        {"bufferViews", builder.views},
        {"buffers", OrderedJson::array({{{"byteLength", builder.buffer.size()}}})}};
}

void put_chunk(std::string& out, std::string_view type, std::string_view data, char padding) {
    const std::size_t padded = (data.size() + 3) / 4 * 4;
    put(out, Scalar::u32, static_cast<double>(padded));
    out += type;
    out += data;
    out.append(padded - data.size(), padding);
}

} // namespace

std::string encode_gltf(const TriangleMesh& mesh, const EncodeOptions& options, bool binary) {
    const Vertices vertices =
        options.face_colors.empty() ? shared_vertices(mesh, options) : corner_vertices(mesh, options);
    Builder builder;
    OrderedJson asset = build_asset(mesh, vertices, options, builder);
    if (!binary) {
        asset["buffers"][0]["uri"] = "data:application/octet-stream;base64," + to_base64(builder.buffer);
        return asset.dump(1) + "\n";
    }
    std::string chunks;
    put_chunk(chunks, "JSON", asset.dump(), ' ');
    put_chunk(chunks, std::string_view("BIN\0", 4), builder.buffer, '\0');
    std::string out = "glTF";
    put(out, Scalar::u32, 2);
    put(out, Scalar::u32, static_cast<double>(12 + chunks.size()));
    return out + chunks;
}

} // namespace wm3d::io
