// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Curves of P_m over P_f, predicted and measured.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace wm3d::study {

/// Whose curve it is.
enum class RocKind {
    paper,      ///< eq. (5): the paper's detector in the paper's model
    paper_true, ///< the paper's detector at thresholds that truly have P_f on this mesh
    whitened,   ///< the deciding detector
};

std::string_view name(RocKind kind);

struct RocPoint {
    double pf = 0;
    double pm = 0; ///< may underflow; then its logarithm still says it
    double log10_pm = 0;
    std::optional<double> threshold{};     ///< T_rho, of the paper's detector
    std::optional<double> log10_true_pf{}; ///< what P_f that threshold truly has on this mesh
};

struct RocCurve {
    RocKind kind = RocKind::paper;
    double gamma = 0;         ///< of eq. (3), or of bumps that move as much
    std::size_t vertices = 0; ///< of the base domain, or of the simplified mesh
    /// Of a curve that belongs to a mesh: mean RMS move of the marks, % of the box's diagonal, or what was
    /// asked for.
    std::optional<double> strength{};
    std::optional<double> visibility{}; ///< that was asked for
    std::vector<RocPoint> points;
};

/// A share that was counted, with its Clopper-Pearson interval.
struct MeasuredPoint {
    double pf = 0;
    std::size_t missed = 0;
    double pm = 0, low = 0, high = 1;
};

struct MeasuredCurve {
    RocKind kind = RocKind::whitened;
    double gamma = 0; ///< mean over the trials
    std::size_t vertices = 0;
    double strength = 0;                ///< as RocCurve's
    std::optional<double> visibility{}; ///< as RocCurve's
    std::size_t trials = 0;
    std::vector<MeasuredPoint> points;
};

/// Confidence of every interval.
inline constexpr double roc_confidence = 0.95;

/// The Clopper-Pearson interval: probabilities at which so many misses, or more, and so many, or fewer, are
/// no rarer than (1 - confidence) / 2.
/// \pre  missed <= trials and trials > 0
MeasuredPoint measured_point(double pf, std::size_t missed, std::size_t trials,
                             double confidence = roc_confidence);

} // namespace wm3d::study
