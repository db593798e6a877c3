// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Marks with random keys through the real pipeline: mark, damage, examine, score.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <wm3d/study/roc.hpp>
#include <wm3d/watermark/examination.hpp>
#include <wm3d/watermark/marker.hpp>

namespace wm3d::study {

/// What happens to a marked mesh before it is examined; an empty function is nothing.
using Damage = std::function<TriangleMesh(const TriangleMesh& mesh, std::uint64_t seed)>;

/// What says how large marks are, as the options of `mark` do.
enum class Sizing {
    visibility, ///< the one-sided MSDM2 that they keep to
    strength,   ///< RMS of the move along the surface normals, % of the box's diagonal
};

std::string_view name(Sizing sizing);

/// The marks that `mark` makes when nothing else is said.
struct TrialSetting {
    watermark::Profile profile = watermark::Profile::masked;
    Sizing sizing = Sizing::visibility;
    std::size_t vertices = watermark::default_vertices; ///< of the simplified suspect, and of a base domain
    unsigned level = 5;                                 ///< of the watermarking sphere
    key::PublicParameters parameters;                   ///< what a key admits and verify so tries
    payload::Content content{}; ///< what the marks say besides, which leaves them less to be found by
    Damage damage{};
};

/// One mark.
struct Trial {
    std::size_t number = 0;
    double log10_p = 0;           ///< verify's, family-wise
    double paper_nominal_p = 1;   ///< P_f at which T_rho of eq. (6) is this mark's rho
    double paper_log10_p = 0;     ///< exact, of the same rho over random keys
    double gamma = 0;             ///< of bumps that move as much
    embed::Distortion distortion; ///< % of the box's diagonal, before the damage
    Eigen::VectorXd mark;         ///< per filter: T in the mark's pose and level, less the host's part of it
    Eigen::VectorXd variance;     ///< per filter: variance of T over random keys, less that of the host
};

/// A mesh on which marks are tried. What depends on no key is made once.
class TrialBench {
public:
    /// \param mesh  has to outlive the bench
    /// \throw GeometryError   if the mesh has no area
    /// \throw ParameterError  if the setting's level isn't one of its parameters'
    TrialBench(const TriangleMesh& mesh, TrialSetting setting, const Progress& progress = {});

    /// The same marks under another damage.
    TrialBench(const TrialBench& other, Damage damage, const Progress& progress = {});

    /// The mark of random key `number` of the family `seed`, as large as the setting's sizing says. May be
    /// called from several threads.
    /// \throw watermark::TooVisible  if no mark keeps to the visibility
    watermark::Marked mark(double size, std::uint64_t seed, std::size_t number) const;

    /// Damages and examines that mark. May be called from several threads.
    Trial examine(const watermark::Marked& marked, std::uint64_t seed, std::size_t number) const;

    /// Marks, damages and examines.
    Trial run(double size, std::uint64_t seed, std::size_t number) const;

    const TrialSetting& setting() const { return setting_; }

    /// Vertices in the frame of the marks at which their bumps and the radii of eq. (4) are looked at: those
    /// of the base domain, or of the simplified mesh where the profile has none.
    std::vector<Vec3> base() const;

    /// How many hypotheses verify tries.
    std::size_t hypotheses() const { return hypotheses_; }

    /// Per filter: the statistic of the unmarked mesh after the damage, in the pose and level of the marks.
    const std::vector<detect::LinearStatistic>& host() const { return host_; }

private:
    void damage_host(const Progress& progress);
    watermark::Examination examination(const TriangleMesh& suspect, const Progress& progress = {}) const;
    std::size_t true_pose(const watermark::Examination& suspect) const;

    const TriangleMesh& mesh_;
    TrialSetting setting_;
    std::shared_ptr<const watermark::Marker> marker_;
    std::vector<Vec3> simplified_; ///< the unharmed mesh's base vertices in the frame of the marks
    std::size_t hypotheses_ = 0;
    std::vector<detect::LinearStatistic> unharmed_; ///< as `host_`, before the damage
    std::vector<detect::LinearStatistic> host_;
};

/// Called with every finished trial, from one thread at a time.
using TrialSink = std::function<void(const Trial&)>;

/// Runs the trials whose numbers are given, on all cores; the result is in the order of `numbers`.
std::vector<Trial> run_trials(const TrialBench& bench, double size, std::uint64_t seed,
                              const std::vector<std::size_t>& numbers, const TrialSink& sink = {},
                              const Progress& progress = {});

/// Misses counted at each P_f.
MeasuredCurve measured_roc(RocKind kind, const std::vector<Trial>& trials, const TrialBench& bench,
                           double size, std::span<const double> pf);

} // namespace wm3d::study
