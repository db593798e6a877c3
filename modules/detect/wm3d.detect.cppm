// SPDX-License-Identifier: GPL-3.0-or-later
// Written by scripts/interface-units from the public headers, which say what everything is.
module;
#include <wm3d/detect.hpp>
#include <wm3d/mesh.hpp>
#include <wm3d/sphere.hpp>

export module wm3d.detect;

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

export namespace wm3d::detect {
using wm3d::detect::CellSamples;
using wm3d::detect::chernoff_log10_bound;
using wm3d::detect::coarse_coordinates;
using wm3d::detect::correlation;
using wm3d::detect::Cumulants;
using wm3d::detect::cumulants;
using wm3d::detect::decide;
using wm3d::detect::describe;
using wm3d::detect::Evidence;
using wm3d::detect::EvidenceOptions;
using wm3d::detect::exact_tail;
using wm3d::detect::family_thresholds;
using wm3d::detect::FamilyScore;
using wm3d::detect::Filter;
using wm3d::detect::folds_after_rounding;
using wm3d::detect::folds_after_simplification;
using wm3d::detect::folds_as_marked;
using wm3d::detect::folds_of_flats;
using wm3d::detect::folds_under_noise;
using wm3d::detect::Hypothesis;
using wm3d::detect::Law;
using wm3d::detect::LinearStatistic;
using wm3d::detect::log10_miss_probability;
using wm3d::detect::log10_normal_orthant;
using wm3d::detect::log10_true_pf;
using wm3d::detect::miss_probability;
using wm3d::detect::most_sigmas;
using wm3d::detect::name;
using wm3d::detect::normal_sigmas;
using wm3d::detect::own_statistic;
using wm3d::detect::paper_statistic;
using wm3d::detect::paper_statistics;
using wm3d::detect::PaperStatistics;
using wm3d::detect::predicted_miss;
using wm3d::detect::reaches;
using wm3d::detect::ReferenceEvidence;
using wm3d::detect::ReferenceOptions;
using wm3d::detect::saddlepoint_log10_tail;
using wm3d::detect::Score;
using wm3d::detect::score_family;
using wm3d::detect::SequenceOfLevel;
using wm3d::detect::smoothed_scans;
using wm3d::detect::Source;
using wm3d::detect::SurfaceFilter;
using wm3d::detect::Tail;
using wm3d::detect::tail_quantile;
using wm3d::detect::threshold;
using wm3d::detect::Verdict;
} // namespace wm3d::detect

export namespace wm3d::sphere {
using wm3d::sphere::barycentric_rows;
using wm3d::sphere::bumped_radius;
using wm3d::sphere::BumpedSphere;
using wm3d::sphere::delta;
using wm3d::sphere::Descent;
using wm3d::sphere::half_turn_axis;
using wm3d::sphere::half_turns;
using wm3d::sphere::Icosphere;
using wm3d::sphere::inversion;
using wm3d::sphere::linear_delta;
using wm3d::sphere::linearization_bound;
using wm3d::sphere::max_level;
using wm3d::sphere::multiply;
using wm3d::sphere::multiply_transposed;
using wm3d::sphere::SparseRows;
using wm3d::sphere::SphereLocation;
} // namespace wm3d::sphere
