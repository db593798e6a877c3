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

bool is_sound_filter(const Packed& p) {
    if (p.filter == "OCTAHEDRAL")
        return p.stride == 4 || p.stride == 8;
    if (p.filter == "QUATERNION")
        return p.stride == 8;
    return p.filter == "EXPONENTIAL" || p.filter == "NONE";
}

/// The library asserts what it is given, so all of it is checked here, as the extension's text has it.
bool is_sound(const Packed& p) {
    if (p.mode == "ATTRIBUTES") {
        if (p.stride == 0 || p.stride > 256 || p.stride % 4 != 0 || !is_sound_filter(p))
            return false;
    } else {
        if ((p.mode != "TRIANGLES" && p.mode != "INDICES") || (p.stride != 2 && p.stride != 4) ||
            p.filter != "NONE" || (p.mode == "TRIANGLES" && p.count % 3 != 0))
            return false;
    }
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
    return meshopt_decodeIndexSequence(out.data(), p.count, p.stride, data, p.bytes.size()) == 0;
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

std::size_t gltf_unpacked_view(GltfFile& file, std::size_t view, const Json& extension) {
    const Packed packed = packed_view(file, view, extension);
    const auto refuse = [&] {
        file.source().fail(
            fmt::format("buffer view {} can't be unpacked (EXT_meshopt_compression); the file is damaged or "
                        "packed in a newer way, so save it without compression",
                        view));
    };
    if (!is_sound(packed))
        refuse();
    return file.unpacked_view(view, packed.count * packed.stride, [&] {
        std::string out(packed.count * packed.stride, '\0');
        if (!unpack(packed, out))
            refuse();
        undo_filter(packed, out);
        return out;
    });
}

#else

std::size_t gltf_unpacked_view(GltfFile& file, std::size_t view, const Json&) {
    file.source().fail(
        fmt::format("buffer view {} is compressed with EXT_meshopt_compression, which this build, made "
                    "without meshoptimizer, does not read; save the file without compression",
                    view));
}

#endif

} // namespace wm3d::io
