// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/pose_search.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include <wm3d/core/parallel.hpp>
#include <wm3d/search/refine.hpp>
#include <wm3d/search/rotation_correlation.hpp>

namespace wm3d::search {

namespace {

constexpr std::size_t chunk = 32;   // centres between two looks at what they found
constexpr std::size_t together = 4; // centres that share a pass of the correlation

/// A target with what the search computes of its key.
struct Prepared {
    Target target;
    Harmonics harmonics;
    KeyFunction smooth; ///< for the first part of the refinement

    Prepared(const Target& t, unsigned bandwidth)
        : target(t), harmonics(t.key->harmonics(bandwidth)), smooth(t.key->smoothed(2)) {}
};

/// Like std::ranges::max, in as many lanes as a machine may have.
float largest_of(std::span<const float> values) {
    constexpr std::size_t lanes = 16;
    std::array<float, lanes> largest;
    largest.fill(-std::numeric_limits<float>::infinity());
    std::size_t i = 0;
    for (; i + lanes <= values.size(); i += lanes)
        for (std::size_t k = 0; k < lanes; ++k)
            largest[k] = values[i + k] > largest[k] ? values[i + k] : largest[k];
    for (; i < values.size(); ++i)
        largest[0] = std::max(largest[0], values[i]);
    return std::ranges::max(largest);
}

class Searcher {
public:
    Searcher(std::span<const Vec3> x, const detect::Evidence& evidence, const Accept& accept,
             const SearchOptions& options)
        : x_(x), evidence_(evidence), accept_(accept), options_(options), transform_(options.bandwidth),
          correlation_(options.bandwidth, 2 * options.bandwidth) {}

    void run(const Target& target, const Progress& progress, double done_before, double part);
    void finish(const Progress& progress);
    bool accepted() const { return outcome_.accepted; }
    const SearchOutcome& outcome() const { return outcome_; }

private:
    struct Found {
        Candidate candidate;
        const Prepared* prepared = nullptr;
    };

    Harmonics seen_from(const Vec3& centre, bool mirrored) const;
    std::vector<Found> best_rotations(const Prepared& prepared, std::span<const Vec3> centres) const;
    std::vector<Found> searched(const Prepared& prepared, std::span<const Vec3> centres) const;
    Candidate climbed(const Found& found, Deformation deformation) const;
    Found closer(Found found) const;
    Candidate climbed_around(const Found& found) const;
    double sigmas(const Prepared& prepared, const Pose& pose) const;
    void refine_and_offer(const Found& found);
    void offer(const Candidate& candidate);
    void remember(std::vector<Found>& list, const Found& found, std::size_t most) const;

    std::span<const Vec3> x_;
    const detect::Evidence& evidence_;
    const Accept& accept_;
    const SearchOptions& options_;
    HarmonicTransform transform_;
    RotationCorrelation<float> correlation_;
    std::map<std::pair<unsigned, bool>, Prepared> prepared_;
    std::vector<Found> finalists_; ///< not refined yet
    std::vector<Found> hopeful_;   ///< refined, for deformations
    SearchOutcome outcome_;
};

void Searcher::remember(std::vector<Found>& list, const Found& found, std::size_t most) const {
    list.push_back(found);
    std::ranges::stable_sort(list, std::greater{}, [](const Found& f) { return f.candidate.sigmas; });
    if (list.size() > most)
        list.resize(most);
}

/// The evidence as a function of the direction from a centre.
Harmonics Searcher::seen_from(const Vec3& centre, bool mirrored) const {
    std::vector<Vec3> directions(x_.begin(), x_.end());
    for (Vec3& d : directions)
        d -= centre;
    const Harmonics f =
        transform_.of_points(directions, evidence_.seen_from(centre).weights_at(options_.filter));
    return mirrored ? f.inverted() : f;
}

/// For each centre the best of all rotations about it.
std::vector<Searcher::Found> Searcher::best_rotations(const Prepared& prepared,
                                                      std::span<const Vec3> centres) const {
    struct Peak {
        float height = 0;
        std::array<std::size_t, 3> at{};
    };
    std::vector<Harmonics> f;
    for (const Vec3& centre : centres)
        f.push_back(seen_from(centre, prepared.target.mirrored));
    std::vector<Peak> peaks(centres.size());
    const std::size_t n = correlation_.samples();
    correlation_(f, prepared.harmonics,
                 [&](std::size_t k, std::size_t b, std::span<const std::complex<float>> values) {
                     // A complex number is laid out as its two parts.
                     const std::span<const float> parts(reinterpret_cast<const float*>(values.data()),
                                                        2 * values.size());
                     const float highest = largest_of(parts);
                     if (highest <= peaks[k].height)
                         return;
                     const auto place =
                         static_cast<std::size_t>(std::ranges::find(parts, highest) - parts.begin());
                     peaks[k] = {highest, {place / 2 / n, place % 2 == 0 ? b : n - 1 - b, place / 2 % n}};
                 });
    std::vector<Found> result;
    for (std::size_t k = 0; k < centres.size(); ++k) {
        Found& found = result.emplace_back(Found{{Pose{}, prepared.target.level, 0}, &prepared});
        found.candidate.pose.centre = centres[k];
        const double sigma = spread(f[k], prepared.harmonics);
        if (!(sigma > 0) || peaks[k].height == 0)
            continue;
        const auto [alpha, beta, gamma] = peaks[k].at;
        found.candidate.sigmas = peaks[k].height / sigma;
        found.candidate.pose.turn =
            (prepared.target.mirrored ? -1.0 : 1.0) * correlation_.rotation(alpha, beta, gamma);
    }
    return result;
}

/// The same on all threads.
std::vector<Searcher::Found> Searcher::searched(const Prepared& prepared,
                                                std::span<const Vec3> centres) const {
    std::vector<Found> result(centres.size());
    parallel_blocks(centres.size(), together, [&](std::size_t begin, std::size_t end) {
        std::ranges::copy(best_rotations(prepared, centres.subspan(begin, end - begin)),
                          result.begin() + static_cast<std::ptrdiff_t>(begin));
    });
    return result;
}

/// T of the pose over its standard deviation under random keys.
double Searcher::sigmas(const Prepared& prepared, const Pose& pose) const {
    std::vector<Vec3> directions(x_.size());
    for (std::size_t i = 0; i < directions.size(); ++i)
        directions[i] = pose.direction(x_[i]);
    const detect::LinearStatistic t =
        evidence_.seen_from(pose.centre)
            .statistic(options_.filter, sphere::barycentric_rows(prepared.target.key->sphere(), directions),
                       1);
    return t.sigma() > 0
               ? t.value(prepared.target.key->heights()) / (t.sigma() * prepared.target.key->limit())
               : 0;
}

Candidate Searcher::climbed(const Found& found, Deformation deformation) const {
    const Prepared& prepared = *found.prepared;
    Candidate result = found.candidate;
    result.pose.deformation = deformation;
    const std::vector<double> q = evidence_.seen_from(result.pose.centre).weights_at(options_.filter);
    RefineOptions options;
    options.iterations = deformation == Deformation::none ? 25 : 60;
    result.pose = refine(x_, q, prepared.smooth, result.pose, options).pose;
    const std::vector<double> q_there = evidence_.seen_from(result.pose.centre).weights_at(options_.filter);
    options.iterations *= 2;
    result.pose = refine(x_, q_there, *prepared.target.key, result.pose, options).pose;
    result.sigmas = sigmas(prepared, result.pose);
    return result;
}

void Searcher::offer(const Candidate& candidate) {
    if (candidate.sigmas > outcome_.best.sigmas || outcome_.refined == 1)
        outcome_.best = candidate;
    if (candidate.sigmas >= options_.convincing && accept_(candidate)) {
        outcome_.best = candidate;
        outcome_.accepted = true;
    }
}

/// The best rotation about the best of some centres around, closer and closer: where the centre is off by
/// half the lattice's spacing, the highest of all rotations may lie on a shoulder of the peak.
Searcher::Found Searcher::closer(Found found) const {
    for (const double step : {0.024, 0.012}) {
        const Vec3 middle = found.candidate.pose.centre;
        std::array<Vec3, 8> around;
        for (std::size_t k = 0; k < around.size(); ++k) {
            const Vec3 corner((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1);
            around[k] = middle + step / std::sqrt(3.0) * corner;
        }
        const double before = found.candidate.sigmas;
        for (const Found& other : searched(*found.prepared, around))
            if (other.candidate.sigmas > found.candidate.sigmas)
                found = other;
        if (found.candidate.sigmas == before && before < options_.worth_a_climb)
            break; // the right peak grows on its way in
    }
    return found;
}

/// A climb that ends on a shoulder of the right peak starts again around it.
Candidate Searcher::climbed_around(const Found& found) const {
    Candidate best = climbed(found, Deformation::none);
    if (best.sigmas < options_.hopeful || best.sigmas > options_.clear)
        return best;
    const Pose middle = best.pose;
    for (const double side : {1.0, -1.0})
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            Found start = found;
            start.candidate.pose = middle;
            start.candidate.pose.centre += side * options_.around * Vec3::Unit(axis);
            const Candidate other = climbed(start, Deformation::none);
            if (other.sigmas > best.sigmas)
                best = other;
        }
    return best;
}

void Searcher::refine_and_offer(const Found& found) {
    const Candidate better = climbed_around(found);
    ++outcome_.refined;
    remember(hopeful_, {better, found.prepared}, options_.finalists);
    offer(better);
}

void Searcher::run(const Target& target, const Progress& progress, double done_before, double part) {
    const auto [entry, is_new] =
        prepared_.try_emplace({target.level, target.mirrored}, target, options_.bandwidth);
    const Prepared& prepared = entry->second;
    for (std::size_t begin = 0; begin < target.centres.size() && !accepted(); begin += chunk) {
        notify(progress, "searching all poses",
               done_before + part * static_cast<double>(begin) / static_cast<double>(target.centres.size()));
        const std::size_t count = std::min(chunk, target.centres.size() - begin);
        std::vector<Found> found = searched(prepared, target.centres.subspan(begin, count));
        outcome_.centres += count;
        outcome_.rotations += static_cast<double>(count) * std::pow(correlation_.samples(), 3);
        std::ranges::stable_sort(found, std::greater{}, [](const Found& f) { return f.candidate.sigmas; });
        // Neighbouring centres see the same peak: the highest two of a chunk are enough.
        for (std::size_t k = 0; k < found.size() && !accepted(); ++k) {
            const bool promising = k < 2 && found[k].candidate.sigmas >= options_.promising;
            if (promising)
                found[k] = closer(found[k]);
            if (promising && found[k].candidate.sigmas >= options_.worth_a_climb)
                refine_and_offer(found[k]);
            else
                remember(finalists_, found[k], options_.finalists);
        }
    }
}

void Searcher::finish(const Progress& progress) {
    for (std::size_t k = 0; k < finalists_.size() && !accepted(); ++k) {
        notify(progress, "refining poses", static_cast<double>(k) / static_cast<double>(finalists_.size()));
        refine_and_offer(closer(finalists_[k]));
    }
    const std::vector<Found> starts = hopeful_;
    for (std::size_t k = 0; k < starts.size() && !accepted(); ++k) {
        Found at = starts[k];
        for (const Deformation deformation : {Deformation::affine, Deformation::bent}) {
            if (accepted() || options_.deformation < deformation || at.candidate.sigmas < options_.hopeful)
                break;
            notify(progress, "undoing deformations",
                   static_cast<double>(k) / static_cast<double>(starts.size()));
            at.candidate = climbed(at, deformation);
            ++outcome_.refined;
            offer(at.candidate);
        }
    }
}

} // namespace

double expected_sigmas(std::span<const Vec3> x, const detect::Evidence& evidence,
                       std::span<const double> mark, const KeyFunction& key, double off,
                       const SearchOptions& options) {
    const Vec3 centre = off * Vec3(2, -1, 2) / 3;
    const double half_sample = std::numbers::pi / (2.0 * options.bandwidth);
    const Mat3 turn = Eigen::AngleAxisd(half_sample, Vec3(1, 2, -2) / 3).toRotationMatrix();
    std::vector<Vec3> directions(x.begin(), x.end());
    for (Vec3& d : directions)
        d = turn * (d - centre);
    const HarmonicTransform transform(options.bandwidth);
    const Harmonics of_mark = transform.of_points(directions, mark),
                    of_key = key.harmonics(options.bandwidth);
    std::vector<double> q = evidence.seen_from(centre).weights_at(options.filter);
    for (std::size_t i = 0; i < q.size(); ++i)
        q[i] += mark[i];
    const double sigma = spread(transform.of_points(directions, q), of_key);
    double t = 0;
    for (unsigned l = 0; l < options.bandwidth; ++l)
        for (unsigned m = 0; m <= l; ++m)
            t += (m == 0 ? 1 : 2) * (std::conj(of_key(l, m)) * of_mark(l, m)).real();
    return sigma > 0 ? t / sigma : 0;
}

SearchOutcome search_poses(std::span<const Vec3> x, const detect::Evidence& evidence,
                           std::span<const Target> targets, const Accept& accept,
                           const SearchOptions& options, const Progress& progress) {
    Searcher searcher(x, evidence, accept, options);
    double all = 0, done = 0;
    for (const Target& target : targets)
        all += static_cast<double>(target.centres.size());
    for (const Target& target : targets) {
        if (searcher.accepted())
            break;
        const double part = static_cast<double>(target.centres.size()) / std::max(all, 1.0);
        searcher.run(target, progress, done, part);
        done += part;
    }
    if (!searcher.accepted())
        searcher.finish(progress);
    return searcher.outcome();
}

} // namespace wm3d::search
