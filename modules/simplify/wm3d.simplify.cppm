// SPDX-License-Identifier: GPL-3.0-or-later
// Written by scripts/interface-units from the public headers, which say what everything is.
module;
#include <wm3d/core.hpp>
#include <wm3d/mesh.hpp>
#include <wm3d/simplify.hpp>

export module wm3d.simplify;

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
using wm3d::check_json_depth;
using wm3d::Descriptor;
using wm3d::Edge;
using wm3d::edges_of;
using wm3d::enclosed_volume;
using wm3d::Error;
using wm3d::ErrorCode;
using wm3d::evaluate;
using wm3d::file_into;
using wm3d::Filed;
using wm3d::filed;
using wm3d::Fnv;
using wm3d::folder_of;
using wm3d::for_each_edge;
using wm3d::Frame;
using wm3d::from_base64;
using wm3d::from_hex;
using wm3d::GeometryError;
using wm3d::Index;
using wm3d::InputError;
using wm3d::inspect_topology;
using wm3d::is_printable;
using wm3d::is_utf8;
using wm3d::json_depth;
using wm3d::Mat3;
using wm3d::max_json_depth;
using wm3d::mean_radius;
using wm3d::morton_bits;
using wm3d::morton_code;
using wm3d::name;
using wm3d::Neighbours;
using wm3d::no_index;
using wm3d::notify;
using wm3d::opposite;
using wm3d::OutputError;
using wm3d::parallel_blocks;
using wm3d::parallel_invoke;
using wm3d::parallel_shares;
using wm3d::parallel_sum;
using wm3d::parallel_sum_of;
using wm3d::parallel_tasks;
using wm3d::ParameterError;
using wm3d::principal_axes;
using wm3d::principal_frame;
using wm3d::Progress;
using wm3d::Reordered;
using wm3d::return_freed_memory;
using wm3d::shape_moments;
using wm3d::ShapeMoments;
using wm3d::Side;
using wm3d::sign_choices;
using wm3d::solid_moments;
using wm3d::SolidMoments;
using wm3d::sorted_sides;
using wm3d::split_mix;
using wm3d::split_mix_finalizer;
using wm3d::split_mix_step;
using wm3d::Substance;
using wm3d::surface_area;
using wm3d::surface_box;
using wm3d::surface_moments;
using wm3d::SurfaceMoments;
using wm3d::SurfacePoint;
using wm3d::sync_folder_of;
using wm3d::thread_count;
using wm3d::ThreadLimit;
using wm3d::to_base64;
using wm3d::to_frame;
using wm3d::to_hex;
using wm3d::Topology;
using wm3d::Triangle;
using wm3d::triangle_area;
using wm3d::triangle_areas;
using wm3d::TriangleMesh;
using wm3d::Umbrella;
using wm3d::Vec3;
using wm3d::version;
using wm3d::vertex_areas;
using wm3d::vertex_mean;
using wm3d::vertex_normals;
using wm3d::weld;
using wm3d::Welded;
using wm3d::whole_number;
using wm3d::write_all;
} // namespace wm3d

export namespace wm3d::simplify {
using wm3d::simplify::Collapse;
using wm3d::simplify::describe;
using wm3d::simplify::Observer;
using wm3d::simplify::Options;
using wm3d::simplify::Result;
using wm3d::simplify::simplify;
using wm3d::simplify::Spoke;
using wm3d::simplify::Stop;
using wm3d::simplify::WorkingSurface;
} // namespace wm3d::simplify
