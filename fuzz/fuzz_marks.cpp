// SPDX-License-Identifier: GPL-3.0-or-later
// Small meshes of any shape are marked and verified, or refused with wm3d::Error: connectivity stays, moves
// are finite, and the verdict has a probability. The bytes are an OFF file's or else a list of corners.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include <wm3d/core/error.hpp>
#include <wm3d/io.hpp>
#include <wm3d/mesh/weld.hpp>
#include <wm3d/watermark.hpp>

namespace {

using namespace wm3d;

constexpr std::size_t most_triangles = 400;

/// Triangles of corners on a lattice of 16 steps: coincidences, slivers and folds of every kind.
TriangleMesh lattice_mesh(const std::uint8_t* data, std::size_t size) {
    std::vector<Vec3> corners;
    for (std::size_t i = 0; i + 1 < size && corners.size() < 3 * most_triangles; i += 2)
        corners.emplace_back(data[i] % 16, data[i] / 16, data[i + 1] % 16);
    std::vector<Triangle> triangles;
    for (Index i = 0; i + 2 < corners.size(); i += 3)
        triangles.push_back({i, i + 1, i + 2});
    return weld(corners, triangles).mesh;
}

void require(bool holds) {
    if (!holds)
        std::abort();
}

void mark_and_verify(const TriangleMesh& mesh) {
    static const key::Key key = key::Key::generate("fuzz", {{1, 2}, 0.1, 0.05});
    watermark::MarkOptions options;
    options.level = 2;
    options.vertices = 100;
    options.strength = 0.5;
    const watermark::Marked marked = watermark::mark(mesh, key, options);
    require(marked.positions.size() == mesh.positions.size());
    for (const Vec3& p : marked.positions)
        require(p.allFinite());
    watermark::VerifyOptions check;
    check.vertices = options.vertices;
    check.effort = 0;
    const auto report = watermark::verify({marked.positions, mesh.triangles}, key, check);
    require(!std::isnan(report.score.log10_p) && report.score.log10_p <= 0);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        if (size > 3 && std::string_view(reinterpret_cast<const char*>(data), 3) == "OFF") {
            const io::Model model =
                io::parse(std::string(reinterpret_cast<const char*>(data), size), io::Format::off, "fuzz");
            if (model.mesh().triangles.size() <= most_triangles)
                mark_and_verify(model.mesh());
        } else {
            mark_and_verify(lattice_mesh(data, size));
        }
    } catch (const wm3d::Error&) {
    }
    return 0;
}
