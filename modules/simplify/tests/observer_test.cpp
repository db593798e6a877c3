// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/simplify/observer.hpp>

#include <doctest/doctest.h>
#include <wm3d/shapes.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::simplify;
using namespace wm3d::simplify::test;

namespace {

/// Redoes the collapses on a plain array of corners and checks each step against it.
class Replay : public Observer {
public:
    void start(const WorkingSurface& surface) override {
        corners.assign(surface.corners.begin(), surface.corners.end());
        alive.assign(corners.size() / 3, true);
        input_vertex.assign(surface.input_vertex.begin(), surface.input_vertex.end());
        REQUIRE(surface.positions.size() == input_vertex.size());
    }

    void collapse(const Collapse& step) override {
        const std::size_t size = step.ring.size(), triangles = size - (step.closed() ? 0 : 1);
        bool sound = step.ring[step.place].vertex == step.kept;
        sound = sound && (step.closed() || step.place == 0 || step.place + 1 == size);
        for (std::size_t i = 0; i < triangles; ++i) {
            const Index c = step.ring[i].corner, f = c / 3;
            const std::size_t j = (i + 1) % size;
            sound = sound && alive[f] && corners[c] == step.removed &&
                    corners[3 * f + (c + 1) % 3] == step.ring[i].vertex &&
                    corners[3 * f + (c + 2) % 3] == step.ring[j].vertex;
            corners[c] = step.kept;
            alive[f] = i != step.place && j != step.place;
        }
        if (step.beyond != no_index) {
            const Index f = step.beyond / 3;
            sound = sound && triangles == 1 && alive[f] && corners[step.beyond] == step.ring[1].vertex &&
                    corners[3 * f + (step.beyond + 1) % 3] == step.ring[0].vertex;
        }
        wrong += !sound;
        ++steps;
    }

    void finish(std::span<const Index> faces) override { final_faces.assign(faces.begin(), faces.end()); }

    std::vector<Index> corners, input_vertex, final_faces;
    std::vector<bool> alive;
    std::size_t steps = 0, wrong = 0;
};

} // namespace

TEST_CASE("the steps that an observer is told lead from the input to the base mesh") {
    for (const TriangleMesh& mesh : {shapes::blob(1500, 2), shapes::square(1, 18), moebius(40, 5),
                                     three_pages(10), shapes::torus(2, 1, 24, 12)}) {
        Replay replay;
        const Result result = simplify::simplify(mesh, {.target_vertices = 60}, replay);
        CHECK(replay.wrong == 0);
        CHECK(replay.steps == result.collapses);
        CHECK(static_cast<std::size_t>(std::ranges::count(replay.alive, true)) ==
              result.mesh.triangles.size());
        REQUIRE(replay.final_faces.size() == result.mesh.triangles.size());
        for (std::size_t t = 0; t < replay.final_faces.size(); ++t)
            for (Index k = 0; k < 3; ++k)
                CHECK(replay.input_vertex[replay.corners[3 * replay.final_faces[t] + k]] ==
                      result.original[result.mesh.triangles[t][k]]);
    }
}

TEST_CASE("watching changes nothing") {
    const TriangleMesh mesh = shapes::blob(1500, 2);
    Replay replay;
    const Result watched = simplify::simplify(mesh, {.target_vertices = 60}, replay);
    const Result alone = simplify::simplify(mesh, {.target_vertices = 60});
    CHECK(watched.original == alone.original);
    CHECK(watched.mesh.triangles == alone.mesh.triangles);
}
