// SPDX-License-Identifier: GPL-3.0-or-later
// Written by scripts/interface-units from the public headers, which say what everything is.
module;
#include <wm3d/io.hpp>
#include <wm3d/mesh.hpp>

export module wm3d.io;

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

export namespace wm3d::io {
using wm3d::io::add_files;
using wm3d::io::Color;
using wm3d::io::Document;
using wm3d::io::encode;
using wm3d::io::EncodeOptions;
using wm3d::io::FileSet;
using wm3d::io::Format;
using wm3d::io::format_of_content;
using wm3d::io::format_of_name;
using wm3d::io::Limits;
using wm3d::io::Model;
using wm3d::io::name_of;
using wm3d::io::Normals;
using wm3d::io::parse;
using wm3d::io::PatchedFiles;
using wm3d::io::read;
using wm3d::io::read_file;
using wm3d::io::ReadOptions;
using wm3d::io::require_writable;
using wm3d::io::Resolver;
using wm3d::io::resolver_beside;
using wm3d::io::SideFile;
using wm3d::io::write_file;
using wm3d::io::write_files;
using wm3d::io::WriteOptions;
} // namespace wm3d::io
