// SPDX-License-Identifier: GPL-3.0-or-later
// Small meshes of any shape are marked and verified, or refused with wm3d::Error: connectivity stays, moves
// are finite, and the verdict has a probability. The first byte chooses the profile, the others are an OFF
// file's or else a list of corners.
#include <cmath>

#include <wm3d/core/parallel.hpp>
#include <wm3d/io.hpp>
#include <wm3d/mesh/weld.hpp>
#include <wm3d/watermark.hpp>

#include "target.hpp"

using namespace wm3d;

namespace {

constexpr std::size_t most_triangles = 150;

/// Triangles of corners on a lattice of 16 steps: coincidences, slivers and folds of every kind.
TriangleMesh lattice_mesh(std::string_view bytes) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    std::vector<Vec3> corners;
    for (std::size_t i = 0; i + 1 < bytes.size() && corners.size() < 3 * most_triangles; i += 2)
        corners.emplace_back(byte(i) % 16, byte(i) / 16, byte(i + 1) % 16);
    std::vector<Triangle> triangles;
    for (Index i = 0; i + 2 < corners.size(); i += 3)
        triangles.push_back({i, i + 1, i + 2});
    return weld(corners, triangles).mesh;
}

/// Of one coarse level, which makes a mark and its verdict a matter of milliseconds.
key::Key coarse_key() {
    return key::Key::parse(
        "wm3d key, version 1\n"
        "# Keep this file secret and keep a copy: whoever has it can make and prove marks.\n"
        "name: fuzzing: published, so worthless\n"
        "secret: 8e5c6a1f0b7d42933e1a9f4c5d60b7281f3e2d4c5b6a79880123456789abcdef\n"
        "levels: 2\n"
        "rmax: 0.1\n"
        "reference-strength: 0.05\n"
        "created-by: wm3d 0.2.0\n"
        "checksum: bca377b68012e836b7a0e6a4bb3e3fd0\n",
        "coarse.key");
}

void mark_and_verify(const TriangleMesh& mesh, watermark::Profile profile) {
    static const key::Key key = coarse_key();
    watermark::MarkOptions options;
    options.profile = profile;
    options.level = 2;
    options.vertices = 100;
    if (profile != watermark::Profile::masked)
        options.strength = 0.5;
    const watermark::Marked marked = watermark::mark(mesh, key, options);
    fuzz::require(marked.positions.size() == mesh.positions.size());
    for (const Vec3& p : marked.positions)
        fuzz::require(p.allFinite());
    watermark::VerifyOptions check;
    check.vertices = options.vertices;
    check.effort = 0;
    const auto report = watermark::verify({marked.positions, mesh.triangles}, key, check);
    fuzz::require(!std::isnan(report.score.log10_p) && report.score.log10_p <= 0);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    static const ThreadLimit one_thread(1); // what is reached is counted without a race
    const auto profile = static_cast<watermark::Profile>(data[0] % 3);
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        if (bytes.starts_with("OFF")) {
            const io::Model model = io::parse(std::string(bytes), io::Format::off, "fuzz");
            if (model.mesh().triangles.size() <= most_triangles)
                mark_and_verify(model.mesh(), profile);
        } else {
            mark_and_verify(lattice_mesh(bytes), profile);
        }
    } catch (const Error&) {
    }
    return 0;
}
