// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Small glTF assets for tests.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <wm3d/mesh/types.hpp>

#include <wm3d/core/base64.hpp>

namespace wm3d::io::test {

inline void put_u32(std::string& out, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8)
        out.push_back(static_cast<char>(value >> shift & 255));
}

inline std::string floats(const std::vector<float>& values) {
    std::string bytes(4 * values.size(), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size()); // tests run on little-endian machines
    return bytes;
}

inline std::string shorts(const std::vector<std::uint16_t>& values) {
    std::string bytes(2 * values.size(), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

inline std::string glb(std::string json, std::string binary) {
    json.append((4 - json.size() % 4) % 4, ' ');
    binary.append((4 - binary.size() % 4) % 4, '\0');
    std::string out = "glTF";
    put_u32(out, 2);
    put_u32(out, static_cast<std::uint32_t>(28 + json.size() + binary.size()));
    put_u32(out, static_cast<std::uint32_t>(json.size()));
    out += "JSON" + json;
    put_u32(out, static_cast<std::uint32_t>(binary.size()));
    out += std::string("BIN\0", 4) + binary;
    return out;
}

inline std::string data_uri(const std::string& bytes) {
    return "data:application/octet-stream;base64," + to_base64(bytes);
}

/// Four corners of a unit square in z = 0 and two triangles: accessor 0 and 1 of buffer 0.
inline std::string square_buffer() {
    return floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) + shorts({0, 1, 2, 0, 2, 3});
}

/// An asset around square_buffer(): `nodes` is the text of the node list, `buffer` that of the buffer.
inline std::string square_asset(const std::string& nodes, const std::string& buffer) {
    return "{ \"asset\" : {\"version\":\"2.0\", \"extras\": \"\\\"min\\\": [\"},\n "
           "\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
           "\"nodes\":" +
           nodes +
           ",\n\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}],"
           "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\",\"min\":[0,"
           " 0,0.0],"
           "\"max\":[1.0,1,0]},{\"type\":\"SCALAR\",\"bufferView\":1,\"componentType\":5123,\"count\":6,"
           "\"max\":[3]}],"
           "\"bufferViews\":[{\"buffer\":0,\"byteLength\":48},{\"buffer\":0,\"byteOffset\":48,\"byteLength\":"
           "12}],"
           "\"buffers\":[" +
           buffer + "] }";
}

} // namespace wm3d::io::test
