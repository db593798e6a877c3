// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Windows of MSDM2: weighted statistics of two curvatures around a vertex.
#pragma once

#include <span>

#include <wm3d/metrics/msdm2.hpp>

#include "curvature.hpp"
#include "outward_walk.hpp"

namespace wm3d::metrics {

/// What a window knows of a point of the distorted mesh.
struct WindowSample {
    Vec3 match = Vec3::Zero(); ///< its closest point of the reference
    PerScale c{};              ///< C
    PerScale c_hat{};          ///< C^
};

/// Which vertices stand for all.
struct Thinning {
    std::size_t stride = 1;     ///< one in so many does
    std::span<const char> kept; ///< whether each does, #V; empty where all do

    bool keeps(Index vertex) const { return kept.empty() || kept[vertex] != 0; }
};

/// Local distances at vertices of one mesh.
class Msdm2Windows {
public:
    /// `samples` are those of the vertices, #V, and `radii` the windows' in units of the mesh. All must
    /// outlive the object.
    Msdm2Windows(const TriangleMesh& mesh, const EdgeGraph& graph, const std::vector<WindowSample>& samples,
                 const PerScale& radii, const Msdm2Options& options, const Thinning& thinning = {});

    double local_distance(Index vertex);

private:
    /// Sums of one window, of curvatures less those of its centre, so that nothing cancels.
    struct Sums {
        double w = 0, wc = 0, wcc = 0;                                            ///< under w
        double w_hat = 0, wc_hat = 0, wcc_hat = 0, cross = 0, wc_under_w_hat = 0; ///< under w^

        void add(double weight, double weight_hat, double c, double c_hat);
    };

    void add_vertex(const WindowSample& centre, const OutwardWalk::Reached& reached);
    void add_crossings(const WindowSample& centre, std::size_t scale);
    void add_crossing(const WindowSample& centre, const OutwardWalk::Reached& start,
                      const OutwardWalk::Step& step, std::size_t scale);
    double distance_of(const Sums& sums, double c, double c_hat) const;

    const std::vector<WindowSample>& samples_;
    const PerScale& radii_;
    const Msdm2Options& options_;
    Thinning thinning_;
    double largest_;
    PerScale decay_{};         ///< 1 / (2 deviation^2)
    PerScale weight_at_rim_{}; ///< w at distance h
    OutwardWalk walk_;
    std::vector<Index> crossing_; ///< the walk's steps that leave a sphere, and room for more
    std::array<Sums, std::tuple_size_v<PerScale>> sums_;
};

} // namespace wm3d::metrics
