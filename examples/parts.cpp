// SPDX-License-Identifier: GPL-3.0-or-later
// Uses two modules alone: the watermarking sphere of a key, and its height in one direction.
#include <cmath>
#include <cstdio>

#include <wm3d/key.hpp>
#include <wm3d/sphere.hpp>

int main() {
    const wm3d::key::Secret secret = wm3d::key::null_secret(1, 42);
    const unsigned level = 3;
    const double rmax = 0.1;
    const wm3d::sphere::BumpedSphere sphere(wm3d::sphere::Icosphere(level),
                                            wm3d::key::watermark_sequence(secret, level, rmax));
    const std::vector<wm3d::Vec3> directions{{0.3, -0.5, 0.8}};
    const double delta = sphere.deltas(directions).front(); // R_P - R of eq. (3)
    std::printf("the sphere's surface lies %.6f from its radius there\n", delta);
    return std::abs(delta) <= rmax ? 0 : 1;
}
