// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What the benches of the search have in common: the scans, copies, and searches with their times.
#pragma once

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include <wm3d/attack.hpp>
#include <wm3d/io.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/watermark/verify.hpp>

namespace wm3d::bench {

inline const std::vector<std::string> scans{"stanford-bunny.obj", "horse.ply", "nefertiti.obj", "igea.ply",
                                            "rocker-arm.obj"};

/// A model of the folder WM3D_MESHES.
inline TriangleMesh load(const std::string& name) {
    const char* folder = std::getenv("WM3D_MESHES");
    return io::read(std::filesystem::path(folder ? folder : ".") / name).mesh();
}

/// Turned, scaled and shifted at random.
inline TriangleMesh moved(const TriangleMesh& mesh, std::uint64_t seed) {
    return attack::apply(mesh, attack::parse("similarity"), seed);
}

inline TriangleMesh mirrored(TriangleMesh mesh) {
    for (Vec3& p : mesh.positions)
        p.x() = -p.x();
    for (Triangle& t : mesh.triangles)
        std::swap(t[0], t[1]);
    return mesh;
}

/// Both meshes side by side, the second so large that its box's diagonal is `ratio` times the first one's.
inline TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b, double ratio) {
    const Box of_a = surface_box(a), of_b = surface_box(b);
    const double factor = ratio * of_a.diagonal() / of_b.diagonal();
    const Vec3 place = of_a.max + Vec3(0.1, 0, 0) * of_a.diagonal();
    TriangleMesh scene = a;
    const auto first = static_cast<Index>(a.positions.size());
    for (const Vec3& p : b.positions)
        scene.positions.push_back(place + factor * (p - of_b.min));
    for (Triangle t : b.triangles) {
        for (Index& v : t)
            v += first;
        scene.triangles.push_back(t);
    }
    return scene;
}

struct Searched {
    watermark::VerifyReport report;
    double seconds; ///< of the processor
};

inline Searched searched(const TriangleMesh& suspect, const key::Key& key,
                         watermark::VerifyOptions options = {}) {
    const std::clock_t begin = std::clock();
    watermark::VerifyReport report = watermark::verify(suspect, key, options);
    return {std::move(report), static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC};
}

} // namespace wm3d::bench
