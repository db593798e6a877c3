// SPDX-License-Identifier: GPL-3.0-or-later
// Written by scripts/interface-units from the public headers, which say what everything is.
module;
#include <wm3d/mesh.hpp>
#include <wm3d/shapes.hpp>

export module wm3d.shapes;

export namespace wm3d {
using wm3d::along_curve;
using wm3d::area_vector;
using wm3d::border_loops;
using wm3d::border_vertices;
using wm3d::BorderLoop;
using wm3d::bounding_box;
using wm3d::Box;
using wm3d::canonical_frame;
using wm3d::central_moments;
using wm3d::CentralMoments;
using wm3d::Edge;
using wm3d::edges_of;
using wm3d::enclosed_volume;
using wm3d::evaluate;
using wm3d::for_each_edge;
using wm3d::Frame;
using wm3d::Index;
using wm3d::inspect_topology;
using wm3d::Mat3;
using wm3d::mean_radius;
using wm3d::morton_bits;
using wm3d::morton_code;
using wm3d::Neighbours;
using wm3d::no_index;
using wm3d::opposite;
using wm3d::principal_axes;
using wm3d::principal_frame;
using wm3d::Reordered;
using wm3d::shape_moments;
using wm3d::ShapeMoments;
using wm3d::Side;
using wm3d::sign_choices;
using wm3d::solid_moments;
using wm3d::SolidMoments;
using wm3d::sorted_sides;
using wm3d::Substance;
using wm3d::surface_area;
using wm3d::surface_box;
using wm3d::surface_moments;
using wm3d::SurfaceMoments;
using wm3d::SurfacePoint;
using wm3d::to_frame;
using wm3d::Topology;
using wm3d::Triangle;
using wm3d::triangle_area;
using wm3d::triangle_areas;
using wm3d::TriangleMesh;
using wm3d::Umbrella;
using wm3d::Vec3;
using wm3d::vertex_areas;
using wm3d::vertex_mean;
using wm3d::vertex_normals;
using wm3d::weld;
using wm3d::Welded;
} // namespace wm3d

export namespace wm3d::shapes {
using wm3d::shapes::blob;
using wm3d::shapes::box;
using wm3d::shapes::contour;
using wm3d::shapes::ContourOptions;
using wm3d::shapes::disc;
using wm3d::shapes::ellipsoid;
using wm3d::shapes::gear;
using wm3d::shapes::sample;
using wm3d::shapes::sample_max_faces;
using wm3d::shapes::sample_min_faces;
using wm3d::shapes::Solid;
using wm3d::shapes::sphere;
using wm3d::shapes::square;
using wm3d::shapes::torus;
using wm3d::shapes::vase;
} // namespace wm3d::shapes
