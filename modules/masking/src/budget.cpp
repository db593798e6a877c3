// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/masking/budget.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wm3d::masking {

namespace {

/// MSDM2 over strength in logarithms: where nothing was measured yet, and the range that is believed.
constexpr double usual_slope = 0.7, least_slope = 0.2, most_slope = 1.5;

/// Below it MSDM2 is the rounding of its own arithmetic.
constexpr double nothing = 1e-9;

/// Positions of a mark, but where vertices are to stay; `still` may be empty.
std::vector<Vec3> held(std::vector<Vec3> positions, const std::vector<Vec3>& original,
                       const std::vector<char>& still) {
    for (std::size_t i = 0; i < still.size(); ++i)
        if (still[i])
            positions[i] = original[i];
    return positions;
}

/// Marks the vertices that are seen more than `limit`, and their neighbours, whose moves are seen there too.
void hold_around(std::vector<char>& still, const TriangleMesh& mesh, const std::vector<double>& seen,
                 double limit) {
    for (const Triangle& t : mesh.triangles)
        if (std::ranges::any_of(t, [&](Index v) { return seen[v] > limit; }))
            for (Index v : t)
                still[v] = 1;
}

} // namespace

Budget::Budget(const TriangleMesh& mesh, const BudgetOptions& options)
    : mesh_(mesh), options_(options), tree_(mesh), msdm2_(tree_) {}

/// Windows at vertices of the moved mesh; all of them, and exactly, where they are not more.
metrics::Msdm2Sample Budget::look(const std::vector<Vec3>& positions, std::size_t windows) const {
    const TriangleMesh marked{positions, mesh_.triangles};
    if (positions.size() > windows)
        return msdm2_.sample(marked, windows);
    metrics::Msdm2Sample all;
    all.local = msdm2_.field(marked);
    all.mean = metrics::msdm2_mean(marked, all.local);
    all.vertices.resize(positions.size());
    std::iota(all.vertices.begin(), all.vertices.end(), Index{0});
    return all;
}

std::size_t Budget::final_windows() const {
    return mesh_.positions.size() > options_.most_windows ? options_.windows : options_.most_windows;
}

double Budget::visible(const std::vector<Vec3>& positions) const {
    return look(positions, final_windows()).mean;
}

Fit Budget::fit(const MarkOfStrength& mark, double budget, double guess) const {
    Fit fit;
    fit.strength = guess;
    if (mesh_.positions.size() > options_.rough_windows) {
        constexpr double near = 0.03; // of the budget
        approach(fit, mark, budget, options_.rough_windows, near);
        if (!(fit.strength > 0))
            fit.strength = guess;
    }
    approach(fit, mark, budget, final_windows(), options_.tolerance);
    return fit;
}

/// From the strength of `fit` to the largest one tried whose MSDM2, as so many windows tell it, keeps to the
/// budget.
void Budget::approach(Fit& fit, const MarkOfStrength& mark, double budget, std::size_t windows,
                      double tolerance) const {
    if (mesh_.positions.size() > windows)
        budget *= 1 - options_.sampling_margin;
    const double aim = options_.aim * budget;
    Fit best{0, 0, fit.evaluations, false}, previous;
    double strength = fit.strength, slope = usual_slope, too_weak = 0, too_strong = 0;
    for (std::size_t k = 1; k <= options_.most_evaluations && std::isfinite(strength); ++k) {
        const Fit tried{strength, look(mark(strength), windows).mean, k, false};
        ++fit.evaluations;
        if (tried.msdm2 <= budget && tried.msdm2 >= best.msdm2)
            best = tried;
        best.evaluations = fit.evaluations;
        best.reached = std::abs(best.msdm2 - aim) <= tolerance * budget;
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
    fit = best;
}

/// A strength at which the mark is seen about as much as the budget allows; 0 if it is not seen at all.
double Budget::near_budget(const MarkOfStrength& mark, double budget, double guess) const {
    constexpr int most_looks = 2;
    constexpr double near = 0.25; // of the budget: what is seen where hardly changes over that
    double strength = guess;
    for (int k = 0; k < most_looks; ++k) {
        const double msdm2 = look(mark(strength), options_.rough_windows).mean;
        if (!(msdm2 > nothing))
            return 0;
        if (std::abs(msdm2 / budget - 1) <= near)
            break;
        strength *= std::pow(budget / msdm2, 1 / usual_slope);
    }
    return strength;
}

/// Vertices that have to stay if a mark too weak to be seen is not to be seen: empty, or #V. Empty too where
/// none could move, which would gain nothing.
std::vector<char> Budget::places_of_jumps(const MarkOfStrength& trial, double budget,
                                          double slightest) const {
    constexpr int most_rounds = 8;
    constexpr double tolerable = 0.2; // of the budget, for jumps
    std::vector<char> still(mesh_.positions.size(), 0);
    const std::vector<Vec3> positions = trial(slightest);
    for (int k = 0; k < most_rounds; ++k) {
        const TriangleMesh marked{held(positions, mesh_.positions, still), mesh_.triangles};
        const std::vector<double> seen = msdm2_.field(marked);
        if (metrics::msdm2_mean(marked, seen) <= tolerable * budget)
            break;
        hold_around(still, mesh_, seen, budget / 2);
    }
    const auto count = static_cast<std::size_t>(std::ranges::count(still, 1));
    return count == 0 || count == still.size() ? std::vector<char>() : still;
}

void Budget::equalize(Carriers& carriers, const MarkOfStrength& trial, double budget, double guess) const {
    constexpr double glaring = 0.6, slightest = 1e-3; // seen somewhere; of the guess
    std::vector<char> still;
    const auto mark = [&](double strength) { return held(trial(strength), mesh_.positions, still); };
    double strength = near_budget(mark, budget, guess);
    if (!(strength > 0))
        return;
    metrics::Msdm2Sample seen = look(mark(strength), options_.windows);
    if (mesh_.positions.size() <= options_.most_windows && std::ranges::max(seen.local) > glaring)
        still = places_of_jumps(trial, budget, slightest * guess);
    if (!still.empty()) {
        carriers.silence(still);
        strength = near_budget(mark, budget, guess);
        seen = look(mark(strength), options_.windows);
    }
    if (seen.mean > nothing)
        carriers.equalize(seen.vertices, seen.local, seen.mean);
}

} // namespace wm3d::masking
