// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/shapes/turned.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace wm3d::shapes {

namespace {

/// Distance from the z axis, and height.
struct ProfilePoint {
    double radius, height;
};

/// The surface that a profile sweeps: `profile(s, angle)` for s from 0 at the lower pole to 1 at the upper
/// one.
TriangleMesh swept(std::size_t vertices, double aspect,
                   const std::function<ProfilePoint(double s, double angle)>& profile) {
    const double ideal = std::sqrt(static_cast<double>(vertices) * aspect);
    const auto columns = static_cast<Index>(std::max(8.0, ideal));
    const auto rings = static_cast<Index>(std::max<std::size_t>(4, vertices / columns));
    TriangleMesh mesh;
    mesh.positions.emplace_back(0, 0, profile(0, 0).height);
    for (Index r = 1; r <= rings; ++r)
        for (Index c = 0; c < columns; ++c) {
            const double angle = 2 * std::numbers::pi * c / columns;
            const ProfilePoint p = profile(static_cast<double>(r) / (rings + 1), angle);
            mesh.positions.emplace_back(p.radius * std::cos(angle), p.radius * std::sin(angle), p.height);
        }
    const auto top = static_cast<Index>(mesh.positions.size());
    mesh.positions.emplace_back(0, 0, profile(1, 0).height);
    const auto at = [&](Index r, Index c) { return 1 + r * columns + c % columns; };
    for (Index c = 0; c < columns; ++c) {
        mesh.triangles.push_back({0, at(0, c + 1), at(0, c)});
        for (Index r = 0; r + 1 < rings; ++r) {
            mesh.triangles.push_back({at(r, c), at(r, c + 1), at(r + 1, c + 1)});
            mesh.triangles.push_back({at(r, c), at(r + 1, c + 1), at(r + 1, c)});
        }
        mesh.triangles.push_back({top, at(rings - 1, c), at(rings - 1, c + 1)});
    }
    return mesh;
}

/// Out along the lower face, up the rim, back along the upper face.
ProfilePoint flat(double s, double radius, double thickness, double dome) {
    constexpr double face = 0.45; // of the profile
    const double along = std::min(1.0, std::min(s, 1 - s) / face);
    const double rim = std::clamp((s - face) / (1 - 2 * face), 0.0, 1.0) * 2 - 1;
    const double half = thickness / 2 + dome * (1 - along * along);
    return {radius * along, along < 1 ? (s < 0.5 ? -half : half) : rim * thickness / 2};
}

} // namespace

TriangleMesh vase(std::size_t vertices) {
    return swept(vertices, 1, [](double s, double angle) -> ProfilePoint {
        const double height = 2.4 * s - 1.2, belly = std::sqrt(s * (1 - s) * 4);
        const double outline = belly * (0.7 + 0.25 * std::sin(4.5 * s + 0.4));
        const double relief =
            0.004 * std::sin(36 * angle) * std::sin(40 * s) + 0.003 * std::sin(23 * angle + 30 * s);
        return {outline * (1 + relief * belly), height};
    });
}

TriangleMesh gear(int teeth, std::size_t vertices) {
    return swept(vertices, 2, [teeth](double s, double angle) {
        const double tooth = std::clamp(3 * std::sin(teeth * angle), -1.0, 1.0);
        return flat(s, 1 + 0.06 * tooth * std::min(1.0, 4 * std::min(s, 1 - s)), 0.3, 0.02);
    });
}

TriangleMesh disc(std::size_t vertices) {
    return swept(vertices, 2, [](double s, double) { return flat(s, 1, 0.2, 0.05); });
}

} // namespace wm3d::shapes
