// SPDX-License-Identifier: GPL-3.0-or-later
// This work is based on Y. Chen, G. Medioni, "Object modelling by registration of multiple range images"
// (1992): the distance that is minimized is the one along the normal.
#include "icp.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <wm3d/core/parallel.hpp>

#include "solver.hpp"

namespace wm3d::resync {

namespace {

constexpr double least_cosine = 0.6; // of normals that may belong together
constexpr std::size_t least_terms = 20;

std::vector<PointToPlane> terms_on_points(const PointIndex& whole, const PoseTemplate& part,
                                          const Similarity& pose, double reach, std::size_t stride) {
    std::vector<PointToPlane> terms;
    for (std::size_t i = 0; i < part.points.size(); i += stride) {
        const Vec3 p = pose(part.points[i]);
        const std::size_t near = whole.nearest(p);
        const Vec3& foot = whole.points().points[near];
        const Vec3& normal = whole.points().normals[near];
        if ((p - foot).norm() < reach && normal.dot(pose.rotation * part.normals[i]) > least_cosine)
            terms.push_back({part.points[i], foot, normal});
    }
    return terms;
}

struct Match {
    PointToPlane term;
    double distance;
};

std::vector<Match> matches_on_surface(const PoseTemplate& whole, const ContactSurface& part,
                                      const Similarity& pose, double reach) {
    std::vector<std::optional<Contact>> contacts(whole.points.size());
    parallel_blocks(contacts.size(), 128, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            contacts[i] = part.contact(pose(whole.points[i]));
    });
    std::vector<Match> matches;
    for (std::size_t i = 0; i < contacts.size(); ++i)
        if (contacts[i] && contacts[i]->distance < reach &&
            contacts[i]->normal.dot(pose.rotation * whole.normals[i]) > least_cosine)
            matches.push_back(
                {{whole.points[i], contacts[i]->foot, contacts[i]->normal}, contacts[i]->distance});
    return matches;
}

/// Three robust standard deviations of the distances.
double trimming_width(std::vector<Match>& matches) {
    constexpr double least = 0.002, most = 0.06;
    const auto middle = matches.begin() + static_cast<std::ptrdiff_t>(matches.size() / 2);
    std::vector<double> distances;
    for (const Match& match : matches)
        distances.push_back(match.distance);
    std::ranges::nth_element(distances, distances.begin() + (middle - matches.begin()));
    return std::clamp(3 * 1.4826 * distances[distances.size() / 2], least, most);
}

/// Largest move of a point at distance 1 or less from the origin, about.
double change(const Similarity& a, const Similarity& b) {
    return (a.scale * a.rotation - b.scale * b.rotation).norm() + (a.translation - b.translation).norm();
}

} // namespace

Similarity refine_on_points(const PointIndex& whole, const PoseTemplate& part, const Similarity& start,
                            std::size_t stride) {
    constexpr std::array<double, 8> widths{0.3, 0.3, 0.2, 0.2, 0.12, 0.12, 0.06, 0.06};
    Similarity pose = start;
    for (double width : widths) {
        const std::vector<PointToPlane> terms = terms_on_points(whole, part, pose, width + 0.1, stride);
        if (terms.size() < least_terms)
            return pose;
        pose = solve(terms, pose, width);
    }
    return pose;
}

SurfaceFit refine_on_surface(const PoseTemplate& whole, const ContactSurface& part, const Similarity& start,
                             int iterations) {
    constexpr double settled = 1e-6;
    SurfaceFit fit{start, 0, 0};
    double width = 0.06;
    for (int i = 0; i < iterations; ++i) {
        std::vector<Match> matches = matches_on_surface(whole, part, fit.pose, 2 * width);
        if (matches.size() < least_terms)
            break;
        width = trimming_width(matches);
        std::erase_if(matches, [&](const Match& match) { return match.distance > width; });
        std::vector<PointToPlane> terms;
        double squares = 0;
        for (const Match& match : matches) {
            terms.push_back(match.term);
            squares += match.distance * match.distance;
        }
        fit.matched = matches.size();
        fit.residual = std::sqrt(squares / static_cast<double>(matches.size()));
        const Similarity next = solve(terms, fit.pose, width);
        const double moved_by = change(next, fit.pose);
        fit.pose = next;
        if (moved_by < settled)
            break;
    }
    return fit;
}

} // namespace wm3d::resync
