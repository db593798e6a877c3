// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Marks with random keys through the real pipeline: mark, damage, examine, score.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include <wm3d/study/roc.hpp>
#include <wm3d/watermark/examination.hpp>
#include <wm3d/watermark/mark.hpp>

namespace wm3d::study {

/// What happens to a marked mesh before it is examined; an empty function is nothing.
using Damage = std::function<TriangleMesh(const TriangleMesh& mesh, std::uint64_t seed)>;

struct TrialSetting {
    std::size_t vertices = watermark::default_vertices; ///< of the base domain and of the simplified suspect
    unsigned level = 5;                                 ///< of the watermarking sphere
    key::PublicParameters parameters;                   ///< what a key admits and verify so tries
    Damage damage;
};

/// One mark.
struct Trial {
    std::size_t number = 0;
    double log10_p = 0;         ///< verify's, family-wise
    double paper_nominal_p = 1; ///< P_f at which T_rho of eq. (6) is this mark's rho
    double paper_log10_p = 0;   ///< exact, of the same rho over random keys
    double gamma = 0;
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

    /// The paper's mark of random key `number` of the family `seed`, of a strength in % of the box's
    /// diagonal. May be called from several threads.
    Trial run(double strength, std::uint64_t seed, std::size_t number) const;

    const TrialSetting& setting() const { return setting_; }
    const watermark::Marker& marker() const { return marker_; }

    /// How many hypotheses verify tries.
    std::size_t hypotheses() const { return hypotheses_; }

    /// Per filter: the statistic of the unmarked mesh after the damage, in the pose and level of the marks.
    const std::vector<detect::LinearStatistic>& host() const { return host_; }

private:
    std::size_t true_pose(const watermark::Examination& suspect) const;

    const TriangleMesh& mesh_;
    TrialSetting setting_;
    watermark::Marker marker_;
    std::size_t hypotheses_ = 0;
    std::vector<detect::LinearStatistic> unharmed_; ///< as `host_`, before the damage
    std::vector<detect::LinearStatistic> host_;
};

/// Called with every finished trial, from one thread at a time.
using TrialSink = std::function<void(const Trial&)>;

/// Runs the trials whose numbers are given, on all cores; the result is in the order of `numbers`.
std::vector<Trial> run_trials(const TrialBench& bench, double strength, std::uint64_t seed,
                              const std::vector<std::size_t>& numbers, const TrialSink& sink = {},
                              const Progress& progress = {});

/// Misses counted at each P_f.
MeasuredCurve measured_roc(RocKind kind, const std::vector<Trial>& trials, std::size_t vertices,
                           double strength, std::span<const double> pf);

} // namespace wm3d::study
