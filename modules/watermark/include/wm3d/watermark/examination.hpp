// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A suspect made ready for any key: frame, base mesh, evidence, and the hypotheses that will be
/// tried.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <wm3d/core/progress.hpp>
#include <wm3d/detect/evidence.hpp>
#include <wm3d/detect/family.hpp>
#include <wm3d/detect/paper_null.hpp>
#include <wm3d/mesh/frame.hpp>
#include <wm3d/resync/candidate_pose.hpp>
#include <wm3d/resync/hierarchical_frame.hpp>
#include <wm3d/sphere/icosphere.hpp>
#include <wm3d/watermark/defaults.hpp>
#include <wm3d/watermark/sequences.hpp>
#include <wm3d/watermark/suspect.hpp>

namespace wm3d::watermark {

/// Which poses of the suspect are examined, besides those that the caller gives.
enum class Resync {
    none, ///< the canonical frame as the surface's moments give it, axis signs by the third moments
    pca,  ///< those that hierarchical principal components leave possible (resync::candidate_poses)
    icp,  ///< none: registration against a receipt or a reference gives them
};

struct ExaminationOptions {
    std::size_t vertices = default_vertices;  ///< to simplify to
    std::vector<unsigned> levels{3, 4, 5, 6}; ///< of the watermarking sphere, each tried
    double rmax = 0.1;
    Resync resync = Resync::pca;
    std::vector<resync::CandidatePose>
        poses; ///< tried too, after those of `resync`; not to depend on any key
    detect::EvidenceOptions evidence;
};

/// What a key with these parameters asks for.
ExaminationOptions examination_options(const key::PublicParameters& parameters, std::size_t vertices);

/// Everything about a suspect that no key is needed for. Poses share the evidence as far as they can.
class Examination {
public:
    /// \throw GeometryError  if the mesh has no area
    Examination(const TriangleMesh& suspect, ExaminationOptions options, const Progress& progress = {});
    Examination(const Suspect& suspect, ExaminationOptions options, const Progress& progress = {});

    const ExaminationOptions& options() const { return options_; }
    std::size_t base_vertices() const { return base_vertices_; }
    simplify::Stop stop() const { return stop_; }
    double telling() const { return telling_; }

    /// What the suspect's own axes leave open, where they were asked.
    resync::Ambiguity ambiguity() const { return ambiguity_; }

    /// Least relative distance of two of the suspect's moments, where its axes were asked: the smaller, the more
    /// a deformation turns them.
    double moment_gap() const { return moment_gap_; }

    std::size_t poses() const { return poses_.size(); }
    const resync::CandidatePose& pose(std::size_t pose) const { return poses_[pose].candidate; }
    const detect::Evidence& evidence(std::size_t pose = 0) const { return *view(pose).evidence; }

    /// Poses times levels times filters, each hypothesis with its linear statistic; on coarse suspects twice,
    /// at the vertices and around them. Poses that are second guesses are read on the usual levels alone.
    std::span<const detect::Hypothesis> family() const { return family_; }

    /// Expected score, in standard deviations, of the best filter for a mark of this level whose
    /// area-weighted RMS normal move is `strength` % of the bounding box's diagonal; with `filter`, in that
    /// filter alone. 0 where less than half of the surface can show a mark.
    double expected_sigmas(Sequences& sequences, unsigned level, double strength, std::size_t pose = 0,
                           std::optional<std::size_t> filter = {}) const;

    /// gamma of eq. (3) that moves this base mesh by `strength` with the mark of this level.
    double gamma(Sequences& sequences, unsigned level, double strength, std::size_t pose = 0) const;

    /// Radii of the base vertices in a pose, in units of its mean radius.
    std::vector<double> radii(std::size_t pose = 0) const;

    /// B for the base vertices' directions in a pose.
    sphere::SparseRows rows(std::size_t pose, unsigned level) const;

private:
    /// The base mesh around one centre and at one scale.
    struct View {
        Frame frame;
        TriangleMesh base;
        std::unique_ptr<detect::Evidence> evidence;
    };
    struct Pose {
        resync::CandidatePose candidate;
        std::size_t view = 0;
        Mat3 turn = Mat3::Identity(); ///< from the view's axes to the pose's
    };

    const View& view(std::size_t pose) const { return views_[poses_[pose].view]; }
    std::vector<sphere::SparseRows> rows(std::size_t pose, std::span<const unsigned> levels) const;
    void make_poses(const Suspect& suspect, const Progress& progress);
    resync::Hierarchy first_look(const Suspect& suspect, const WholeSurface& whole, const Progress& progress);
    void add_principal_poses(const Suspect& suspect, const Progress& progress);
    void look(View& view, const TriangleMesh& base) const;
    void gather_evidence(const TriangleMesh& base);
    std::size_t view_of(const Frame& frame);
    void add_pose(const resync::CandidatePose& candidate);
    /// A pose that another is a half turn of the sphere away from, so that they share their statistics; itself, and no
    /// axis, if there is none.
    struct Leader {
        std::size_t pose = 0;
        std::optional<std::size_t> axis;
    };

    void make_family();
    std::vector<Leader> leading_poses() const;
    const std::vector<unsigned>& levels_of(std::size_t pose) const;
    /// At the vertices, or around them where samples are given; `of_level` has B for either.
    void add_hypotheses(std::vector<detect::Hypothesis>& hypotheses, std::size_t pose,
                        std::span<const sphere::SparseRows> of_level,
                        const detect::CellSamples* samples) const;

    ExaminationOptions options_;
    std::vector<unsigned> usual_levels_; ///< on which a mark lies if nobody asks for another
    sphere::Icosphere finest_;           ///< of the levels
    std::size_t base_vertices_ = 0;
    double diagonal_ = 0; ///< of the suspect's box
    simplify::Stop stop_ = simplify::Stop::reached;
    double telling_ = 1;
    resync::Ambiguity ambiguity_ = resync::Ambiguity::none;
    double moment_gap_ = 1;
    std::vector<View> views_;
    std::vector<Pose> poses_;
    std::vector<detect::Hypothesis> family_;
    std::vector<sphere::SparseRows>
        first_rows_; ///< of the first pose, which is asked for again: what is told of it
};

} // namespace wm3d::watermark
