// SPDX-License-Identifier: GPL-3.0-or-later
#include "gltf_store.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include <Eigen/LU>

#include <wm3d/core/base64.hpp>

namespace wm3d::io {

namespace {

constexpr bool swap = swaps(std::endian::little);

double from_stored(const GltfAccessor& a, double stored) {
    const double value = stored * a.unit;
    return a.clamps ? std::max(value, -1.0) : value;
}

/// Number to store so that it reads back nearest to `value`.
double to_stored(const GltfAccessor& a, double value) {
    return nearest(a.type, value / a.unit);
}

const char* element_at(const GltfAccessor& a, const char* buffer, std::size_t i, int axis) {
    return buffer + a.offset + i * a.stride + static_cast<std::size_t>(axis) * size_of(a.type);
}

/// Shortest text of a number as its type holds it.
std::string number_text(Scalar type, double value) {
    char text[40];
    if (is_integer(type))
        return std::to_string(static_cast<std::int64_t>(value));
    const auto end = type == Scalar::f32 ? std::to_chars(text, text + sizeof text, static_cast<float>(value))
                                         : std::to_chars(text, text + sizeof text, value);
    return {text, end.ptr};
}

/// A file name as a URI: everything but letters, digits and -._~ as %XX.
std::string percent_encoded(std::string_view name) {
    std::string uri;
    for (char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 128 &&
            (std::isalnum(byte) != 0 || std::string_view("-._~").find(c) != std::string_view::npos))
            uri.push_back(c);
        else
            uri += fmt::format("%{:02X}", byte);
    }
    return uri;
}

/// Sets of elements that hang together through shared vertices.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), Index{0});
    }
    Index find(Index i) {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }
    void unite(Index a, Index b) {
        const Index ra = find(a), rb = find(b);
        parent_[std::max(ra, rb)] = std::min(ra, rb);
    }

private:
    std::vector<Index> parent_;
};

} // namespace

/// New local positions of elements and which elements really move.
struct GltfStore::Moves {
    std::vector<Vec3> local;         ///< #elements, as they will be stored
    std::vector<Vec3> world;         ///< #slots
    std::vector<std::uint8_t> moved; ///< #elements
};

GltfStore::GltfStore(GltfFile file, std::vector<GltfBlock> blocks, std::vector<GltfInstance> instances)
    : file_(std::move(file)), blocks_(std::move(blocks)), instances_(std::move(instances)) {
    for (const GltfBlock& block : blocks_) {
        const std::vector<Vec3> positions = local_positions(file_, block.accessor);
        local_.insert(local_.end(), positions.begin(), positions.end());
    }
}

std::vector<Vec3> GltfStore::local_positions(GltfFile& file, const GltfAccessor& accessor) {
    const char* const buffer = file.buffer(accessor.buffer).data();
    std::vector<Vec3> positions(accessor.count);
    for (std::size_t i = 0; i < accessor.count; ++i)
        for (int k = 0; k < 3; ++k)
            positions[i][k] =
                from_stored(accessor, load(element_at(accessor, buffer, i, k), accessor.type, swap));
    return positions;
}

double GltfStore::step(const Welding& welding) const {
    double coarsest = 0;
    std::vector<std::uint8_t> used(welding.mesh.positions.size(), 0);
    for (const Triangle& t : welding.mesh.triangles)
        for (Index v : t)
            used[v] = 1;
    for (const GltfInstance& instance : instances_) {
        const GltfBlock& block = blocks_[instance.block];
        Vec3 largest = Vec3::Zero();
        for (std::size_t i = 0; i < block.accessor.count; ++i)
            if (used[welding.vertex_of_slot[instance.first_slot + i]] != 0)
                largest = largest.cwiseMax(local_[block.first_element + i].cwiseAbs());
        for (int k = 0; k < 3; ++k) {
            const double local_step =
                step_near(block.accessor.type, largest[k] / block.accessor.unit) * block.accessor.unit;
            coarsest = std::max(coarsest, local_step * instance.placement.linear.col(k).norm());
        }
    }
    return coarsest;
}

void GltfStore::average_instances(const Welding& welding, std::span<const Vec3> wanted, Moves& moves) const {
    std::vector<Vec3> sum(local_.size(), Vec3::Zero());
    std::vector<Index> shown(local_.size(), 0);
    for (const GltfInstance& instance : instances_) {
        const GltfBlock& block = blocks_[instance.block];
        Mat3 inverse = Mat3::Zero();
        bool invertible = false;
        instance.placement.linear.computeInverseWithCheck(inverse, invertible, 0.0);
        for (std::size_t i = 0; i < block.accessor.count; ++i) {
            const Index v = welding.vertex_of_slot[instance.first_slot + i];
            const Vec3 delta = wanted[v] - welding.mesh.positions[v];
            ++shown[block.first_element + i];
            if (invertible) // flattened to a plane or less, an instance has no say
                sum[block.first_element + i] += inverse * delta;
        }
    }
    for (const GltfBlock& block : blocks_)
        for (std::size_t i = 0; i < block.accessor.count; ++i) {
            const std::size_t e = block.first_element + i;
            for (int k = 0; k < 3; ++k)
                if (sum[e][k] != 0) {
                    const double local = local_[e][k] + sum[e][k] / shown[e];
                    moves.local[e][k] = from_stored(block.accessor, to_stored(block.accessor, local));
                }
            moves.moved[e] = moves.local[e] != local_[e] ? 1 : 0;
        }
}

void GltfStore::keep_seams_closed(const Welding& welding, Moves& moves) const {
    const std::size_t vertices = welding.mesh.positions.size();
    std::vector<Index> element(welding.vertex_of_slot.size());
    std::vector<Index> first_slot(vertices, no_index);
    DisjointSets sets(local_.size());
    std::vector<Index> torn;
    for (const GltfInstance& instance : instances_)
        for (std::size_t i = 0; i < blocks_[instance.block].accessor.count; ++i) {
            const std::size_t slot = instance.first_slot + i;
            element[slot] = static_cast<Index>(blocks_[instance.block].first_element + i);
            Index& first = first_slot[welding.vertex_of_slot[slot]];
            if (first == no_index)
                first = static_cast<Index>(slot);
            sets.unite(element[first], element[slot]);
            if (moves.world[slot] != moves.world[first])
                torn.push_back(element[slot]);
        }
    std::vector<std::uint8_t> stays(local_.size(), 0);
    for (Index e : torn)
        stays[sets.find(e)] = 1;
    for (std::size_t e = 0; e < local_.size(); ++e)
        if (stays[sets.find(static_cast<Index>(e))] != 0) {
            moves.local[e] = local_[e];
            moves.moved[e] = 0;
        }
    for (std::size_t slot = 0; slot < element.size(); ++slot)
        if (moves.moved[element[slot]] == 0)
            moves.world[slot] = welding.mesh.positions[welding.vertex_of_slot[slot]];
}

GltfStore::Moves GltfStore::plan(const Welding& welding, std::span<const Vec3> wanted) const {
    Moves moves{local_, std::vector<Vec3>(welding.vertex_of_slot.size()),
                std::vector<std::uint8_t>(local_.size(), 0)};
    average_instances(welding, wanted, moves);
    for (const GltfInstance& instance : instances_) {
        const GltfBlock& block = blocks_[instance.block];
        for (std::size_t i = 0; i < block.accessor.count; ++i)
            moves.world[instance.first_slot + i] = instance.placement(moves.local[block.first_element + i]);
    }
    keep_seams_closed(welding, moves);
    return moves;
}

std::vector<Vec3> GltfStore::settle(const Welding& welding, std::span<const Vec3> wanted) const {
    const Moves moves = plan(welding, wanted);
    std::vector<Vec3> settled(welding.mesh.positions.size());
    for (std::size_t slot = 0; slot < moves.world.size(); ++slot)
        settled[welding.vertex_of_slot[slot]] = moves.world[slot];
    return settled;
}

/// Bytes of every buffer that changes; empty for the others.
std::vector<std::string> GltfStore::moved_buffers(const Moves& moves) const {
    std::vector<std::string> changed(file_.buffers().size());
    for (const GltfBlock& block : blocks_) {
        const GltfAccessor& a = block.accessor;
        const GltfFile::Buffer& buffer = file_.buffers()[a.buffer];
        for (std::size_t i = 0; i < a.count; ++i) {
            const std::size_t e = block.first_element + i;
            if (moves.moved[e] == 0)
                continue;
            if (buffer.home == GltfFile::Home::unpacked)
                file_.source().fail(
                    "its positions are compressed with EXT_meshopt_compression, which wm3d reads but does "
                    "not write; save the file without compression to change it");
            if (changed[a.buffer].empty()) // all that the buffer's file holds, even beyond byteLength
                changed[a.buffer] =
                    buffer.home == GltfFile::Home::chunk ? std::string(buffer.bytes) : *buffer.own;
            for (int k = 0; k < 3; ++k)
                if (moves.local[e][k] != local_[e][k])
                    save(const_cast<char*>(element_at(a, changed[a.buffer].data(), i, k)), a.type, swap,
                         to_stored(a, moves.local[e][k]));
        }
    }
    return changed;
}

/// Replaces the bounds that moved elements changed in all accessors of their block.
void GltfStore::edit_bounds(const Moves& moves, const GltfBlock& block, std::span<const JsonSpan> accessors,
                            JsonEdits& edits) const {
    const std::string_view text = file_.text();
    const auto extreme = [&](const std::vector<Vec3>& points, bool least) {
        Vec3 result = points[block.first_element];
        for (std::size_t i = 1; i < block.accessor.count; ++i) {
            const Vec3& p = points[block.first_element + i];
            result = least ? result.cwiseMin(p).eval() : result.cwiseMax(p).eval();
        }
        return result;
    };
    for (bool least : {true, false}) {
        const Vec3 before = extreme(local_, least), after = extreme(moves.local, least);
        for (std::size_t number : block.accessors) {
            if (before == after || number >= accessors.size())
                continue;
            const auto bound = json_member(text, accessors[number], least ? "min" : "max");
            const auto numbers = json_elements(text, bound.value_or(JsonSpan{}));
            for (std::size_t k = 0; k < numbers.size() && k < 3; ++k)
                if (const int axis = static_cast<int>(k); before[axis] != after[axis])
                    edits[numbers[k].begin] = {
                        numbers[k], number_text(block.accessor.type, to_stored(block.accessor, after[axis]))};
        }
    }
}

/// The JSON with the bounds of changed accessors and the given uris of changed buffers (empty: unchanged).
std::string GltfStore::moved_text(const Moves& moves, std::span<const std::string> uris) const {
    const std::string_view text = file_.text();
    const JsonSpan root = json_root(text);
    JsonEdits edits;
    const auto accessors = json_elements(text, json_member(text, root, "accessors").value_or(JsonSpan{}));
    for (const GltfBlock& block : blocks_)
        if (block.accessor.count > 0)
            edit_bounds(moves, block, accessors, edits);
    const auto buffers = json_elements(text, json_member(text, root, "buffers").value_or(JsonSpan{}));
    for (std::size_t b = 0; b < buffers.size() && b < uris.size(); ++b)
        if (const auto uri = json_member(text, buffers[b], "uri"); uri && !uris[b].empty())
            edits[uri->begin] = {*uri, Json(uris[b]).dump()};
    return edited(text, edits);
}

namespace {

void put_u32(std::string& bytes, std::size_t offset, std::size_t value) {
    save(bytes.data() + offset, Scalar::u32, swap, static_cast<double>(value));
}

/// The GLB with another JSON chunk and, if not empty, other bytes in its binary chunk.
std::string rebuilt_glb(const GltfFile& file, std::string text, const std::string& chunk) {
    const std::string_view bytes = file.source().bytes;
    const std::size_t text_offset = static_cast<std::size_t>(file.text().data() - bytes.data());
    const std::size_t text_end = text_offset + file.text().size();
    if (text != file.text()) {
        // The old padding would add up; what remains is padded anew to a multiple of four.
        text.erase(text.find_last_not_of(' ') + 1);
        text.append((4 - text.size() % 4) % 4, ' ');
    }
    std::string out;
    out.reserve(bytes.size() + text.size());
    out += bytes.substr(0, text_offset);
    out += text;
    out += bytes.substr(text_end);
    if (!chunk.empty())
        out.replace(file.chunk_offset() - text_end + text_offset + text.size(), chunk.size(), chunk);
    put_u32(out, 8, out.size());
    put_u32(out, 12, text.size());
    return out;
}

} // namespace

PatchedFiles GltfStore::patch(const Welding& welding, std::span<const Vec3> wanted,
                              std::string_view output_name) const {
    const Moves moves = plan(welding, wanted);
    std::vector<std::string> changed = moved_buffers(moves);
    std::vector<std::string> uris(changed.size());
    PatchedFiles files;
    std::string chunk;
    const std::string stem = std::filesystem::path(output_name).stem().string();
    for (std::size_t b = 0; b < changed.size(); ++b) {
        const GltfFile::Buffer& buffer = file_.buffers()[b];
        if (changed[b].empty())
            continue;
        if (buffer.home == GltfFile::Home::chunk) {
            chunk = std::move(changed[b]);
        } else if (buffer.home == GltfFile::Home::inline_uri) {
            uris[b] = buffer.uri_prefix + to_base64(changed[b]);
        } else if (output_name.empty()) {
            uris[b] = "data:application/octet-stream;base64," + to_base64(changed[b]);
        } else {
            const std::size_t number = files.side_files.size();
            const std::string name =
                fmt::format("{}{}.bin", stem, number == 0 ? "" : fmt::format("-{}", number));
            uris[b] = percent_encoded(name);
            files.side_files.push_back({name, std::move(changed[b])});
        }
    }
    std::string text = moved_text(moves, uris);
    files.bytes = file_.is_binary() ? rebuilt_glb(file_, std::move(text), chunk) : std::move(text);
    return files;
}

} // namespace wm3d::io
