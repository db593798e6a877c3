// SPDX-License-Identifier: GPL-3.0-or-later
// The real models: counts, and the round trip of a patch.
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include <doctest/doctest.h>

#include <wm3d/mesh/measure.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::io;
using namespace wm3d::io::test;

namespace {

struct Expected {
    const char* file;
    std::size_t slots, vertices, triangles;
};

// From the files' own headers and line counts; welded counts of binary STL and GLB by an independent count of
// distinct positions.
constexpr Expected models[] = {
    {"stanford-bunny.obj", 35947, 35947, 69451},
    {"fandisk.obj", 6475, 6475, 12946},
    {"nefertiti.obj", 49971, 49971, 99938},
    {"rocker-arm.obj", 10044, 10044, 20088},
    {"spot.obj", 2930, 2930, 5856},
    {"horse.ply", 48485, 48485, 96966},
    {"igea.ply", 134345, 134345, 268686},
    {"thing-73416.stl", 230520, 38396, 76840},
    {"DamagedHelmet.glb", 14556, 8661, 15452},
};

} // namespace

TEST_CASE("real models are read, patched and read again") {
    const char* folder = std::getenv("WM3D_MESHES");
    if (folder == nullptr || !std::filesystem::exists(std::filesystem::path(folder) / models[0].file)) {
        std::cout << "SKIPPED: no models in WM3D_MESHES\n";
        return;
    }
    for (const Expected& expected : models) {
        CAPTURE(expected.file);
        const std::filesystem::path path = std::filesystem::path(folder) / expected.file;
        const Model model = read(path);
        CHECK(model.vertex_of_slot().size() == expected.slots);
        CHECK(model.mesh().positions.size() == expected.vertices);
        CHECK(model.mesh().triangles.size() == expected.triangles);
        CHECK(model.patched(model.mesh().positions) == read_file(path));
        const std::vector<Vec3> wanted = moved(model.mesh(), 5e-4 * surface_box(model.mesh()).diagonal());
        check_reads_back(model, parse_as(model.format(), model.patched(wanted)),
                         model.stored_positions(wanted));
    }
}
