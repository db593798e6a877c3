// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The system of a diffusion, M + tL, which is never formed.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <wm3d/mesh/types.hpp>

#include "conjugate_gradients.hpp"
#include "symmetric_rows.hpp"

namespace wm3d::detect {

/// Of a row of L: what ends a loop over pairs is seldom a surprise to the processor.
inline constexpr Index entries_at_once = 2;

/// M + tL with a diagonal M.
struct Diffusion {
    std::span<const double> mass;
    const SymmetricRows& laplacian; ///< rows of a multiple of `entries_at_once`
    double t;

    double diagonal(std::size_t i) const { return mass[i] + t * laplacian.diagonal[i]; }

    /// y = (M + tL) x; returns x . y.
    template<std::size_t K>
    std::array<double, K> times(const Together<K>& x, Together<K>& y) const {
        std::array<double, K> product{};
        for (std::size_t i = 0; i < x.size(); ++i) {
            std::array<double, K> beside{};
            for (std::size_t e = laplacian.start[i]; e < laplacian.start[i + 1]; e += entries_at_once)
                for (std::size_t s = e; s < e + entries_at_once; ++s)
                    for (std::size_t k = 0; k < K; ++k)
                        beside[k] += laplacian.value[s] * x[laplacian.column[s]][k];
            for (std::size_t k = 0; k < K; ++k) {
                y[i][k] = diagonal(i) * x[i][k] + t * beside[k];
                product[k] += x[i][k] * y[i][k];
            }
        }
        return product;
    }
};

} // namespace wm3d::detect
