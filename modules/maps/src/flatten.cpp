// SPDX-License-Identifier: GPL-3.0-or-later
#include "flatten.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wm3d::maps {

void flatten(std::span<const Vec3> ring, bool closed, std::vector<Vec2>& plane) {
    const std::size_t size = ring.size(), gaps = closed ? size : size - 1;
    plane.resize(size);
    double longest2 = 0, total = 0;
    for (std::size_t i = 0; i < size; ++i) { // (length squared, angle to the next) until both sums are known
        const Vec3 &p = ring[i], &q = ring[i + 1 == size ? 0 : i + 1];
        const double length2 = p.squaredNorm();
        const double angle = i < gaps ? std::atan2(p.cross(q).norm(), p.dot(q)) : 0;
        plane[i] = {length2, angle};
        longest2 = std::max(longest2, length2);
        total += angle;
    }
    const double full = (closed ? 2 : 1) * std::numbers::pi;
    const bool thin = !(total > 1e-9);
    const double a = thin ? 1 : full / total;
    double turned = 0;
    for (std::size_t i = 0; i < size; ++i) {
        const double radius = longest2 > 0 ? std::pow(plane[i][0] / longest2, 0.5 * a) : 0; // |z|^a
        const double step = thin ? full / static_cast<double>(gaps) : a * plane[i][1];
        plane[i] = {radius * std::cos(turned), radius * std::sin(turned)};
        turned += step;
    }
    if (!closed)
        plane.back() = {-plane.back().norm(), 0}; // without the rounding of pi
}

} // namespace wm3d::maps
