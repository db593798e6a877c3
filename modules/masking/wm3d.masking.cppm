// SPDX-License-Identifier: GPL-3.0-or-later
// Written by scripts/interface-units from the public headers, which say what everything is.
module;
#include <wm3d/core.hpp>
#include <wm3d/detect.hpp>
#include <wm3d/masking.hpp>
#include <wm3d/mesh.hpp>
#include <wm3d/metrics.hpp>
#include <wm3d/sphere.hpp>

export module wm3d.masking;

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

export namespace wm3d::masking {
using wm3d::masking::Budget;
using wm3d::masking::BudgetOptions;
using wm3d::masking::Carriers;
using wm3d::masking::CreaseOptions;
using wm3d::masking::Creases;
using wm3d::masking::Fit;
using wm3d::masking::MarkOfStrength;
using wm3d::masking::MaskOptions;
using wm3d::masking::WeightyWindows;
using wm3d::masking::without_creases;
} // namespace wm3d::masking

export namespace wm3d::metrics {
using wm3d::metrics::ClosestPoint;
using wm3d::metrics::compare;
using wm3d::metrics::compare_vertices;
using wm3d::metrics::heat_colour;
using wm3d::metrics::heat_colours;
using wm3d::metrics::Msdm2;
using wm3d::metrics::msdm2_mean;
using wm3d::metrics::Msdm2Options;
using wm3d::metrics::Msdm2Patches;
using wm3d::metrics::Msdm2Sample;
using wm3d::metrics::OneSidedDistance;
using wm3d::metrics::Options;
using wm3d::metrics::Report;
using wm3d::metrics::Rgb;
using wm3d::metrics::surface_distance;
using wm3d::metrics::SurfaceTree;
using wm3d::metrics::vertex_distances;
using wm3d::metrics::VertexFigures;
} // namespace wm3d::metrics

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
