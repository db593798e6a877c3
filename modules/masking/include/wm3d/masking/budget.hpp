// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Keeping to a budget of visibility: how strong a mark may be for an MSDM2.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include <wm3d/masking/carriers.hpp>
#include <wm3d/masking/weighty_windows.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>
#include <wm3d/metrics/msdm2.hpp>
#include <wm3d/metrics/msdm2_patches.hpp>
#include <wm3d/metrics/surface_tree.hpp>

namespace wm3d::masking {

/// Positions of the mesh with a mark of a strength, #V; about linear in the strength.
using MarkOfStrength = std::function<std::vector<Vec3>(double strength)>;

/// A strength that fits.
struct Fit {
    double strength = 0;
    double msdm2 = 0; ///< of a mark of this strength: measured, or followed from one of nearly this strength
    std::size_t evaluations = 0;  ///< of MSDM2
    bool reached = false;         ///< whether `msdm2` lies just below the budget; else no strength came there
    bool by_few = false;          ///< whether few vertices decide `msdm2`
    std::vector<char> still = {}; ///< vertices that are to stay where they are, #V; empty where none are
    std::optional<WeightyWindows> weighty = {}; ///< that tell what becomes of `msdm2`, if few windows do
    bool foretold = false; ///< whether no mark of this strength was looked at: `msdm2` is expected
};

struct BudgetOptions {
    double aim = 0.99;         ///< of the budget, to stay below it
    double tolerance = 0.01;   ///< accepted distance from the aim
    double foreseeable = 0.03; ///< part of the budget over which MSDM2 is taken to grow as the strength does
    std::size_t most_evaluations = 12;
    /// Meshes of more vertices are looked at through about `windows` of them, since those of neighbours overlap,
    /// but where few decide.
    std::size_t most_windows = 20'000;
    std::size_t windows = 14'000; ///< at most, and more than half of that
    double few = 0.0075;          ///< standard error of what is seen from which few windows decide it
    double glaring = 5; ///< times the budget: seen so, a vertex isn't worth what it costs where few spend it
    std::size_t most_jumpy =
        60'000; ///< meshes of more vertices are not looked through for jumps, nor for the few
    std::size_t mask_windows = 14'000; ///< of the trial mark that the mask is weighed by
    std::size_t rough_windows = 500;   ///< to come near the strength
    std::size_t following_windows =
        250; ///< to follow what is seen from a look through all to the budget, but where few decide
    /// Meshes of more vertices, and of more than `most_jumpy`, are looked at in patches: metrics::Msdm2Patches.
    std::size_t most_whole = 200'000;
    std::size_t mask_patch_windows = 9'000; ///< of such a mesh, in place of `mask_windows`
    std::size_t dense_windows = 6'000;      ///< of such a mesh, in a glance that tells which windows count
    std::size_t dense_vertices = 64;        ///< of a window, in that glance
    std::size_t few_windows = 128;          ///< of such a mesh, in a first glance at a trial mark
    std::size_t glance_vertices = 128;      ///< of a window of such a mesh, in other glances
    std::size_t followed_part =
        4; ///< one in so many of the windows that tell what is seen tells how that grows
    double sampling_margin = 0.005; ///< part of the budget that is left where not all are opened
};

/// The one-sided MSDM2 of marks from the mesh they are for.
class Budget {
public:
    /// \param mesh  in the coordinates of its file, on whose axes MSDM2's unit of length depends; has to
    /// outlive the object
    /// \throw GeometryError  if the mesh has no triangle with an area
    explicit Budget(const TriangleMesh& mesh, const BudgetOptions& options = {});

    /// MSDM2 of the moved mesh; on meshes of more vertices than `most_windows` an estimate.
    double visible(const std::vector<Vec3>& positions) const;

    /// The same of a mark that differs little from the one that `from` was made of, unless few windows decide.
    double followed(const std::vector<Vec3>& positions, const WeightyWindows& from) const;

    /// Finds the strength whose mark is seen with MSDM2 `budget`: MSDM2 grows about as a power of the
    /// strength, so that a few evaluations do.
    /// \param guess  strength to begin with, > 0
    Fit fit(const MarkOfStrength& mark, double budget, double guess) const;

    /// The same from a guess that is known to be near, such as follows from `equalize`. Where few vertices spend
    /// the budget, they stay where they are if all others may then move further. The fit may be foretold.
    Fit fit_near(const MarkOfStrength& mark, double budget, double guess) const;

    /// The fit of `fit_near`, looked at if it was foretold, and a strength nearer to the budget where it has to be.
    Fit looked_at(const MarkOfStrength& mark, Fit fit, double budget) const;

    /// About the strength that is seen as `budget` where `strength` is seen as `seen`.
    static double rescaled(double strength, double seen, double budget);

    /// Weighs the carriers' mask by what a trial mark shows: `Carriers::equalize`. Where MSDM2 jumps at the
    /// slightest move, as beside doubled surfaces, nothing may move: `Carriers::silence`. The trial's sequence
    /// is not to be the key's, so that the mask tells nothing of it and the same mask serves any.
    /// \param trial  its positions of a strength
    /// \param guess  strength to begin with, > 0
    /// \return  times which strength, by the mask as it was, the trial is seen about as much as `budget` by the
    ///     mask as it is now; 0 where that is not known
    double equalize(Carriers& carriers, const MarkOfStrength& trial, double budget, double guess) const;

private:
    /// What is seen of a mark of a strength.
    struct Trial {
        double strength = 0;
        metrics::Msdm2Sample seen;
    };
    using SeenOfStrength = std::function<double(double strength)>; ///< MSDM2

    static constexpr double nothing = 1e-9; ///< less is the rounding of MSDM2's own arithmetic
    /// In the logarithm of the strength: windows that were chosen at a strength serve all that are nearer.
    static constexpr double near_strength = 0.35;

    metrics::Msdm2Sample look(const std::vector<Vec3>& positions, std::size_t windows) const;
    metrics::Msdm2Sample glance(const std::vector<Vec3>& positions, std::size_t windows) const;
    metrics::Msdm2Sample dense_glance(const std::vector<Vec3>& positions) const;
    metrics::Msdm2Sample look_at(std::vector<Vec3> positions, std::vector<Index> vertices) const;
    double exactly(const std::vector<Vec3>& positions) const;
    metrics::Msdm2Sample look_closely(const std::vector<Vec3>& positions) const;
    bool decided_by_few(const metrics::Msdm2Sample& seen) const;
    double aimed_at(double budget) const;
    Fit fit_all(const MarkOfStrength& mark, double budget, double guess) const;
    Fit fit_dense(const MarkOfStrength& mark, double budget, double guess) const;
    double visible_dense(const std::vector<Vec3>& positions) const;
    Fit approach_from_full_look(const MarkOfStrength& mark, Fit fit, double budget) const;
    Fit approach(const SeenOfStrength& seen, Fit tried, double budget, double tolerance) const;
    Trial trial_look(const MarkOfStrength& mark, double budget, double guess) const;
    std::vector<char> glaring_places(const std::vector<Vec3>& positions, double glaring) const;
    std::vector<char> places_of_jumps(const MarkOfStrength& trial, double budget, double slightest) const;

    const TriangleMesh& mesh_;
    BudgetOptions options_;
    std::optional<metrics::SurfaceTree> tree_;
    std::optional<metrics::Msdm2> msdm2_;          ///< as a whole
    std::optional<metrics::Msdm2Patches> patches_; ///< or, if it is dense, in patches
};

} // namespace wm3d::masking
