// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/recommend.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include <boost/math/tools/roots.hpp>
#include <fmt/format.h>

namespace wm3d::study {

namespace {

constexpr double tolerance = 0.02; // of the size
constexpr int most_steps = 12;

/// Where sizes are looked for.
struct SizeRange {
    double smallest, first_guess, largest;
    double slope; ///< of log size over log move, until two steps tell it
};

SizeRange range_of(Sizing sizing) {
    return sizing == Sizing::visibility ? SizeRange{1e-3, 0.05, 0.5, 0.7} : SizeRange{1e-5, 0.01, 2, 1};
}

struct Condition {
    std::string name;
    std::unique_ptr<TrialBench> bench;
};

std::vector<Condition> conditions(const TriangleMesh& mesh, const TrialSetting& setting,
                                  const Requirement& requirement, const Progress& progress) {
    TrialSetting whole = setting;
    whole.damage = {};
    std::vector<Condition> all;
    all.push_back({"none", std::make_unique<TrialBench>(mesh, std::move(whole), progress)});
    for (const NamedDamage& damage : requirement.survive)
        all.push_back(
            {damage.name, std::make_unique<TrialBench>(*all.front().bench, damage.damage, progress)});
    return all;
}

/// The factor on the moves at which this response would just meet the requirement.
double needed_factor(const Response& response, const Requirement& requirement) {
    const auto excess = [&](double log_factor) {
        return log10_miss(response, std::exp(log_factor), requirement.pf) - std::log10(requirement.pm);
    };
    constexpr double most = 1000;
    const double low = -std::log(most), high = std::log(most);
    if (excess(low) <= 0)
        return 1 / most;
    if (excess(high) > 0)
        return most;
    const auto narrow = [](double a, double b) { return b - a <= tolerance / 10; };
    return std::exp(boost::math::tools::bisect(excess, low, high, narrow).second);
}

struct Step {
    Recommendation result;    ///< for the size that was tried
    double needed_factor = 0; ///< on its moves; 0 where no mark keeps to the size
};

Step try_size(const std::vector<Condition>& all, double size, const Requirement& requirement,
              const Progress& progress) {
    Step step;
    step.result.sizing = all.front().bench->setting().sizing;
    step.result.size = size;
    std::vector<watermark::Marked> pilots;
    try {
        pilots = pilot_marks(*all.front().bench, size, requirement.pilots, progress);
    } catch (const watermark::TooVisible&) {
        return step;
    }
    step.result.reached = true;
    for (const Condition& condition : all) {
        const Response response = pilot_response(*condition.bench, pilots, progress);
        const double log10_pm = log10_miss(response, 1, requirement.pf);
        step.result.outcomes.push_back({condition.name, log10_pm});
        step.result.reached = step.result.reached && log10_pm <= std::log10(requirement.pm);
        step.result.gamma = response.gamma;
        step.result.distortion = response.distortion;
        step.needed_factor = std::max(step.needed_factor, needed_factor(response, requirement));
    }
    return step;
}

/// How log size grows with log move between two steps, where they tell.
double slope_between(const Recommendation& a, const Recommendation& b, double usual) {
    constexpr double least = 0.2, most = 2;
    const double slope =
        std::log(a.size / b.size) / std::log(a.distortion.normal_rms / b.distortion.normal_rms);
    return std::isfinite(slope) && slope > 0 ? std::clamp(slope, least, most) : usual;
}

/// The sizes between which the smallest one lies.
struct Bracket {
    SizeRange range;
    double too_small = 0;
    Recommendation best{}; ///< the smallest that was found to be enough

    void add(const Recommendation& tried) {
        if (tried.reached)
            best = tried;
        else
            too_small = std::max(too_small, tried.size);
    }

    bool closed() const {
        return best.reached && (best.size <= too_small * (1 + tolerance) || best.size <= range.smallest);
    }

    /// What the response says, kept between what failed and what did.
    double next(double proposed) const {
        const double size = std::clamp(proposed, range.smallest, range.largest);
        if (best.reached && (size >= best.size || size <= too_small))
            return best.size / (1 + tolerance / 2) > too_small ? best.size / (1 + tolerance)
                                                               : std::sqrt(best.size * too_small);
        if (!best.reached && size <= too_small)
            return std::min(too_small * (1 + 2 * tolerance), range.largest);
        return size;
    }
};

} // namespace

Sizing best_sizing(watermark::Profile profile) {
    return profile == watermark::Profile::masked ? Sizing::visibility : Sizing::strength;
}

std::string largest_size(Sizing sizing) {
    return fmt::format("{:g}{}", range_of(sizing).largest, sizing == Sizing::strength ? " %" : "");
}

Recommendation recommend(const TriangleMesh& mesh, const TrialSetting& setting,
                         const Requirement& requirement, const Progress& progress) {
    const std::vector<Condition> all = conditions(mesh, setting, requirement, progress);
    Bracket bracket{range_of(setting.sizing)};
    double size = bracket.range.first_guess, slope = bracket.range.slope;
    Recommendation previous;
    for (int n = 0; n < most_steps && !bracket.closed(); ++n) {
        const Step step = try_size(all, size, requirement, progress);
        bracket.add(step.result);
        if (!bracket.best.reached && size >= bracket.range.largest)
            return step.result;
        if (step.needed_factor > 0) {
            slope = slope_between(step.result, previous, slope);
            previous = step.result;
        }
        // A hair above what is needed, so that it holds; twice the size where nothing could be made.
        const double factor =
            step.needed_factor > 0 ? std::pow(step.needed_factor, slope) * (1 + tolerance / 4) : 2;
        size = bracket.next(size * factor);
    }
    return bracket.best;
}

} // namespace wm3d::study
