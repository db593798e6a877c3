// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/masking/budget.hpp>

#include <algorithm>
#include <cmath>

namespace wm3d::masking {

namespace {

/// MSDM2 over strength in logarithms: where nothing was measured yet, and the range that is believed.
constexpr double usual_slope = 0.7, least_slope = 0.2, most_slope = 1.5;

/// Below it MSDM2 is the rounding of its own arithmetic.
constexpr double nothing = 1e-9;

metrics::Msdm2Options sampled(std::size_t most_windows) {
    metrics::Msdm2Options options;
    options.most_windows = most_windows;
    return options;
}

} // namespace

Budget::Budget(const TriangleMesh& mesh, const BudgetOptions& options)
    : mesh_(mesh), options_(options), tree_(mesh), msdm2_(tree_, sampled(options.most_windows)) {}

double Budget::visible(const std::vector<Vec3>& positions) const {
    const TriangleMesh marked{positions, mesh_.triangles};
    return metrics::msdm2_mean(marked, msdm2_.field(marked));
}

double Budget::estimate(const std::vector<Vec3>& positions) const {
    return msdm2_.distance({positions, mesh_.triangles});
}

Fit Budget::fit(const MarkOfStrength& mark, double budget, double guess) const {
    const double aim = options_.aim * budget;
    Fit best, previous;
    double strength = guess, slope = usual_slope, too_weak = 0, too_strong = 0;
    for (std::size_t k = 1; k <= options_.most_evaluations && std::isfinite(strength); ++k) {
        const Fit tried{strength, estimate(mark(strength)), k, false};
        if (tried.msdm2 <= budget && tried.msdm2 >= best.msdm2)
            best = tried;
        best.evaluations = k;
        best.reached = std::abs(best.msdm2 - aim) <= options_.tolerance * budget;
        if (best.reached || !(tried.msdm2 > nothing))
            break;
        (tried.msdm2 < aim ? too_weak : too_strong) = strength;
        if (k > 1 && tried.strength != previous.strength) {
            const double measured =
                std::log(tried.msdm2 / previous.msdm2) / std::log(tried.strength / previous.strength);
            slope = std::isfinite(measured) ? std::clamp(measured, least_slope, most_slope) : usual_slope;
        }
        previous = tried;
        strength *= std::pow(aim / tried.msdm2, 1 / slope);
        if (too_weak > 0 && too_strong > 0 && !(strength > too_weak && strength < too_strong))
            strength = std::sqrt(too_weak * too_strong);
    }
    if (mesh_.positions.size() > options_.most_windows && best.strength > 0)
        confirm(best, mark, budget);
    return best;
}

/// A share of the windows may have told a little less than all of them.
void Budget::confirm(Fit& fit, const MarkOfStrength& mark, double budget) const {
    constexpr int most_corrections = 3;
    for (int k = 0;; ++k) {
        fit.msdm2 = visible(mark(fit.strength));
        ++fit.evaluations;
        if (fit.msdm2 <= budget || k == most_corrections)
            break;
        fit.strength *= std::pow(options_.aim * budget / fit.msdm2, 1 / usual_slope);
    }
    fit.reached = fit.msdm2 <= budget;
}

void Budget::equalize(Carriers& carriers, const MarkOfStrength& trial, double budget, double guess) const {
    constexpr int most_trials = 3;
    constexpr double near = 0.25; // of the budget: what is seen where hardly changes over that
    double strength = guess;
    for (int k = 1;; ++k) {
        const TriangleMesh marked{trial(strength), mesh_.triangles};
        const std::vector<double> seen = msdm2_.field(marked);
        const double msdm2 = metrics::msdm2_mean(marked, seen);
        if (!(msdm2 > nothing))
            return;
        if (k == most_trials || std::abs(msdm2 / budget - 1) <= near)
            return carriers.equalize(seen, msdm2);
        strength *= std::pow(budget / msdm2, 1 / usual_slope);
    }
}

} // namespace wm3d::masking
