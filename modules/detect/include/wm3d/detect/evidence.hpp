// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The whitened detector: from a suspect's base mesh, before any key is looked at, to linear
/// statistics.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <wm3d/detect/cell_samples.hpp>
#include <wm3d/detect/linear_statistic.hpp>
#include <wm3d/detect/surface_filter.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>
#include <wm3d/sphere/sparse_rows.hpp>

namespace wm3d::detect {

/// One residual of the surface with one weighting: what a diffusion takes away, or the folds at the edges.
struct Filter {
    double t;     ///< time of the diffusion that is taken away, in units of mean radius squared
    double power; ///< the residual counts as (local variance)^-power: 0 plain, 1 as on a host of varying
                  ///< roughness
    double
        variance_t; ///< time of the diffusion that averages the local variance; short where creases are sharp
    /// Time of a low pass that the template of the mark goes through as well: a mark whose carriers were
    /// rounded off has nothing finer, and noise has.
    double template_t = 0;
    /// Normals, areas and the filters' surface are those of a copy that so many umbrella steps of weight 1/2
    /// smoothed: noise and roundings tilt normals more than they move vertices. The residual stays that of
    /// the vertices themselves.
    int calming = 0;
    /// Residuals count by Tukey's biweight of so many typical deviations, and those beyond for nothing: edges
    /// of machined parts stand out of the rest as no mark does. 0: all count as they are.
    double bound = 0;
    /// Above 0: in place of all of the above, the folds at the edges are the residual, where two triangles of
    /// one plane have none. They count by Cauchy's weights of this scale, in units of the mean radius: the mark
    /// tells in folds of about its own size, however many larger ones a machined part has.
    double hinges = 0;
    /// Of hinges: independent moves of the vertices that the folds are whitened against, in units of the mean
    /// radius. A fold of four vertices that each lie off by as much tells the less of any one of them the more
    /// of its neighbours' folds do.
    double noise = 0;
    /// The statistic's coefficients count by the roots of their sizes: where the mark is strong, it is its own
    /// noise, and few places with many or stiff triangles would drown the others.
    bool evened = false;

    static Filter of_hinges(double scale, double noise, bool evened = false) {
        return {0, 0, 0, 0, 0, 0, scale, noise, evened};
    }
};

/// "filter t = 0.0002, power 0.5", or "hinges of 0.001, noise 0.0006".
std::string describe(const Filter& filter);

/// Places in the bank that EvidenceOptions begins with, by where each says most.
inline constexpr std::size_t folds_after_rounding = 0; ///< of machined parts and game models
inline constexpr std::size_t smoothed_scans = 1;
inline constexpr std::size_t folds_under_noise = 2;
inline constexpr std::size_t coarse_coordinates = 3;
inline constexpr std::size_t folds_as_marked = 4;
inline constexpr std::size_t folds_after_simplification = 5; ///< and after a cut
inline constexpr std::size_t folds_of_flats = 6; ///< of machined parts, as they were marked or smoothed

struct EvidenceOptions {
    /// The bank. The best of its statistics decides and all of them are paid for; docs/algorithm.md, section
    /// 7, says how these were chosen.
    std::vector<Filter> filters{Filter::of_hinges(2e-4, 5e-4),   {3e-5, 0.5, 1e-3, 3e-4, 0, 6, 0, 0, true},
                                Filter::of_hinges(2e-3, 8e-3),   {3e-4, 0.5, 1e-3, 3e-4, 3},
                                Filter::of_hinges(1e-3, 6e-4),   Filter::of_hinges(5e-3, 2e-3),
                                Filter::of_hinges(2e-4, 0, true)};
    /// Added to the local variance, as part of its median: no place counts as perfectly smooth.
    double variance_floor = 0.05;
};

/// What a suspect's base mesh says, seen through each filter of the bank. Depends on the suspect alone, so
/// nothing here costs a hypothesis.
class Evidence {
public:
    /// \param base  base mesh in a canonical frame (centred, mean radius 1); rotations don't matter
    explicit Evidence(const TriangleMesh& base, EvidenceOptions options = {});

    /// The same evidence for radial moves about another centre, in the coordinates of the base. Costs next to
    /// nothing.
    Evidence seen_from(const Vec3& centre) const;

    std::size_t filters() const;
    const Filter& filter(std::size_t f) const;

    /// d_i . n_i: the part of a radial move that shows along the surface normal, #base vertices.
    std::span<const double> visibility() const { return visibility_.front(); }

    /// q = diag(d.n) HP^T (a g e), or diag(d.n) S J^T (g r) for folds r = J x, #base vertices: T is the sum of
    /// q_i times the bump in the direction of vertex i, wherever the sphere lies, unless the filter is evened.
    std::vector<double> weights_at(std::size_t f) const;

    /// What the mark of `w`, with an area-weighted root mean square normal move `move` (in units of mean
    /// radius), adds to these if it sits on this very mesh, vertex for vertex.
    std::vector<double> mark_weights_at(std::size_t f, const sphere::SparseRows& rows,
                                        std::span<const double> w, double move) const;

    /// T = sum_j c_j w_j with c = B^T diag(d.n) LP^T HP^T (a g e): a the vertex areas, e the normal residual
    /// n . HP x, g its weights, HP = I - (M + tL)^-1 M, LP the low pass of the template, if it has one. For
    /// hinges c = B^T diag(d.n) S J^T (g r), S = (I + noise^2 J^T g J)^-1. Evened: the roots of these, with
    /// their signs.
    LinearStatistic statistic(std::size_t f, const sphere::SparseRows& rows, double rmax) const;

    /// The same with what is read at a vertex spread over the points around it; `rows` are B for the samples.
    LinearStatistic statistic(std::size_t f, const CellSamples& samples, const sphere::SparseRows& rows,
                              double rmax) const;

    /// gamma of eq. (3) at which the mark of `w` has an area-weighted root mean square normal move `move` (in
    /// units of mean radius); 0 if no gamma does.
    double gamma(const sphere::SparseRows& rows, std::span<const double> w, double move) const;

    /// How T of the sequence w grows with the base vertices' moves, #base vectors, to first order and with
    /// normals, areas and weights held, before it is evened: HP^T (a g HP LP (diag(d.n) B w)) n for a
    /// diffusion. The detector's own template of the mark.
    std::vector<Vec3> gradient(std::size_t f, const sphere::SparseRows& rows,
                               std::span<const double> w) const;

    /// Expected score, in standard deviations of the null distribution, if this very mesh carried the mark of
    /// `w` with an area-weighted root mean square normal move `move` (in units of mean radius). The mark's
    /// own residual widens the null distribution too, which bounds the score however strong the mark.
    double expected_sigmas(std::size_t f, const sphere::SparseRows& rows, std::span<const double> w,
                           double rmax, double move) const;

private:
    struct Core; ///< what doesn't depend on the centre
    Evidence(std::shared_ptr<const Core> core, const Vec3& centre);

    LinearStatistic counted(std::size_t f, std::vector<double> coefficients, double rmax) const;
    std::vector<double> normal_bumps(std::size_t geometry, const sphere::SparseRows& rows,
                                     std::span<const double> w) const;
    std::vector<double> seen(std::size_t geometry, std::span<const double> pulled) const;

    std::shared_ptr<const Core> core_;
    std::vector<std::vector<double>> visibility_; ///< per geometry of the core
};

} // namespace wm3d::detect
