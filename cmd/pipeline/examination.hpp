// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A suspect made ready for any key: frame, base mesh, evidence, and the hypotheses that will be tried.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include <wm3d/detect/evidence.hpp>
#include <wm3d/detect/family.hpp>
#include <wm3d/detect/paper_null.hpp>
#include <wm3d/mesh/frame.hpp>
#include <wm3d/mesh/progress.hpp>
#include <wm3d/simplify/simplify.hpp>
#include <wm3d/sphere/icosphere.hpp>

#include "pipeline/defaults.hpp"
#include "pipeline/sequences.hpp"

namespace wm3d::pipeline {

/// How the suspect's pose is found.
enum class Resync {
    none, ///< the canonical frame as the surface's moments give it, axis signs by the third moments
    pca,  ///< the same with all four proper choices of axis signs
};

struct ExaminationOptions {
    std::size_t vertices = default_vertices; ///< to simplify to
    std::vector<unsigned> levels{3, 4, 5, 6}; ///< of the watermarking sphere, each tried
    double rmax = 0.1;
    Resync resync = Resync::pca;
    detect::EvidenceOptions evidence;
};

/// Everything about a suspect that no key is needed for.
class Examination {
public:
    /// \throw GeometryError  if the mesh has no area
    Examination(const TriangleMesh& suspect, ExaminationOptions options, const Progress& progress = {});

    const ExaminationOptions& options() const { return options_; }
    const Frame& frame() const { return frame_; }
    const TriangleMesh& base() const { return base_; } ///< in the canonical frame
    simplify::Stop stop() const { return stop_; }
    const detect::Evidence& evidence() const { return *evidence_; }
    std::size_t poses() const { return turns_.size(); }

    /// Poses times levels times filters, each hypothesis with its linear statistic.
    std::span<const detect::Hypothesis> family() const { return family_; }

    /// Expected score, in standard deviations, of the best filter for a mark of this level whose area-weighted RMS
    /// normal move is `strength` % of the bounding box's diagonal, in pose 0.
    double expected_sigmas(Sequences& sequences, unsigned level, double strength) const;

    /// gamma of eq. (3) that moves this base mesh by `strength` with the mark of this level, in pose 0.
    double gamma(Sequences& sequences, unsigned level, double strength) const;

    /// Radii of the base vertices, in units of the mean radius.
    std::vector<double> radii() const;

    /// B for the base vertices' directions in a pose.
    const sphere::SparseRows& rows(std::size_t pose, unsigned level) const;

private:
    std::size_t level_number(unsigned level) const;
    void make_rows();
    void make_family();

    ExaminationOptions options_;
    Frame frame_;
    double diagonal_ = 0; ///< of the suspect's box, in mean radii
    TriangleMesh base_;
    simplify::Stop stop_ = simplify::Stop::reached;
    std::unique_ptr<detect::Evidence> evidence_;
    std::vector<Mat3> turns_;
    std::vector<sphere::SparseRows> rows_; ///< poses by levels
    std::vector<detect::Hypothesis> family_;
};

} // namespace wm3d::pipeline
