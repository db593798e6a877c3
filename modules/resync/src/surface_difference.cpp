// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/resync/surface_difference.hpp>

#include <cmath>
#include <numeric>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>

#include "surface_contact.hpp"

namespace wm3d::resync {

SurfaceDifference surface_difference(const TriangleMesh& reference, const TriangleMesh& suspect,
                                     double reach) {
    constexpr double least_cosine = 0.3;
    const ContactSurface surface(suspect);
    const std::vector<Vec3> normals = vertex_normals(reference);
    const std::size_t count = reference.positions.size();
    SurfaceDifference result{std::vector<double>(count, 0.0), std::vector<double>(count, 0.0), 0};
    parallel_blocks(count, 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::optional<Contact> contact = surface.contact(reference.positions[i]);
            if (!contact || contact->distance > reach ||
                std::abs(contact->normal.dot(normals[i])) < least_cosine) // mirrors turn normals round
                continue;
            result.along_normal[i] = normals[i].dot(contact->foot - reference.positions[i]);
            result.trust[i] = 1;
        }
    });
    const double trusted = std::accumulate(result.trust.begin(), result.trust.end(), 0.0);
    result.covered = count > 0 ? trusted / static_cast<double>(count) : 0;
    return result;
}

} // namespace wm3d::resync
