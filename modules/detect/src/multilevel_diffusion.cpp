// SPDX-License-Identifier: GPL-3.0-or-later
#include "multilevel_diffusion.hpp"

#include <algorithm>

#include <Eigen/Core>

#include <wm3d/core/parallel.hpp>

namespace wm3d::detect {

namespace {

constexpr float damping = 0.75F; ///< of Jacobi's steps
constexpr int last_steps = 8;    ///< of them on the last level

template<int K>
using Several = Eigen::Array<float, K, 1>;

template<int K>
using Sums = Eigen::Array<double, K, 1>;

/// Sums of `term` over all numbers below `count`, in a fixed order.
template<int K, typename Term>
Sums<K> sums_over(std::size_t count, Term&& term) {
    return parallel_sum(count, level_block, Sums<K>(Sums<K>::Zero()),
                        [&](std::size_t begin, std::size_t end) {
                            Sums<K> part = Sums<K>::Zero();
                            for (std::size_t i = begin; i < end; ++i)
                                part += term(i);
                            return part;
                        });
}

template<typename Do>
void for_each_row(std::size_t count, Do&& act) {
    parallel_blocks(count, level_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            act(i);
    });
}

/// M + tL of a level, for K vectors.
template<int K>
struct System {
    using Rows = std::vector<Several<K>>;
    const DiffusionLevel& level;
    float t;

    std::size_t size() const { return level.mass.size(); }

    float diagonal(std::size_t i) const { return level.mass[i] + t * level.laplacian.diagonal[i]; }

    /// Row i of the product with x.
    Several<K> times(std::size_t i, const Rows& x) const {
        Several<K> beside = Several<K>::Zero();
        for (Index e = level.laplacian.start[i]; e < level.laplacian.start[i + 1]; ++e)
            beside += level.laplacian.value[e] * x[level.laplacian.column[e]];
        return diagonal(i) * x[i] + t * beside;
    }

    /// A step of Jacobi's from 0.
    Several<K> first_step(std::size_t i, const Several<K>& right) const {
        return (damping / diagonal(i)) * right;
    }

    /// A step further; right . x after it.
    Sums<K> step(const Rows& right, Rows& x, Rows& scratch) const {
        const Sums<K> product = sums_over<K>(size(), [&](std::size_t i) -> Sums<K> {
            scratch[i] = x[i] + first_step(i, right[i] - times(i, x));
            return right[i].template cast<double>() * scratch[i].template cast<double>();
        });
        x.swap(scratch);
        return product;
    }

    void residual(const Rows& right, const Rows& x, Rows& result) const {
        for_each_row(size(), [&](std::size_t i) { result[i] = right[i] - times(i, x); });
    }

    /// The sum over the members of an aggregate.
    Several<K> sum_of(std::size_t aggregate, const Rows& x) const {
        Several<K> sum = Several<K>::Zero();
        for (const Index i : level.members.of(aggregate))
            sum += x[i];
        return sum;
    }

    void add_coarse(const Rows& coarse, Rows& x) const {
        for_each_row(coarse.size(), [&](std::size_t p) {
            for (const Index i : level.members.of(p))
                x[i] += coarse[p];
        });
    }
};

template<int K>
struct Scratch {
    std::vector<Several<K>> right, solution, other;

    explicit Scratch(std::size_t rows) : right(rows), solution(rows), other(rows) {}
};

/// From the first step in `solution` to an approximate solution of `right` at a level and below it; right . solution.
template<int K>
Sums<K> cycle(const std::vector<DiffusionLevel>& levels, float t, std::size_t depth,
              std::vector<Scratch<K>>& at) {
    const System<K> system{levels[depth], t};
    Scratch<K>& here = at[depth];
    if (depth + 1 < levels.size()) {
        const System<K> coarser{levels[depth + 1], t};
        Scratch<K>& below = at[depth + 1];
        system.residual(here.right, here.solution, here.other);
        for_each_row(coarser.size(), [&](std::size_t p) {
            below.right[p] = system.sum_of(p, here.other);
            below.solution[p] = coarser.first_step(p, below.right[p]);
        });
        cycle(levels, t, depth + 1, at);
        system.add_coarse(below.solution, here.solution);
    } else {
        for (int n = 2; n < last_steps; ++n)
            system.step(here.right, here.solution, here.other);
    }
    return system.step(here.right, here.solution, here.other);
}

/// K vectors that are solved for together.
template<int K>
class JointSolution {
public:
    JointSolution(const std::vector<DiffusionLevel>& levels, double t, std::span<std::vector<double>> x)
        : levels_(levels), finest_{levels.front(), static_cast<float>(t)}, t_(t), x_(x),
          p_(levels.front().mass.size(), Several<K>::Zero()) {
        for (const DiffusionLevel& level : levels)
            scratch_.emplace_back(level.mass.size());
    }

    int solve(double tolerance, int most) {
        const Sums<K> enough = tolerance * tolerance * start();
        Sums<K> before = Sums<K>::Zero();
        for (int steps = 1;; ++steps) {
            const Sums<K> rz = cycle(levels_, finest_.t, 0, scratch_);
            if (!(rz > enough).any() || steps > most)
                return steps;
            turn((before > 0).select(rz / before, 0.0));
            const Sums<K> pq = apply();
            advance((pq > 0).select(rz / pq, 0.0));
            before = rz;
        }
    }

private:
    std::size_t count() const { return p_.size(); }
    double mass(std::size_t i) const { return static_cast<double>(levels_.front().mass[i]); }

    Sums<K> given(std::size_t i) const {
        Sums<K> row;
        for (std::size_t k = 0; k < K; ++k)
            row[static_cast<Eigen::Index>(k)] = x_[k][i];
        return row;
    }

    /// Row i of L x, in double.
    template<typename Rows>
    Sums<K> flow(std::size_t i, Rows&& x) const {
        const SymmetricRowsOf<float>& laplacian = levels_.front().laplacian;
        Sums<K> sum = static_cast<double>(laplacian.diagonal[i]) * x(i);
        for (Index e = laplacian.start[i]; e < laplacian.start[i + 1]; ++e)
            sum += static_cast<double>(laplacian.value[e]) * x(laplacian.column[e]);
        return sum;
    }

    /// And where the next cycle begins.
    void set_residual(std::size_t i, const Sums<K>& residual) {
        scratch_.front().right[i] = residual.template cast<float>();
        scratch_.front().solution[i] = finest_.first_step(i, scratch_.front().right[i]);
    }

    /// Begins with f itself where that is smooth, and with 0 where it isn't; f . M f.
    Sums<K> start() {
        const Sums<K> size =
            sums_over<K>(count(), [&](std::size_t i) -> Sums<K> { return mass(i) * given(i).square(); });
        const Sums<K> right =
            sums_over<K>(count(), [&](std::size_t i) -> Sums<K> { return (mass(i) * given(i)).square(); });
        const Sums<K> flowing = sums_over<K>(count(), [&](std::size_t i) -> Sums<K> {
            const Sums<K> residual = -t_ * flow(i, [&](std::size_t j) { return given(j); });
            set_residual(i, residual);
            return residual.square();
        });
        const auto smooth = (flowing < right).eval();
        if (smooth.all())
            return size;
        for_each_row(count(), [&](std::size_t i) {
            const Sums<K> residual = scratch_.front().right[i].template cast<double>();
            set_residual(i, smooth.select(residual, mass(i) * given(i)));
        });
        for (std::size_t k = 0; k < K; ++k)
            if (!smooth[static_cast<Eigen::Index>(k)])
                std::ranges::fill(x_[k], 0.0);
        return size;
    }

    void turn(const Sums<K>& beta) {
        const std::vector<Several<K>>& z = scratch_.front().solution;
        const Several<K> factor = beta.template cast<float>();
        for_each_row(count(), [&](std::size_t i) { p_[i] = z[i] + factor * p_[i]; });
    }

    /// q = (M + tL) p, which lies where nothing is between cycles; p . q.
    Sums<K> apply() {
        std::vector<Several<K>>& q = scratch_.front().other;
        return sums_over<K>(count(), [&](std::size_t i) -> Sums<K> {
            const auto p = [&](std::size_t j) { return p_[j].template cast<double>(); };
            const Sums<K> row = mass(i) * p(i) + t_ * flow(i, p);
            q[i] = row.template cast<float>();
            return row * p(i);
        });
    }

    void advance(const Sums<K>& alpha) {
        const std::vector<Several<K>>& r = scratch_.front().right;
        const std::vector<Several<K>>& q = scratch_.front().other;
        for_each_row(count(), [&](std::size_t i) {
            for (std::size_t k = 0; k < K; ++k) {
                const auto at = static_cast<Eigen::Index>(k);
                x_[k][i] += alpha[at] * static_cast<double>(p_[i][at]);
            }
            set_residual(i, r[i].template cast<double>() - alpha * q[i].template cast<double>());
        });
    }

    const std::vector<DiffusionLevel>& levels_;
    System<K> finest_;
    double t_;
    std::span<std::vector<double>> x_;
    std::vector<Several<K>> p_;
    std::vector<Scratch<K>> scratch_;
};

template<int K>
int solve_jointly(const std::vector<DiffusionLevel>& levels, double t, std::span<std::vector<double>> x,
                  double tolerance, int most) {
    return JointSolution<K>(levels, t, x).solve(tolerance, most);
}

} // namespace

MultilevelDiffusion::MultilevelDiffusion(const TriangleMesh& mesh, std::span<const double> mass)
    : unit_(sums_over<1>(mass.size(), [&](std::size_t i) { return Sums<1>(mass[i]); })[0] /
            static_cast<double>(mass.size())),
      levels_(diffusion_levels(mesh, mass, unit_)) {}

int MultilevelDiffusion::diffuse(double t, std::span<std::vector<double>> vectors, double tolerance,
                                 int most) const {
    constexpr std::size_t together = 3;
    int steps = 0;
    for (std::size_t first = 0; first < vectors.size(); first += together) {
        const std::span some = vectors.subspan(first, std::min(together, vectors.size() - first));
        if (some.size() == 3)
            steps += solve_jointly<3>(levels_, t / unit_, some, tolerance, most);
        else if (some.size() == 2)
            steps += solve_jointly<2>(levels_, t / unit_, some, tolerance, most);
        else
            steps += solve_jointly<1>(levels_, t / unit_, some, tolerance, most);
    }
    return steps;
}

} // namespace wm3d::detect
