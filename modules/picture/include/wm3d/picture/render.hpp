// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  From a mesh to pixels.
#pragma once

#include <span>

#include <wm3d/mesh/triangle_mesh.hpp>
#include <wm3d/picture/image.hpp>

namespace wm3d::picture {

/// Looks along parallel rays.
struct Camera {
    Vec3 backwards = Vec3::UnitZ(); ///< from the model to the viewer, unit length
    Vec3 upwards = Vec3::UnitY();   ///< in the picture, unit length, at right angles to `backwards`
    Vec3 centre = Vec3::Zero();     ///< what is in the middle of the picture
    double height = 1;              ///< of what the picture shows, in units of the mesh
};

/// A camera that shows the whole surface with a little room around.
/// \pre  `backwards` and `up` are not parallel
Camera frame(const TriangleMesh& mesh, const Vec3& backwards, const Vec3& up);

/// The same camera on a part: `x` and `y` from -1 to 1 (left to right, bottom to top of a square picture) say
/// where it looks, and all is `zoom` times larger.
Camera close_up(const Camera& camera, double x, double y, double zoom);

struct RenderOptions {
    std::size_t width = 600, height = 600; ///< pixels
    std::size_t samples = 3;               ///< in each direction of a pixel
    bool smooth = true;                    ///< blend the normals of the corners over a triangle
    /// Direction to the light as the viewer sees it: to the right, upwards, towards the viewer. The default
    /// rakes over what faces the viewer, at 15 degrees.
    Vec3 light = Vec3(-0.77, 0.58, 0.26);
    double ambient = 0.10;                 ///< share of light from everywhere
    double headlight = 0.20;               ///< share of light from the viewer
    std::span<const Rgb> vertex_colours{}; ///< #V, or none for a light grey
    Rgb background{255, 255, 255};
};

/// \throw ParameterError  if the picture has no pixels, or colours are given that are not one for each vertex
Image render(const TriangleMesh& mesh, const Camera& camera, const RenderOptions& options = {});

} // namespace wm3d::picture
