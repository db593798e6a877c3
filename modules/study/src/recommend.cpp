// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/recommend.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include <boost/math/tools/roots.hpp>

namespace wm3d::study {

namespace {

constexpr double tolerance = 0.02; // of the strength
constexpr double smallest_strength = 1e-5, first_guess = 0.01;
constexpr int most_steps = 12;

struct Condition {
    std::string name;
    std::unique_ptr<TrialBench> bench;
};

std::vector<Condition> conditions(const TriangleMesh& mesh, const TrialSetting& setting,
                                  const Requirement& requirement, const Progress& progress) {
    std::vector<Condition> all;
    all.push_back({"none", std::make_unique<TrialBench>(mesh, setting, progress)});
    for (const NamedDamage& damage : requirement.survive) {
        TrialSetting damaged = setting;
        damaged.damage = damage.damage;
        all.push_back({damage.name, std::make_unique<TrialBench>(mesh, std::move(damaged), progress)});
    }
    return all;
}

/// The strength at which this response, scaled, would just meet the requirement.
double needed_strength(const Response& response, const Requirement& requirement) {
    const auto excess = [&](double log_strength) {
        return log10_miss(response, std::exp(log_strength), requirement.pf) - std::log10(requirement.pm);
    };
    const double low = std::log(smallest_strength), high = std::log(2 * largest_strength);
    if (excess(low) <= 0)
        return smallest_strength;
    if (excess(high) > 0)
        return 2 * largest_strength;
    const auto narrow = [](double a, double b) { return b - a <= tolerance / 10; };
    return std::exp(boost::math::tools::bisect(excess, low, high, narrow).second);
}

struct Step {
    Recommendation result; ///< for the strength that was tried
    double needed = 0;     ///< the strength to try next
};

Step try_strength(const std::vector<Condition>& all, double strength, const Requirement& requirement,
                  const Progress& progress) {
    Step step;
    step.result.strength = strength;
    step.result.reached = true;
    for (const Condition& condition : all) {
        const Response response = pilot_response(*condition.bench, strength, requirement.pilots, progress);
        const double log10_pm = log10_miss(response, strength, requirement.pf);
        step.result.outcomes.push_back({condition.name, log10_pm});
        step.result.reached = step.result.reached && log10_pm <= std::log10(requirement.pm);
        step.result.gamma = response.gamma;
        step.result.distortion = response.distortion;
        step.needed = std::max(step.needed, needed_strength(response, requirement));
    }
    return step;
}

} // namespace

Recommendation recommend(const TriangleMesh& mesh, const TrialSetting& setting,
                         const Requirement& requirement, const Progress& progress) {
    const std::vector<Condition> all = conditions(mesh, setting, requirement, progress);
    double too_weak = 0, strength = first_guess;
    Recommendation best;
    for (int n = 0; n < most_steps; ++n) {
        const Step step = try_strength(all, strength, requirement, progress);
        if (step.result.reached)
            best = step.result;
        else
            too_weak = std::max(too_weak, strength);
        if (!best.reached && strength >= largest_strength)
            return step.result;
        if (best.reached &&
            (best.strength <= too_weak * (1 + tolerance) || best.strength <= smallest_strength))
            break;
        // What the response says, kept between what failed and what did; a hair above, so that it holds.
        strength = std::clamp(step.needed * (1 + tolerance / 4), smallest_strength, largest_strength);
        if (best.reached && (strength >= best.strength || strength <= too_weak))
            strength = best.strength / (1 + tolerance / 2) > too_weak ? best.strength / (1 + tolerance)
                                                                      : std::sqrt(best.strength * too_weak);
        else if (!best.reached && strength <= too_weak)
            strength = std::min(too_weak * (1 + 2 * tolerance), largest_strength);
    }
    return best;
}

} // namespace wm3d::study
