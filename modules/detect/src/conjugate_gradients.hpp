// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Conjugate gradients for systems that know how to multiply, whether or not there is a matrix.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace wm3d::detect {

/// K vectors, entry by entry: one pass over the matrix serves all of them.
template<std::size_t K>
using Together = std::vector<std::array<double, K>>;

/// Solves A x = y for K right-hand sides at once, with the diagonal as preconditioner; `x` holds the first guess and
/// receives the solution. Ends when every residual is at most `tolerance` times its right-hand side, or after
/// `most` steps. One thread, always the same order.
/// \param a  symmetric and positive definite: a.diagonal(i), and a.times(x, y), which makes y = A x and returns x . y
template<typename System, std::size_t K>
void solve(const System& a, const Together<K>& y, Together<K>& x, double tolerance, int most) {
    const std::size_t n = y.size();
    Together<K> r(n), p(n), q(n);
    std::vector<double> scale(n);
    std::array<double, K> limit{}, left{}, rz{};
    const bool from_zero = std::ranges::all_of(
        x, [](const std::array<double, K>& row) { return row == std::array<double, K>{}; });
    if (!from_zero) // else q is A x as it is made
        a.times(x, q);
    for (std::size_t i = 0; i < n; ++i) {
        scale[i] = 1 / a.diagonal(i);
        for (std::size_t k = 0; k < K; ++k) {
            r[i][k] = y[i][k] - q[i][k];
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
        const std::array<double, K> pq = a.times(p, q);
        std::array<double, K> alpha{}, beta{}, next{};
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
