// SPDX-License-Identifier: GPL-3.0-or-later
#include "msdm2_window.hpp"

#include <algorithm>
#include <cmath>

namespace wm3d::metrics {

Msdm2Windows::Msdm2Windows(const TriangleMesh& mesh, const EdgeGraph& graph,
                           const std::vector<WindowSample>& samples, const PerScale& radii,
                           const Msdm2Options& options, const Thinning& thinning)
    : samples_(samples), radii_(radii), options_(options), thinning_(thinning),
      largest_(*std::ranges::max_element(radii)), walk_(mesh, graph) {
    for (std::size_t k = 0; k < radii.size(); ++k) {
        const double deviation = options.spread * radii[k];
        decay_[k] = 1 / (2 * deviation * deviation);
        weight_at_rim_[k] = std::exp(-radii[k] * radii[k] * decay_[k]);
    }
}

void Msdm2Windows::Sums::add(double weight, double weight_hat, double c, double c_hat) {
    w += weight;
    wc += weight * c;
    wcc += weight * c * c;
    w_hat += weight_hat;
    wc_hat += weight_hat * c_hat;
    wcc_hat += weight_hat * c_hat * c_hat;
    cross += weight_hat * c * c_hat;
    wc_under_w_hat += weight_hat * c;
}

void Msdm2Windows::add_vertex(const WindowSample& centre, const OutwardWalk::Reached& reached) {
    const WindowSample& q = samples_[reached.vertex];
    const double square_hat = (q.match - centre.match).squaredNorm();
    for (std::size_t k = 0; k < radii_.size(); ++k)
        if (reached.is_within(radii_[k]))
            sums_[k].add(std::exp(-reached.square * decay_[k]), std::exp(-square_hat * decay_[k]),
                         q.c[k] - centre.c[k], q.c_hat[k] - centre.c_hat[k]);
}

/// Where the edges that the walk took leave a sphere. Which ones do no processor foresees: all are written down, and those
/// that don't are written over.
void Msdm2Windows::add_crossings(const WindowSample& centre, std::size_t k) {
    const std::span<const OutwardWalk::Reached> reached = walk_.reached();
    const std::span<const OutwardWalk::Step> steps = walk_.steps();
    crossing_.resize(std::max(crossing_.size(), steps.size() + 1));
    std::size_t count = 0;
    const double square = radii_[k] * radii_[k];
    for (Index i = 0; i < steps.size(); ++i) {
        const OutwardWalk::Step& step = steps[i];
        const OutwardWalk::Reached& start = reached[step.reached];
        const bool kept = thinning_.keeps(start.vertex);
        crossing_[count] = i;
        count += kept & (start.square <= square) & (step.to_square > square);
    }
    for (const Index i : std::span(crossing_.data(), count))
        add_crossing(centre, reached[steps[i].reached], steps[i], k);
}

void Msdm2Windows::add_crossing(const WindowSample& centre, const OutwardWalk::Reached& start,
                                const OutwardWalk::Step& step, std::size_t k) {
    const WindowSample& u = samples_[start.vertex];
    const double share = step.share_within(radii_[k], start);
    if (!thinning_.kept.empty()) { // nothing is known of the outer end
        const Vec3 match = u.match + share * step.along;
        sums_[k].add(weight_at_rim_[k], std::exp(-(match - centre.match).squaredNorm() * decay_[k]),
                     u.c[k] - centre.c[k], u.c_hat[k] - centre.c_hat[k]);
        return;
    }
    const WindowSample& w = samples_[step.to];
    const Vec3 match = u.match + share * (w.match - u.match);
    sums_[k].add(weight_at_rim_[k], std::exp(-(match - centre.match).squaredNorm() * decay_[k]),
                 u.c[k] + share * (w.c[k] - u.c[k]) - centre.c[k],
                 u.c_hat[k] + share * (w.c_hat[k] - u.c_hat[k]) - centre.c_hat[k]);
}

double Msdm2Windows::local_distance(Index vertex) {
    const WindowSample& centre = samples_[vertex];
    sums_ = {};
    const double itself = 1 / static_cast<double>(thinning_.stride); // where others stand for several
    for (Sums& sums : sums_)
        sums.add(itself, itself, 0, 0);
    walk_.from(vertex, largest_);
    for (const OutwardWalk::Reached& reached : walk_.reached().subspan(1))
        if (thinning_.keeps(reached.vertex))
            add_vertex(centre, reached);
    for (std::size_t k = 0; k < radii_.size(); ++k)
        add_crossings(centre, k);
    double sum = 0;
    for (std::size_t k = 0; k < radii_.size(); ++k)
        sum += distance_of(sums_[k], centre.c[k], centre.c_hat[k]);
    return sum / static_cast<double>(radii_.size());
}

double Msdm2Windows::distance_of(const Sums& s, double c, double c_hat) const {
    // Means of the differences from the centre.
    const double m = s.wc / s.w, m_hat = s.wc_hat / s.w_hat;
    const double mu = c + m, mu_hat = c_hat + m_hat;
    const double sigma = std::sqrt(std::max(0.0, s.wcc / s.w - m * m));
    const double sigma_hat = std::sqrt(std::max(0.0, s.wcc_hat / s.w_hat - m_hat * m_hat));
    const double sigma_c = (s.cross - m * s.wc_hat - m_hat * s.wc_under_w_hat + m * m_hat * s.w_hat) / s.w;

    const Msdm2Options& o = options_;
    const double luminance = std::abs(mu - mu_hat) / (std::max(mu, mu_hat) + o.stabilizer);
    const double contrast = std::abs(sigma - sigma_hat) / (std::max(sigma, sigma_hat) + o.stabilizer);
    const double structure = std::abs(sigma * sigma_hat - sigma_c) / (sigma * sigma_hat + o.stabilizer);
    return (o.weight_luminance * luminance + o.weight_contrast * contrast + o.weight_structure * structure) /
           (o.weight_luminance + o.weight_contrast + o.weight_structure);
}

} // namespace wm3d::metrics
