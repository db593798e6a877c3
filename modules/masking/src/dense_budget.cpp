// SPDX-License-Identifier: GPL-3.0-or-later
// The budget of dense meshes, which is kept to by two-phase sampling (J. Neyman, 1938): a glance at many windows, through
// some of their vertices, tells which of them count, and a look at those how much they show.
#include <wm3d/masking/budget.hpp>

#include <cmath>
#include <optional>

namespace wm3d::masking {

namespace {

/// Below it MSDM2 is the rounding of curvatures in single precision.
constexpr double nothing_dense = 1e-6;

} // namespace

/// Which windows count, and about how much is seen: some hundredths more than all vertices show.
metrics::Msdm2Sample Budget::dense_glance(const std::vector<Vec3>& positions) const {
    return patches_->sample(positions, options_.dense_windows, options_.dense_vertices);
}

double Budget::visible_dense(const std::vector<Vec3>& positions) const {
    const metrics::Msdm2Sample seen = dense_glance(positions);
    return seen.mean > nothing_dense ? followed(positions, WeightyWindows(seen, options_.rough_windows))
                                     : seen.mean;
}

/// The windows are chosen anew where the strength turns out to be far from that of the glance.
Fit Budget::fit_dense(const MarkOfStrength& mark, double budget, double guess) const {
    Fit fit{guess};
    for (std::size_t k = 0; k < options_.most_evaluations; ++k) {
        const double glanced_at = fit.strength;
        const metrics::Msdm2Sample glance = dense_glance(mark(glanced_at));
        if (!(glance.mean > nothing_dense))
            return {0, 0, fit.evaluations + 1};
        const WeightyWindows weighty(glance, options_.rough_windows);
        std::optional<WeightyWindows> known;
        const auto seen = [&](double strength) {
            const std::vector<Vec3> positions = mark(strength);
            if (known)
                return followed(positions, *known);
            const metrics::Msdm2Sample now = look_at(positions, weighty.vertices());
            if (now.mean > nothing_dense)
                known = weighty.followed_on(now.local, options_.followed_part);
            return weighty.mean(now.local);
        };
        const double aim = rescaled(glanced_at, glance.mean, options_.aim * budget);
        fit = approach(seen, {aim, 0, fit.evaluations + 1}, budget, options_.tolerance);
        if (!(fit.strength > 0) || std::abs(std::log(fit.strength / glanced_at)) <= near_strength)
            break;
    }
    return fit;
}

} // namespace wm3d::masking
