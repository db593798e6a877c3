// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Where a point of another surface touches this one, and whether it has a counterpart there at all.
#pragma once

#include <optional>
#include <vector>

#include <wm3d/metrics/surface_tree.hpp>

namespace wm3d::resync {

struct Contact {
    Vec3 foot;   ///< closest point of the surface
    Vec3 normal; ///< of the surface there, blended from its vertices
    double distance = 0;
};

/// A surface with its normals and borders. The mesh has to outlive it.
class ContactSurface {
public:
    /// \throw GeometryError  if the mesh has no triangle with an area
    explicit ContactSurface(const TriangleMesh& mesh);

    /// The closest point; none if it lies on a border of the surface: what is closest to a border has its
    /// counterpart beyond, if anywhere.
    std::optional<Contact> contact(const Vec3& query) const;

private:
    bool on_border(const SurfacePoint& at) const;

    const TriangleMesh& mesh_;
    metrics::SurfaceTree tree_;
    std::vector<Vec3> normals_;
    std::vector<std::array<bool, 3>>
        border_; ///< #F: whether the edge opposite corner k has one triangle only
};

} // namespace wm3d::resync
