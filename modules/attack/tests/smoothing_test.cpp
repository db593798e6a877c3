// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/smoothing.hpp>

#include <doctest/doctest.h>
#include <wm3d/attack/perturbation.hpp>
#include <wm3d/shapes.hpp>

#include "meshes.hpp"

using namespace wm3d;
using namespace wm3d::attack;
using namespace wm3d::attack::test;

TEST_CASE("one step moves every vertex by lambda towards the mean of its neighbours, all at once") {
    // two inner vertices in a row: the second must see the first where it was
    const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 1}, {2, 0, 2}, {3, 0, 0}, {1.5, 1, 0}, {1.5, -1, 0}},
                            {{0, 5, 1}, {1, 5, 2}, {2, 5, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}}};
    const TriangleMesh smooth = smooth_laplacian(mesh, 1, 0.1);
    const Vec3 mean1 = (mesh.positions[0] + mesh.positions[2] + mesh.positions[4] + mesh.positions[5]) / 4;
    const Vec3 mean2 = (mesh.positions[1] + mesh.positions[3] + mesh.positions[4] + mesh.positions[5]) / 4;
    CHECK((smooth.positions[1] - (0.9 * mesh.positions[1] + 0.1 * mean1)).norm() < 1e-15);
    CHECK((smooth.positions[2] - (0.9 * mesh.positions[2] + 0.1 * mean2)).norm() < 1e-15);
    for (std::size_t border : {0, 3, 4, 5})
        CHECK(smooth.positions[border] == mesh.positions[border]);
}

TEST_CASE("smoothing lowers the Dirichlet energy with every step") {
    TriangleMesh mesh = add_noise(shapes::blob(2000, 3), 2, 1);
    double energy = dirichlet_energy(mesh);
    for (int step = 0; step < 5; ++step) {
        mesh = smooth_laplacian(mesh, 1, 0.1);
        const double lower = dirichlet_energy(mesh);
        CHECK(lower < energy);
        energy = lower;
    }
}

TEST_CASE("steps add up, and no step changes nothing") {
    const TriangleMesh mesh = shapes::blob(500, 3);
    CHECK(same(smooth_laplacian(mesh, 0, 0.1), mesh));
    CHECK(same(smooth_laplacian(smooth_laplacian(mesh, 2, 0.1), 3, 0.1), smooth_laplacian(mesh, 5, 0.1)));
}

TEST_CASE("Taubin smoothing takes the noise and keeps the volume") {
    const TriangleMesh clean = shapes::sphere(1, 30);
    const TriangleMesh noisy = add_noise(clean, 1, 1);
    const TriangleMesh taubin = smooth_taubin(noisy, {20});
    const TriangleMesh laplace = smooth_laplacian(noisy, 20, 0.33);
    CHECK(dirichlet_energy(taubin) < dirichlet_energy(noisy));
    CHECK(enclosed_volume(taubin) == doctest::Approx(enclosed_volume(noisy)).epsilon(0.01));
    CHECK(enclosed_volume(laplace) < 0.98 * enclosed_volume(noisy));
}
