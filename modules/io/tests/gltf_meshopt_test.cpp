// SPDX-License-Identifier: GPL-3.0-or-later
// Assets packed with EXT_meshopt_compression: read like others, never written.
#include <doctest/doctest.h>

#include <fmt/format.h>

#include "gltf_support.hpp"
#include "support.hpp"

#ifdef WM3D_WITH_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

using namespace wm3d;
using namespace wm3d::io;
using namespace wm3d::io::test;

namespace {

/// The square of gltf_support.hpp with packed views; the bytes of the views lie one behind the other.
std::string packed_asset(const std::string& positions, const std::string& indices,
                         const std::string& filter = "NONE", int count = 4,
                         const std::string& index_mode = "TRIANGLES",
                         const std::string& index_filter = "NONE") {
    const auto view = [](std::size_t offset, std::size_t length, std::size_t bytes, int stride, int elements,
                         const std::string& mode, const std::string& how) {
        return fmt::format(
            R"({{"buffer":1,"byteLength":{},"extensions":{{"EXT_meshopt_compression":{{"buffer":0,)"
            R"("byteOffset":{},"byteLength":{},"byteStride":{},"count":{},"mode":"{}","filter":"{}"}}}}}})",
            bytes, offset, length, stride, elements, mode, how);
    };
    const std::string json =
        R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
        R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
        R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}],"bufferViews":[)" +
        view(0, positions.size(), 48, 12, count, "ATTRIBUTES", filter) + "," +
        view(positions.size(), indices.size(), 12, 2, 6, index_mode, index_filter) +
        fmt::format(
            R"(],"buffers":[{{"byteLength":{}}},{{"byteLength":60,"extensions":{{"EXT_meshopt_compression":)"
            R"({{"fallback":true}}}}}}]}})",
            positions.size() + indices.size());
    return glb(json, positions + indices);
}

} // namespace

#ifdef WM3D_WITH_MESHOPTIMIZER

namespace {

std::string packed_positions() {
    const std::string raw = square_buffer().substr(0, 48);
    std::string out(meshopt_encodeVertexBufferBound(4, 12), '\0');
    out.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(out.data()), out.size(),
                                          raw.data(), 4, 12));
    return out;
}

std::string packed_indices() {
    const std::vector<unsigned> indices{0, 1, 2, 0, 2, 3};
    std::string out(meshopt_encodeIndexBufferBound(6, 4), '\0');
    out.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(out.data()), out.size(),
                                         indices.data(), 6));
    return out;
}

std::string packed_sequence() {
    const std::vector<unsigned> indices{0, 1, 2, 0, 2, 3};
    std::string out(meshopt_encodeIndexSequenceBound(6, 4), '\0');
    out.resize(meshopt_encodeIndexSequence(reinterpret_cast<unsigned char*>(out.data()), out.size(),
                                           indices.data(), 6));
    return out;
}

} // namespace

TEST_CASE("packed positions and indices are read") {
    const Model model = parse_as(Format::glb, packed_asset(packed_positions(), packed_indices()));
    REQUIRE(model.mesh().positions.size() == 4);
    CHECK(model.mesh().positions[2] == Vec3(1, 1, 0));
    CHECK(model.mesh().triangles.size() == 2);
    CHECK(model.coordinate_step() > 0);
}

TEST_CASE("packed sequences of indices are read, and nothing but NONE filters them") {
    for (const char* mode : {"TRIANGLES", "INDICES"}) {
        const std::string indices = std::string(mode) == "INDICES" ? packed_sequence() : packed_indices();
        const auto asset = [&](const char* filter) {
            return packed_asset(packed_positions(), indices, "NONE", 4, mode, filter);
        };
        CHECK(parse_as(Format::glb, asset("NONE")).mesh().triangles.size() == 2);
        for (const char* filter : {"OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "SOMETHING NEW"})
            CHECK(mentions(input_error(Format::glb, asset(filter)), "can't be unpacked"));
    }
}

TEST_CASE("views of the same packed bytes are bounded together") {
    const std::string whole = packed_asset(packed_positions(), packed_indices());
    const auto within = [&](double bytes) {
        try {
            parse(whole, Format::glb, "model", {},
                  {.unpacked_per_byte = bytes / static_cast<double>(whole.size())});
            return std::string();
        } catch (const InputError& error) {
            return std::string(error.what());
        }
    };
    CHECK(within(60.5) == "");
    CHECK(mentions(within(59.5), "--any-size"));
}

TEST_CASE("packed positions are not written, and that is said") {
    const std::string bytes = packed_asset(packed_positions(), packed_indices());
    const Model model = parse_as(Format::glb, bytes);
    CHECK(model.patched(model.mesh().positions) == bytes);
    CHECK_THROWS_WITH_AS(model.patched(moved(model.mesh(), 0.1)), doctest::Contains("does not write"),
                         InputError);
}

TEST_CASE("what can't be unpacked is refused") {
    const std::string positions = packed_positions(), indices = packed_indices();
    const auto refused = [](const std::string& bytes) {
        CHECK_THROWS_WITH_AS(parse_as(Format::glb, bytes), doctest::Contains("can't be unpacked"),
                             InputError);
    };
    refused(packed_asset(positions.substr(0, positions.size() - 3), indices));
    refused(packed_asset(positions, indices.substr(0, 4)));
    std::string other_header = positions;
    other_header[0] = 'x';
    refused(packed_asset(other_header, indices));
    refused(packed_asset(positions, indices, "QUATERNION"));
    refused(packed_asset(positions, indices, "OCTAHEDRAL"));
    refused(packed_asset(positions, indices, "NONE", 4, "POINTS"));
    refused(packed_asset(positions, indices, "NONE", 100'000'000)); // before anything is allocated
}

TEST_CASE("damaged packed files are read or refused, without surprise") {
    const std::string whole = packed_asset(packed_positions(), packed_indices());
    std::uint64_t state = 88172645463325252u;
    for (int round = 0; round < 3000; ++round) {
        std::string damaged = whole;
        for (int k = 0; k <= round % 3; ++k) {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            damaged[state % damaged.size()] = static_cast<char>(state >> 32);
        }
        try {
            const std::size_t vertices = parse_as(Format::glb, damaged).mesh().positions.size();
            CHECK(vertices <= 1000);
        } catch (const Error& error) {
            CHECK(std::string(error.what()).find('\n') == std::string::npos);
        }
    }
}

#else

TEST_CASE("without meshoptimizer packed files are refused in one sentence") {
    CHECK_THROWS_WITH_AS(parse_as(Format::glb, packed_asset("x", "y")),
                         doctest::Contains("without meshoptimizer"), InputError);
}

#endif
