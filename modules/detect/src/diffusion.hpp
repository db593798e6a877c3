// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  (M + t L) x = y by conjugate gradients, without ever forming the matrix.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <wm3d/mesh/types.hpp>

namespace wm3d::detect {

/// A symmetric matrix by rows: the diagonal, and what stands beside it.
struct SymmetricRows {
    std::vector<double> diagonal; ///< #rows
    std::vector<Index> start;     ///< #rows + 1
    std::vector<Index> column;
    std::vector<double> value;
};

/// K vectors, entry by entry: one pass over the matrix serves all of them.
template<std::size_t K>
using Together = std::vector<std::array<double, K>>;

/// M + tL with a diagonal M.
struct Diffusion {
    std::span<const double> mass;
    const SymmetricRows& laplacian;
    double t;

    double diagonal(std::size_t i) const { return mass[i] + t * laplacian.diagonal[i]; }

    /// Row i times x.
    template<std::size_t K>
    std::array<double, K> row_times(std::size_t i, const Together<K>& x) const {
        std::array<double, K> beside{}, result;
        for (std::size_t e = laplacian.start[i]; e < laplacian.start[i + 1]; ++e)
            for (std::size_t k = 0; k < K; ++k)
                beside[k] += laplacian.value[e] * x[laplacian.column[e]][k];
        for (std::size_t k = 0; k < K; ++k)
            result[k] = diagonal(i) * x[i][k] + t * beside[k];
        return result;
    }
};

/// Solves for K right-hand sides at once, with the diagonal as preconditioner; `x` holds the first guess and
/// receives the solution. Ends when every residual is at most `tolerance` times its right-hand side, or after
/// `most` steps. One thread, always the same order.
template<std::size_t K>
void solve(const Diffusion& a, const Together<K>& y, Together<K>& x, double tolerance, int most) {
    const std::size_t n = y.size();
    Together<K> r(n), p(n), q(n);
    std::vector<double> scale(n);
    std::array<double, K> limit{}, left{}, rz{};
    for (std::size_t i = 0; i < n; ++i) {
        scale[i] = 1 / a.diagonal(i);
        const std::array<double, K> ax = a.row_times(i, x);
        for (std::size_t k = 0; k < K; ++k) {
            r[i][k] = y[i][k] - ax[k];
            p[i][k] = scale[i] * r[i][k];
            limit[k] += y[i][k] * y[i][k];
            left[k] += r[i][k] * r[i][k];
            rz[k] += r[i][k] * p[i][k];
        }
    }
    for (double& l : limit)
        l *= tolerance * tolerance;
    for (int step = 0; step < most; ++step) {
        std::array<bool, K> open{};
        bool any = false;
        for (std::size_t k = 0; k < K; ++k)
            any |= open[k] = left[k] > limit[k];
        if (!any)
            return;
        std::array<double, K> pq{}, alpha{}, beta{}, next{};
        for (std::size_t i = 0; i < n; ++i) {
            q[i] = a.row_times(i, p);
            for (std::size_t k = 0; k < K; ++k)
                pq[k] += p[i][k] * q[i][k];
        }
        for (std::size_t k = 0; k < K; ++k)
            alpha[k] = open[k] ? rz[k] / pq[k] : 0;
        left = {};
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = 0; k < K; ++k) {
                x[i][k] += alpha[k] * p[i][k];
                r[i][k] -= alpha[k] * q[i][k];
                left[k] += r[i][k] * r[i][k];
                next[k] += r[i][k] * (scale[i] * r[i][k]);
            }
        for (std::size_t k = 0; k < K; ++k)
            beta[k] = open[k] ? next[k] / rz[k] : 0;
        rz = next;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = 0; k < K; ++k)
                p[i][k] = scale[i] * r[i][k] + beta[k] * p[i][k];
    }
}

} // namespace wm3d::detect
