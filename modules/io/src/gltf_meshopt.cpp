// SPDX-License-Identifier: GPL-3.0-or-later
#include "gltf_meshopt.hpp"

#include <fmt/format.h>

#ifdef WM3D_WITH_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

namespace wm3d::io {

#ifdef WM3D_WITH_MESHOPTIMIZER

namespace {

/// No codec packs better than this: 4 bytes for a block of 256 elements, for each of an element's bytes.
constexpr std::size_t best_ratio = 64;

struct Packed {
    std::string_view bytes;
    std::size_t count = 0, stride = 0;
    std::string mode, filter;
};

std::string text_member(const Json& object, const char* key, const char* missing) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : missing;
}

/// The library asserts what it is given, so all of it is checked here.
bool is_sound(const Packed& p) {
    const bool indices = p.mode == "TRIANGLES" || p.mode == "INDICES";
    if (indices ? p.stride != 2 && p.stride != 4 : p.stride == 0 || p.stride > 256 || p.stride % 4 != 0)
        return false;
    if (p.mode == "TRIANGLES" && p.count % 3 != 0)
        return false;
    if (p.filter == "OCTAHEDRAL" && p.stride != 4 && p.stride != 8)
        return false;
    if (p.filter == "QUATERNION" && p.stride != 8)
        return false;
    return p.count <= best_ratio * (p.bytes.size() + 16) / p.stride;
}

Packed packed_view(GltfFile& file, std::size_t view, const Json& extension) {
    const Source& source = file.source();
    const std::string_view buffer = file.buffer(gltf_size(source, extension, "buffer", 0));
    const std::size_t start = gltf_size(source, extension, "byteOffset", 0);
    const std::size_t length = gltf_size(source, extension, "byteLength", 0);
    if (start > buffer.size() || length > buffer.size() - start)
        source.fail(fmt::format("buffer view {} reaches out of its buffer", view));
    return {buffer.substr(start, length), gltf_size(source, extension, "count", 0),
            gltf_size(source, extension, "byteStride", 0), text_member(extension, "mode", ""),
            text_member(extension, "filter", "NONE")};
}

bool unpack(const Packed& p, std::string& out) {
    const auto* const data = reinterpret_cast<const unsigned char*>(p.bytes.data());
    if (p.mode == "ATTRIBUTES")
        return meshopt_decodeVertexBuffer(out.data(), p.count, p.stride, data, p.bytes.size()) == 0;
    if (p.mode == "TRIANGLES")
        return meshopt_decodeIndexBuffer(out.data(), p.count, p.stride, data, p.bytes.size()) == 0;
    return p.mode == "INDICES" &&
           meshopt_decodeIndexSequence(out.data(), p.count, p.stride, data, p.bytes.size()) == 0;
}

void undo_filter(const Packed& p, std::string& out) {
    if (p.filter == "OCTAHEDRAL")
        meshopt_decodeFilterOct(out.data(), p.count, p.stride);
    else if (p.filter == "QUATERNION")
        meshopt_decodeFilterQuat(out.data(), p.count, p.stride);
    else if (p.filter == "EXPONENTIAL")
        meshopt_decodeFilterExp(out.data(), p.count, p.stride);
}

} // namespace

std::string gltf_unpacked(GltfFile& file, std::size_t view, const Json& extension) {
    const Packed packed = packed_view(file, view, extension);
    std::string out;
    if (is_sound(packed)) {
        out.resize(packed.count * packed.stride);
        if (unpack(packed, out)) {
            undo_filter(packed, out);
            return out;
        }
    }
    file.source().fail(
        fmt::format("buffer view {} can't be unpacked (EXT_meshopt_compression); the file is damaged or "
                    "packed in a newer way, so save it without compression",
                    view));
}

#else

std::string gltf_unpacked(GltfFile& file, std::size_t view, const Json&) {
    file.source().fail(
        fmt::format("buffer view {} is compressed with EXT_meshopt_compression, which this build, made "
                    "without meshoptimizer, does not read; save the file without compression",
                    view));
}

#endif

} // namespace wm3d::io
