// SPDX-License-Identifier: GPL-3.0-or-later
// The real models, simplified and mapped.
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

#include <doctest/doctest.h>
#include <wm3d/io.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::maps;
using namespace wm3d::maps::test;

TEST_CASE("real models are mapped and their vertices come back") {
    const char* folder = std::getenv("WM3D_MESHES");
    if (folder == nullptr || !std::filesystem::exists(std::filesystem::path(folder) / "stanford-bunny.obj")) {
        std::cout << "SKIPPED: no models in WM3D_MESHES\n";
        return;
    }
    for (const std::string file : {"stanford-bunny.obj", "fandisk.obj", "rocker-arm.obj", "spot.obj",
                                   "nefertiti.obj", "horse.ply", "thing-73416.stl", "DamagedHelmet.glb"}) {
        CAPTURE(file);
        const TriangleMesh mesh = io::read(std::filesystem::path(folder) / file).mesh();
        const BaseDomain domain = parameterize(mesh, {.target_vertices = 2000});
        check_domain(mesh, domain);
        CHECK(domain.stop == simplify::Stop::reached);
        CHECK(domain.mesh.positions.size() == 2000);
        // a vertex whose image is another one's too can't return
        CHECK(not_returned(mesh, domain, 1e-9) * 2000 <= mesh.positions.size());
        const Topology before = inspect_topology(mesh), after = inspect_topology(domain.mesh);
        if (before.non_manifold_edges == 0) {
            CHECK(after.non_manifold_edges == 0);
            CHECK(after.boundary_loops == before.boundary_loops);
        }
    }
}
