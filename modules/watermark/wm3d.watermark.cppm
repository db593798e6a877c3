// SPDX-License-Identifier: GPL-3.0-or-later
// Written by scripts/interface-units from the public headers, which say what everything is.
module;
#include <wm3d/core.hpp>
#include <wm3d/detect.hpp>
#include <wm3d/embed.hpp>
#include <wm3d/io.hpp>
#include <wm3d/key.hpp>
#include <wm3d/maps.hpp>
#include <wm3d/masking.hpp>
#include <wm3d/mesh.hpp>
#include <wm3d/metrics.hpp>
#include <wm3d/payload.hpp>
#include <wm3d/resync.hpp>
#include <wm3d/search.hpp>
#include <wm3d/simplify.hpp>
#include <wm3d/sphere.hpp>
#include <wm3d/watermark.hpp>

export module wm3d.watermark;

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
using wm3d::parallel_sum;
using wm3d::parallel_tasks;
using wm3d::ParameterError;
using wm3d::principal_axes;
using wm3d::principal_frame;
using wm3d::Progress;
using wm3d::Reordered;
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

export namespace wm3d::embed {
using wm3d::embed::DetailedMesh;
using wm3d::embed::Distortion;
using wm3d::embed::distortion;
using wm3d::embed::mark_base;
using wm3d::embed::marked_radius;
using wm3d::embed::sliver_shape;
using wm3d::embed::turn_back;
using wm3d::embed::turned_faces;
} // namespace wm3d::embed

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

export namespace wm3d::key {
using wm3d::key::AskPassphrase;
using wm3d::key::commitment;
using wm3d::key::fingerprint;
using wm3d::key::index_of;
using wm3d::key::Key;
using wm3d::key::max_level;
using wm3d::key::null_secret;
using wm3d::key::Passphrase;
using wm3d::key::ProtectionCost;
using wm3d::key::PublicParameters;
using wm3d::key::Purpose;
using wm3d::key::Secret;
using wm3d::key::sequence_length;
using wm3d::key::Stream;
using wm3d::key::symmetric_unit;
using wm3d::key::watermark_sequence;
} // namespace wm3d::key

export namespace wm3d::maps {
using wm3d::maps::barycentric_coordinates;
using wm3d::maps::base_point;
using wm3d::maps::BaseDomain;
using wm3d::maps::Corners;
using wm3d::maps::image;
using wm3d::maps::InverseMap;
using wm3d::maps::original_point;
using wm3d::maps::parameterize;
} // namespace wm3d::maps

export namespace wm3d::masking {
using wm3d::masking::Budget;
using wm3d::masking::BudgetOptions;
using wm3d::masking::Carriers;
using wm3d::masking::Fit;
using wm3d::masking::MarkOfStrength;
using wm3d::masking::MaskOptions;
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

export namespace wm3d::payload {
using wm3d::payload::Accusation;
using wm3d::payload::accuse;
using wm3d::payload::Bits;
using wm3d::payload::capacity;
using wm3d::payload::Carrier;
using wm3d::payload::code_of;
using wm3d::payload::Content;
using wm3d::payload::copy_number;
using wm3d::payload::copy_scores;
using wm3d::payload::copy_sequence;
using wm3d::payload::CopyLabel;
using wm3d::payload::Format;
using wm3d::payload::format_of;
using wm3d::payload::formats;
using wm3d::payload::frame_size;
using wm3d::payload::from_frame;
using wm3d::payload::log10_messages;
using wm3d::payload::mark_sequence;
using wm3d::payload::Message;
using wm3d::payload::parse_message;
using wm3d::payload::payload_sequence;
using wm3d::payload::PolarCode;
using wm3d::payload::read_payload;
using wm3d::payload::Reading;
using wm3d::payload::ReadOptions;
using wm3d::payload::Shares;
using wm3d::payload::shares_of_weak_copies;
using wm3d::payload::sign_height;
using wm3d::payload::soft_binding_alg;
using wm3d::payload::soft_binding_value;
using wm3d::payload::soft_values;
using wm3d::payload::to_argument;
using wm3d::payload::to_frame;
using wm3d::payload::uncoded_errors;
using wm3d::payload::UncodedErrors;
} // namespace wm3d::payload

export namespace wm3d::resync {
using wm3d::resync::Ambiguity;
using wm3d::resync::angle_between;
using wm3d::resync::candidate_poses;
using wm3d::resync::CandidateOptions;
using wm3d::resync::CandidatePose;
using wm3d::resync::describe;
using wm3d::resync::digest_of;
using wm3d::resync::estimate_frame;
using wm3d::resync::FileDigest;
using wm3d::resync::FrameEstimate;
using wm3d::resync::frames_before_smoothing;
using wm3d::resync::has_registration;
using wm3d::resync::Hierarchy;
using wm3d::resync::HierarchyOptions;
using wm3d::resync::least_gap;
using wm3d::resync::LevelFrame;
using wm3d::resync::make_hierarchy;
using wm3d::resync::make_template;
using wm3d::resync::moved;
using wm3d::resync::parse_receipt;
using wm3d::resync::PoseTemplate;
using wm3d::resync::Receipt;
using wm3d::resync::receipt_points;
using wm3d::resync::register_template;
using wm3d::resync::Registration;
using wm3d::resync::RegistrationOptions;
using wm3d::resync::Similarity;
using wm3d::resync::surface_difference;
using wm3d::resync::SurfaceDifference;
using wm3d::resync::to_canonical;
using wm3d::resync::to_text;
using wm3d::resync::TrendOptions;
} // namespace wm3d::resync

export namespace wm3d::search {
using wm3d::search::Accept;
using wm3d::search::Candidate;
using wm3d::search::CentreOptions;
using wm3d::search::centres;
using wm3d::search::correlation;
using wm3d::search::Deformation;
using wm3d::search::direct_harmonics;
using wm3d::search::evaluate;
using wm3d::search::expected_sigmas;
using wm3d::search::Flat;
using wm3d::search::flats;
using wm3d::search::Harmonics;
using wm3d::search::HarmonicTransform;
using wm3d::search::KeyFunction;
using wm3d::search::lone_flat;
using wm3d::search::name;
using wm3d::search::Outline;
using wm3d::search::outline;
using wm3d::search::Pose;
using wm3d::search::PoseLattice;
using wm3d::search::refine;
using wm3d::search::Refined;
using wm3d::search::RefineOptions;
using wm3d::search::RotationCorrelation;
using wm3d::search::search_poses;
using wm3d::search::SearchOptions;
using wm3d::search::SearchOutcome;
using wm3d::search::spread;
using wm3d::search::Target;
} // namespace wm3d::search

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

export namespace wm3d::watermark {
using wm3d::watermark::ambiguity_of;
using wm3d::watermark::beside_search;
using wm3d::watermark::can_look_closer;
using wm3d::watermark::compare_with_reference;
using wm3d::watermark::content_statistic;
using wm3d::watermark::default_level;
using wm3d::watermark::default_pf;
using wm3d::watermark::default_strength;
using wm3d::watermark::default_vertices;
using wm3d::watermark::default_visibility;
using wm3d::watermark::describe_loss;
using wm3d::watermark::Detector;
using wm3d::watermark::Doubt;
using wm3d::watermark::Examination;
using wm3d::watermark::examination_options;
using wm3d::watermark::ExaminationOptions;
using wm3d::watermark::FoundPose;
using wm3d::watermark::identify;
using wm3d::watermark::IdentifyOptions;
using wm3d::watermark::IdentifyReport;
using wm3d::watermark::is_close_call;
using wm3d::watermark::IssuedCopy;
using wm3d::watermark::KnownPose;
using wm3d::watermark::largest_parts;
using wm3d::watermark::LargestParts;
using wm3d::watermark::log10_search_price;
using wm3d::watermark::look_at_whole;
using wm3d::watermark::look_closer;
using wm3d::watermark::Loss;
using wm3d::watermark::make_receipt;
using wm3d::watermark::mark;
using wm3d::watermark::mark_file;
using wm3d::watermark::mark_model;
using wm3d::watermark::mark_setting;
using wm3d::watermark::Marked;
using wm3d::watermark::MarkedFile;
using wm3d::watermark::MarkedModel;
using wm3d::watermark::Marker;
using wm3d::watermark::MarkFileOptions;
using wm3d::watermark::MarkModelOptions;
using wm3d::watermark::MarkOptions;
using wm3d::watermark::MarkSetting;
using wm3d::watermark::may_be_part;
using wm3d::watermark::most_examined;
using wm3d::watermark::name;
using wm3d::watermark::NullReport;
using wm3d::watermark::one_of_two_looks;
using wm3d::watermark::paid_for;
using wm3d::watermark::PaperReport;
using wm3d::watermark::percent;
using wm3d::watermark::PieceOptions;
using wm3d::watermark::pieces;
using wm3d::watermark::pose_by_receipt;
using wm3d::watermark::prepare_suspect;
using wm3d::watermark::Profile;
using wm3d::watermark::reference_family;
using wm3d::watermark::ReferenceView;
using wm3d::watermark::rehearse;
using wm3d::watermark::Rehearsed;
using wm3d::watermark::require_same_format;
using wm3d::watermark::Resync;
using wm3d::watermark::score_look;
using wm3d::watermark::score_null_keys;
using wm3d::watermark::search_share;
using wm3d::watermark::search_suspect;
using wm3d::watermark::SearchEffort;
using wm3d::watermark::SearchHit;
using wm3d::watermark::SearchReport;
using wm3d::watermark::SearchResult;
using wm3d::watermark::SearchUse;
using wm3d::watermark::Sequences;
using wm3d::watermark::simplify_suspect;
using wm3d::watermark::Suspect;
using wm3d::watermark::TooFewVertices;
using wm3d::watermark::TooVisible;
using wm3d::watermark::uniformity;
using wm3d::watermark::usual_strength;
using wm3d::watermark::verify;
using wm3d::watermark::VerifyOptions;
using wm3d::watermark::VerifyReport;
using wm3d::watermark::WholeSurface;
} // namespace wm3d::watermark
