// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged files either read as some mesh or are refused with one sentence; nothing else may happen.
#include <algorithm>

#include <doctest/doctest.h>

#include <wm3d/shapes.hpp>

#include "gltf_support.hpp"
#include "support.hpp"

using namespace wm3d;
using namespace wm3d::io;
using namespace wm3d::io::test;

namespace {

struct Sample {
    Format format;
    std::string bytes;
};

std::vector<Sample> samples() {
    const TriangleMesh mesh = shapes::box({1, 2, 3}, 1);
    std::vector<Sample> all;
    for (Format format : {Format::obj, Format::ply, Format::stl, Format::off, Format::gltf, Format::glb})
        for (bool ascii : {false, true})
            all.push_back({format, encode(mesh, format, {.ascii = ascii})});
    all.push_back(
        {Format::glb, glb(square_asset(R"([{"children":[1,2]},{"mesh":0},{"mesh":0,"scale":[-1,1,1]}])",
                                       R"({"byteLength":60})"),
                          square_buffer())});
    all.push_back({Format::obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 0.6 0.8\nf 1//1 2/7/2 -1//-1\n"});
    all.push_back({Format::off, "NOFF 3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0.6 0.8\n3 0 1 2\n"});
    all.push_back({Format::ply,
                   "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                   "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
                   "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                   "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0.6 0.8\n3 0 1 2\n"});
    std::string with_normals = square_asset(R"([{"mesh":0}])", R"({"byteLength":60})");
    with_normals.replace(with_normals.find("\"POSITION\":0"), 12, "\"POSITION\":0,\"NORMAL\":0");
    all.push_back({Format::glb, glb(with_normals, square_buffer())});
    return all;
}

/// Whether the bytes are read and patched, or refused, without surprise.
bool well_behaved(const Sample& sample) {
    try {
        const Model model = parse_as(sample.format, sample.bytes);
        const std::vector<Vec3> wanted = moved(model.mesh(), 0.01);
        const auto stored = model.stored_positions(wanted);
        return model.patched(model.mesh().positions) == sample.bytes && !model.patched(wanted).empty() &&
               model.coordinate_step() >= 0 && stored.size() == wanted.size() &&
               !model.patched(wanted, Normals::turn).empty();
    } catch (const Error& error) {
        const std::string message = error.what();
        return message.find('\n') == std::string::npos && message.size() < 600;
    } catch (const std::exception& error) {
        MESSAGE(error.what());
        return false;
    }
}

std::uint64_t next(std::uint64_t& state) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

} // namespace

TEST_CASE("files cut short anywhere") {
    for (const Sample& sample : samples())
        for (std::size_t size = 0; size < sample.bytes.size(); size += 3) {
            CAPTURE(name_of(sample.format));
            CAPTURE(size);
            REQUIRE(well_behaved({sample.format, sample.bytes.substr(0, size)}));
        }
}

TEST_CASE("files with damaged bytes") {
    std::uint64_t state = 0x9e3779b97f4a7c15u;
    const std::string telling = "0123456789-+.eE \n\r\t/\\\"{}[],:#v\xff\x7f";
    for (const Sample& sample : samples())
        for (int round = 0; round < 1500; ++round) {
            Sample damaged = sample;
            for (int k = 0; k <= round % 4; ++k) {
                char& byte = damaged.bytes[next(state) % damaged.bytes.size()];
                byte = round % 2 == 0 ? telling[next(state) % telling.size()]
                                      : static_cast<char>(byte ^ (1 << next(state) % 8));
            }
            CAPTURE(name_of(sample.format));
            CAPTURE(round);
            REQUIRE(well_behaved(damaged));
        }
}

TEST_CASE("files with runs cut out or doubled") {
    std::uint64_t state = 0xb5297a4d3f84d5b5u;
    for (const Sample& sample : samples())
        for (int round = 0; round < 400; ++round) {
            Sample damaged = sample;
            const std::size_t at = next(state) % damaged.bytes.size();
            const std::size_t length = std::min<std::size_t>(1 + next(state) % 40, damaged.bytes.size() - at);
            if (round % 2 == 0)
                damaged.bytes.erase(at, length);
            else
                damaged.bytes.insert(at, damaged.bytes.substr(at, length));
            CAPTURE(name_of(sample.format));
            CAPTURE(round);
            REQUIRE(well_behaved(damaged));
        }
}

TEST_CASE("every format's reader on every other format's files") {
    for (const Sample& sample : samples())
        for (Format format : {Format::obj, Format::ply, Format::stl, Format::off, Format::gltf, Format::glb})
            CHECK(well_behaved({format, sample.bytes}));
}
