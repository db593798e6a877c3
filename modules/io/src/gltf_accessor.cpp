// SPDX-License-Identifier: GPL-3.0-or-later
#include "gltf_accessor.hpp"

#include <fmt/format.h>

#include "gltf_meshopt.hpp"

namespace wm3d::io {

namespace {

Scalar scalar_of_code(const Source& source, std::size_t number, std::size_t code) {
    switch (code) {
    case 5120:
        return Scalar::i8;
    case 5121:
        return Scalar::u8;
    case 5122:
        return Scalar::i16;
    case 5123:
        return Scalar::u16;
    case 5125:
        return Scalar::u32;
    case 5126:
        return Scalar::f32;
    default:
        source.fail(fmt::format("accessor {} has the unknown component type {}", number, code));
    }
}

/// Whether a member exists and has that value.
template<typename T>
bool is_given(const Json& object, const char* key, const T& value) {
    const auto found = object.find(key);
    return found != object.end() && *found == Json(value);
}

/// What tells how a view is packed, if it is.
const Json* packing(const GltfFile& file, std::size_t number, const Json& view) {
    const auto extensions = view.find("extensions");
    if (extensions == view.end() || !extensions->is_object())
        return nullptr;
    if (extensions->contains("KHR_meshopt_compression"))
        file.source().fail(
            fmt::format("accessor {} is compressed with KHR_meshopt_compression, which wm3d does not read; "
                        "save the file without compression",
                        number));
    const auto packed = extensions->find("EXT_meshopt_compression");
    return packed != extensions->end() && packed->is_object() ? &*packed : nullptr;
}

/// A part of a buffer.
struct View {
    std::size_t buffer = 0, start = 0, length = 0;
};

/// Where the bytes of a view are, unpacked if need be.
View resolve_view(GltfFile& file, std::size_t accessor, std::size_t number) {
    const Source& source = file.source();
    const Json& view = gltf_entry(source, file.json(), "bufferViews", number);
    if (const Json* packed = packing(file, accessor, view)) {
        const std::size_t buffer = gltf_unpacked_view(file, number, *packed);
        return {buffer, 0, file.buffer(buffer).size()};
    }
    return {gltf_size(source, view, "buffer", 0), gltf_size(source, view, "byteOffset", 0),
            gltf_size(source, view, "byteLength", 0)};
}

/// The accessor's place, for elements of `components` numbers.
GltfAccessor resolve(GltfFile& file, std::size_t number, std::size_t components, const char* type) {
    const Source& source = file.source();
    const Json& entry = gltf_entry(source, file.json(), "accessors", number);
    if (!is_given(entry, "type", type))
        source.fail(fmt::format("accessor {} is no {}", number, type));
    if (entry.contains("sparse"))
        source.fail(fmt::format(
            "accessor {} is sparse, which wm3d does not read; save the file with plain accessors", number));
    if (!entry.contains("bufferView"))
        source.fail(
            fmt::format("accessor {} has no data of its own (compressed or empty), which wm3d does not read; "
                        "save the file without compression",
                        number));
    const std::size_t view_number = gltf_size(source, entry, "bufferView", 0);
    const auto [buffer, start, length] = resolve_view(file, number, view_number);
    const Json& view = gltf_entry(source, file.json(), "bufferViews", view_number);

    GltfAccessor accessor;
    accessor.number = number;
    accessor.type = scalar_of_code(source, number, gltf_size(source, entry, "componentType", 0));
    accessor.count = gltf_size(source, entry, "count", 0);
    accessor.buffer = buffer;
    const std::size_t element = components * size_of(accessor.type);
    accessor.stride = gltf_size(source, view, "byteStride", element);
    const std::size_t within = gltf_size(source, entry, "byteOffset", 0);
    const std::size_t available = file.buffer(accessor.buffer).size();
    if (start > available || length > available - start)
        source.fail(
            fmt::format("the buffer view of accessor {} reaches out of buffer {}", number, accessor.buffer));
    const bool fits = accessor.count == 0 ||
                      (within <= length && element <= length - within && accessor.stride >= element &&
                       (accessor.count - 1) <= (length - within - element) / accessor.stride);
    if (!fits)
        source.fail(fmt::format("accessor {} reaches out of its buffer view; the file is damaged", number));
    accessor.offset = start + within;
    return accessor;
}

} // namespace

GltfAccessor gltf_position_accessor(GltfFile& file, std::size_t number) {
    GltfAccessor accessor = resolve(file, number, 3, "VEC3");
    const Json& entry = gltf_entry(file.source(), file.json(), "accessors", number);
    if (is_integer(accessor.type) && is_given(entry, "normalized", true)) {
        accessor.unit = 1 / largest_integer(accessor.type);
        accessor.clamps = is_signed(accessor.type);
    }
    return accessor;
}

std::vector<Index> gltf_indices(GltfFile& file, std::size_t number, std::size_t vertices) {
    const GltfAccessor accessor = resolve(file, number, 1, "SCALAR");
    if (!is_integer(accessor.type) || is_signed(accessor.type))
        file.source().fail(
            fmt::format("accessor {} holds vertex numbers, but not of an unsigned type", number));
    const char* data = file.buffer(accessor.buffer).data() + accessor.offset;
    std::vector<Index> indices(accessor.count);
    for (std::size_t i = 0; i < accessor.count; ++i) {
        const double value = load(data + i * accessor.stride, accessor.type, swaps(std::endian::little));
        if (value >= static_cast<double>(vertices))
            file.source().fail(fmt::format("entry {} of accessor {} names vertex {}, but its mesh has {}", i,
                                           number, value, vertices));
        indices[i] = static_cast<Index>(value);
    }
    return indices;
}

} // namespace wm3d::io
