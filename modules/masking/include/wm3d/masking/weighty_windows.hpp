// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Following what is seen of a mark as it changes, by few windows.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>
#include <wm3d/metrics/msdm2.hpp>

namespace wm3d::masking {

/// Windows of MSDM2 that stand for all, each for an equal share of the sum of cubes of the local distances: what that
/// sum becomes when a mark changes is told by few of them, wherever it comes from.
class WeightyWindows {
public:
    /// \param all  at all vertices, or at so many that they tell the mean
    /// \param shares  > 0; windows are not more
    /// \pre  all.mean > 0
    WeightyWindows(const metrics::Msdm2Sample& all, std::size_t shares);

    /// Where these windows are, ascending.
    const std::vector<Index>& vertices() const { return vertices_; }

    /// Minkowski's mean over all windows where the local distances at `vertices` have become `now`.
    double mean(std::span<const double> now) const;

    /// Some of them, one in `part`, to follow on from where the local distances are `now`.
    /// \pre  part > 0
    WeightyWindows followed_on(std::span<const double> now, std::size_t part) const;

private:
    explicit WeightyWindows(double mean) : mean_(mean) {}

    double mean_;
    std::vector<Index> vertices_;
    std::vector<double> before_, shares_; ///< local distances, and how many shares each stands for
};

} // namespace wm3d::masking
