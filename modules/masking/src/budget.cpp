// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/masking/budget.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace wm3d::masking {

namespace {

/// MSDM2 over strength in logarithms: where nothing was measured yet, and the range that is believed.
constexpr double usual_slope = 1, least_slope = 0.2, most_slope = 1.5;

/// Strengths that differ by less are the same: between them MSDM2 may jump, but it doesn't grow.
constexpr double same_strength = 1e-3;

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

/// What a sample's mean becomes when the mask does.
double reweighed(const metrics::Msdm2Sample& seen, std::span<const double> before,
                 std::span<const double> now) {
    double sum = 0;
    for (std::size_t i = 0; i < seen.local.size(); ++i) {
        const Index v = seen.vertices[i];
        const double ratio = before[v] > 0 ? now[v] / before[v] : 1;
        sum += std::pow(seen.local[i] * std::pow(ratio, usual_slope), 3);
    }
    return std::cbrt(sum / static_cast<double>(seen.local.size()));
}

/// How few windows decide what is seen: the standard error of Minkowski's mean, of the mean, over as many windows
/// as the mesh has vertices if they were drawn at random.
double fewness(const metrics::Msdm2Sample& seen, std::size_t vertices) {
    double cubes = 0, squares = 0;
    for (double x : seen.local) {
        cubes += x * x * x;
        squares += std::pow(x, 6);
    }
    const double part = static_cast<double>(seen.local.size()) / static_cast<double>(vertices);
    return cubes > 0 ? std::sqrt(part * squares) / cubes / 3 : 0;
}

/// Whether a mark seen so tells about one that is seen as the budget allows.
bool is_near(double seen, double budget) {
    constexpr double near = 0.25; // of the budget: what is seen where hardly changes over that
    return std::abs(seen / budget - 1) <= near;
}

} // namespace

Budget::Budget(const TriangleMesh& mesh, const BudgetOptions& options) : mesh_(mesh), options_(options) {
    if (mesh.positions.size() > std::max(options.most_whole, options.most_jumpy)) {
        patches_.emplace(mesh);
    } else {
        tree_.emplace(mesh, metrics::SurfaceTree::Made::at_need); // MSDM2 of a mark asks it for little
        msdm2_.emplace(*tree_);
        msdm2_->get_ready_for_moves();
    }
}

/// Windows at vertices of the moved mesh, all of them where they are not more.
metrics::Msdm2Sample Budget::look(const std::vector<Vec3>& positions, std::size_t windows) const {
    return patches_ ? patches_->sample(positions, windows)
                    : msdm2_->sample({positions, mesh_.triangles}, windows);
}

/// The same from fewer vertices of each window of a dense mesh, which tells some hundredths more.
metrics::Msdm2Sample Budget::glance(const std::vector<Vec3>& positions, std::size_t windows) const {
    return patches_ ? patches_->sample(positions, windows, options_.glance_vertices)
                    : look(positions, windows);
}

/// Windows at some vertices.
metrics::Msdm2Sample Budget::look_at(std::vector<Vec3> positions, std::vector<Index> vertices) const {
    return patches_ ? patches_->at(positions, std::move(vertices))
                    : msdm2_->at({std::move(positions), mesh_.triangles}, std::move(vertices));
}

/// What is seen of small meshes, whose moves can be large beside the box that MSDM2's unit of length follows.
double Budget::exactly(const std::vector<Vec3>& positions) const {
    return msdm2_->distance({positions, mesh_.triangles});
}

/// As many windows as tell the mean: all of a small mesh, and of a large one where few of them decide.
metrics::Msdm2Sample Budget::look_closely(const std::vector<Vec3>& positions) const {
    const std::size_t vertices = mesh_.positions.size();
    if (vertices <= options_.most_windows)
        return look(positions, vertices);
    metrics::Msdm2Sample seen = look(positions, options_.windows);
    return decided_by_few(seen) ? look(positions, vertices) : seen;
}

bool Budget::decided_by_few(const metrics::Msdm2Sample& seen) const {
    return mesh_.positions.size() <= options_.most_jumpy &&
           fewness(seen, mesh_.positions.size()) > options_.few;
}

double Budget::visible(const std::vector<Vec3>& positions) const {
    if (mesh_.positions.size() <= options_.rough_windows)
        return exactly(positions);
    return patches_ ? visible_dense(positions) : look_closely(positions).mean;
}

double Budget::followed(const std::vector<Vec3>& positions, const WeightyWindows& from) const {
    return from.mean(look_at(positions, from.vertices()).local);
}

double Budget::rescaled(double strength, double seen, double budget) {
    return strength * std::pow(budget / seen, 1 / usual_slope);
}

Fit Budget::fit(const MarkOfStrength& mark, double budget, double guess) const {
    if (mesh_.positions.size() <= options_.rough_windows)
        return fit_all(mark, budget, guess);
    constexpr double near = 0.03; // of the budget
    const auto roughly = [&](double strength) { return glance(mark(strength), options_.rough_windows).mean; };
    const Fit fit = approach(roughly, {guess}, budget, near);
    return looked_at(mark, fit_all(mark, budget, fit.strength > 0 ? fit.strength : guess), budget);
}

Fit Budget::fit_near(const MarkOfStrength& mark, double budget, double guess) const {
    const Fit all = fit_all(mark, budget, guess);
    if (!all.by_few)
        return all;
    std::vector<char> still = glaring_places(mark(all.strength), options_.glaring * budget);
    const auto calm = [&](double strength) { return held(mark(strength), mesh_.positions, still); };
    Fit fit = fit_all(calm, budget, all.strength);
    if (!(fit.strength > all.strength))
        return all;
    fit.still = std::move(still);
    return fit;
}

Fit Budget::looked_at(const MarkOfStrength& mark, Fit fit, double budget) const {
    if (!fit.foretold)
        return fit;
    const auto seen = [&](double strength) { return followed(mark(strength), *fit.weighty); };
    Fit seen_fit = approach(seen, {fit.strength, 0, fit.evaluations}, aimed_at(budget), options_.tolerance);
    seen_fit.weighty = std::move(fit.weighty);
    return seen_fit;
}

/// What is left of a budget where not all windows are opened.
double Budget::aimed_at(double budget) const {
    return mesh_.positions.size() > options_.most_windows ? budget * (1 - options_.sampling_margin) : budget;
}

/// A strength for the mark of all vertices.
Fit Budget::fit_all(const MarkOfStrength& mark, double budget, double guess) const {
    if (mesh_.positions.size() <= options_.rough_windows)
        return approach([&](double strength) { return exactly(mark(strength)); }, {guess}, budget,
                        options_.tolerance);
    budget = aimed_at(budget);
    if (patches_)
        return fit_dense(mark, budget, guess);
    return approach_from_full_look(mark, {guess}, budget);
}

/// Looks through all windows once, and at the weightiest of them to come from there to the budget; again
/// where that is far, or where few windows decide, so that what they became has to be seen. Where the budget is as near
/// as that MSDM2 can be taken to grow as the strength does, the strength is foretold.
Fit Budget::approach_from_full_look(const MarkOfStrength& mark, Fit fit, double budget) const {
    for (std::size_t k = 0; k < options_.most_evaluations; ++k) {
        const metrics::Msdm2Sample all = look_closely(mark(fit.strength));
        Fit full{fit.strength, all.mean, fit.evaluations + 1};
        if (!(all.mean > nothing))
            return {0, 0, full.evaluations};
        full.by_few = decided_by_few(all);
        const double off = std::abs(all.mean - options_.aim * budget);
        full.reached = all.mean <= budget && (fit.reached || off <= options_.tolerance * budget);
        if (full.by_few && full.reached)
            return full;
        const WeightyWindows weighty(all, full.by_few ? options_.rough_windows : options_.following_windows);
        if (!full.by_few && !full.reached && off <= options_.foreseeable * budget) {
            const double aim = options_.aim * budget;
            return {.strength = rescaled(full.strength, all.mean, aim),
                    .msdm2 = aim,
                    .evaluations = full.evaluations,
                    .reached = true,
                    .weighty = weighty,
                    .foretold = true};
        }
        const auto seen = [&](double strength) { return followed(mark(strength), weighty); };
        fit = approach(seen, full, budget, options_.tolerance);
        fit.by_few = full.by_few;
        fit.weighty = weighty;
        const double change = std::abs(std::log(fit.strength / full.strength));
        if (full.by_few && full.msdm2 <= budget && change <= same_strength)
            return full;
        const bool near_enough = !fit.by_few && change <= near_strength;
        if (near_enough || !(fit.strength > 0))
            break;
    }
    return fit;
}

/// From a strength, seen as `tried.msdm2` if that is known, to the largest one tried that keeps to the budget.
Fit Budget::approach(const SeenOfStrength& seen, Fit tried, double budget, double tolerance) const {
    const double aim = options_.aim * budget;
    Fit best;
    double slope = usual_slope, too_weak = 0, too_strong = 0;
    double reach = 1; // grows where what is seen hardly changes over a wide range of strengths
    if (!(tried.msdm2 > 0))
        tried = {tried.strength, seen(tried.strength), tried.evaluations + 1};
    for (std::size_t k = 1;; ++k) {
        if (tried.msdm2 <= budget && tried.msdm2 >= best.msdm2)
            best = tried;
        best.evaluations = tried.evaluations;
        best.reached = std::abs(best.msdm2 - aim) <= tolerance * budget;
        if (best.reached || !(tried.msdm2 > nothing) || k == options_.most_evaluations)
            return best;
        (tried.msdm2 < aim ? too_weak : too_strong) = tried.strength;
        const bool between = too_weak > 0 && too_strong > 0;
        if (between && too_strong < (1 + same_strength) * too_weak)
            return best;
        double next = tried.strength * std::pow(aim / tried.msdm2, (between ? 1 : reach) / slope);
        if (between && !(next > too_weak && next < too_strong))
            next = std::sqrt(too_weak * too_strong);
        if (!std::isfinite(next) || next == tried.strength)
            return best;
        const Fit previous = tried;
        tried = {next, seen(next), tried.evaluations + 1};
        const auto error = [&](const Fit& at) { return std::abs(std::log(aim / at.msdm2)); };
        reach = error(tried) > error(previous) / 2 ? 2 * reach : 1;
        const double measured =
            std::log(tried.msdm2 / previous.msdm2) / std::log(tried.strength / previous.strength);
        slope = std::isfinite(measured) ? std::clamp(measured, least_slope, most_slope) : usual_slope;
    }
}

/// Opens the mask's windows at a strength at which the mark is seen about as much as the budget allows: at the guess
/// if that is one, so that nothing has to come before. The sample's mean is 0 if the mark is not seen at all.
Budget::Trial Budget::trial_look(const MarkOfStrength& mark, double budget, double guess) const {
    constexpr int most_looks = 2;
    const auto look_at_mask = [&](double strength) {
        return Trial{strength,
                     glance(mark(strength), patches_ ? options_.mask_patch_windows : options_.mask_windows)};
    };
    if (patches_) // that look takes long
        if (const double msdm2 = glance(mark(guess), options_.few_windows).mean;
            msdm2 > nothing && !is_near(msdm2, budget))
            guess = rescaled(guess, msdm2, budget);
    Trial trial = look_at_mask(guess);
    if (!(trial.seen.mean > nothing) || is_near(trial.seen.mean, budget))
        return trial;
    double strength = rescaled(guess, trial.seen.mean, budget);
    for (int k = 0; k < most_looks; ++k) {
        const double msdm2 = glance(mark(strength), options_.rough_windows).mean;
        if (!(msdm2 > nothing) || is_near(msdm2, budget))
            break;
        strength = rescaled(strength, msdm2, budget);
    }
    return look_at_mask(strength);
}

/// Vertices around which a mark is seen by more than `glaring`: #V.
std::vector<char> Budget::glaring_places(const std::vector<Vec3>& positions, double glaring) const {
    std::vector<char> still(mesh_.positions.size(), 0);
    hold_around(still, mesh_, msdm2_->field({positions, mesh_.triangles}), glaring);
    return still;
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
        const std::vector<double> seen = msdm2_->field(marked);
        if (metrics::msdm2_mean(marked, seen) <= tolerable * budget)
            break;
        const std::vector<char> before = still;
        hold_around(still, mesh_, seen, budget / 2);
        if (still == before) // the next round would see the same
            break;
    }
    const auto count = static_cast<std::size_t>(std::ranges::count(still, 1));
    return count == 0 || count == still.size() ? std::vector<char>() : still;
}

double Budget::equalize(Carriers& carriers, const MarkOfStrength& trial, double budget, double guess) const {
    constexpr double jumpy = 0.6, slightest = 1e-3; // seen somewhere; of the guess
    // What a trial mark happens to show at a place is taken for the place's own, so that another shows more there.
    constexpr double of_others = 1.15;
    std::vector<char> still;
    const auto mark = [&](double strength) { return held(trial(strength), mesh_.positions, still); };
    Trial tried = trial_look(mark, budget, guess);
    if (!(tried.seen.mean > nothing))
        return 0;
    if (mesh_.positions.size() <= options_.most_jumpy && std::ranges::max(tried.seen.local) > jumpy)
        still = places_of_jumps(trial, budget, slightest * guess);
    if (!still.empty()) {
        carriers.silence(still);
        tried = trial_look(mark, budget, guess);
        if (!(tried.seen.mean > nothing))
            return 0;
    }
    const std::vector<double> before(carriers.mask().begin(), carriers.mask().end());
    carriers.equalize(tried.seen.vertices, tried.seen.local, tried.seen.mean);
    return rescaled(tried.strength, of_others * reweighed(tried.seen, before, carriers.mask()), budget);
}

} // namespace wm3d::masking
