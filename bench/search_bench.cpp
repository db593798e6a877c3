// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Measures what the search of all poses takes, and what it says of wrong keys, for docs/resync.md.
/// Usage: search_bench [places|levels|absent|keys|peer|picture|openings]... [TRIALS]; the models are looked for in
/// WM3D_MESHES. Times are of the processor, over all threads. How often it finds marks: search_rates.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <wm3d/attack.hpp>
#include <wm3d/detect/tail.hpp>
#include <wm3d/io.hpp>
#include <wm3d/key/stream.hpp>
#include <wm3d/mesh/frame.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/topology.hpp>
#include <wm3d/search.hpp>
#include <wm3d/shapes/shapes.hpp>
#include <wm3d/shapes/turned.hpp>
#include <wm3d/watermark/mark.hpp>
#include <wm3d/watermark/null_keys.hpp>

#include "search_models.hpp"

namespace {

using namespace wm3d;
using namespace wm3d::bench;

key::Key bench_key() {
    return key::Key::generate("bench");
}

TriangleMesh marked(const TriangleMesh& mesh, const key::Key& key, double strength) {
    watermark::MarkOptions options;
    options.strength = strength;
    options.profile = watermark::Profile::robust;
    TriangleMesh result = mesh;
    result.positions = watermark::mark(mesh, key, options).positions;
    return result;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// Unmarked cut copies: what it takes to say so.
void absent(std::size_t trials) {
    fmt::print("| unmarked, 30 % cut away | absent | seconds of the processor | expected in the search "
               "|\n|---|---|---|---|\n");
    for (const std::string& name : scans) {
        std::vector<double> seconds, expected;
        std::size_t said = 0;
        for (std::uint64_t seed = 1; seed <= trials; ++seed) {
            const TriangleMesh cut = attack::apply(load(name), attack::parse("cropping:30"), seed);
            watermark::VerifyOptions options;
            options.effort = 4;
            const Searched t = searched(moved(cut, seed), bench_key(), options);
            said += t.report.verdict == detect::Verdict::absent ? 1 : 0;
            seconds.push_back(t.seconds);
            expected.push_back(t.report.search->expected_sigmas);
        }
        fmt::print("| {} | {} of {} | {:.0f} | {:.1f} |\n", name, said, trials, median(seconds),
                   median(expected));
        std::fflush(stdout);
    }
}

/// Wrong keys through a search of full width on a small cut model, at P_f = 0.01: the region of centres that
/// verify searches with effort 1, and every peak that is climbed is tested, however low. Harmonics below 24
/// are all that a sphere of level 3 has, and they bear a lattice that is 64 / 24 times as wide; the price of
/// the lattice of poses doesn't depend on them.
void keys(std::size_t trials) {
    constexpr double pf = 0.01;
    constexpr unsigned level = 3;
    TriangleMesh cut = attack::apply(shapes::blob(1250, 1), attack::parse("cropping:20"), 1);
    const search::Outline out = search::outline(cut);
    for (Vec3& p : cut.positions)
        p = (p - out.centroid) / out.radius;
    const detect::Evidence evidence(cut);
    search::CentreOptions wide;
    wide.covering = 0.045 * 64 / 24;
    const std::vector<Vec3> centres =
        search::centres(search::outline(cut), static_cast<std::size_t>(2100 / std::pow(64.0 / 24, 3)), wide);
    search::SearchOptions options;
    options.bandwidth = 24;
    options.convincing = options.hopeful = 0;
    options.clear = 0;
    const sphere::Icosphere sphere(level);
    const search::PoseLattice lattice;
    std::size_t positives = 0, fixed = 0, tested = 0, pairs = 0;
    double least = 0;
    std::vector<double> fixed_p;
    for (std::uint64_t k = 0; k < trials; ++k) {
        const std::vector<double> w = key::watermark_sequence(key::null_secret(20261125, k), level, 0.1);
        const search::KeyFunction key(sphere, w, 0.1);
        const search::Target target{level, &key, false, centres};
        double best = 0;
        const auto p_at = [&](const search::Pose& pose, std::size_t filter) {
            std::vector<Vec3> directions = cut.positions;
            for (Vec3& d : directions)
                d = pose.direction(d);
            const detect::LinearStatistic t =
                evidence.seen_from(pose.centre)
                    .statistic(filter, sphere::barycentric_rows(sphere, directions), 0.1);
            return detect::exact_tail(t, t.value(w)).log10_p;
        };
        const double log10_price = lattice.log10_size(search::Deformation::none) +
                                   std::log10(static_cast<double>(evidence.filters()));
        pairs += search::search_poses(
                     cut.positions, evidence, std::span(&target, 1),
                     [&](const search::Candidate& candidate) {
                         ++tested;
                         for (std::size_t f = 0; f < evidence.filters(); ++f)
                             best = std::min(best, log10_price + p_at(lattice.nearest(candidate.pose), f));
                         return false;
                     },
                     options)
                     .centres;
        positives += best <= std::log10(pf) ? 1 : 0;
        least = std::min(least, best);
        const double log10_fixed = p_at(search::Pose{}, 0);
        fixed += log10_fixed <= std::log10(pf) ? 1 : 0;
        fixed_p.push_back(std::pow(10, log10_fixed));
    }
    fmt::print("{} wrong keys at P_f = {}: {} found by a search of {} centres each, {} poses tested exactly, "
               "smallest log10 p "
               "{:.2f}; {} expected at most; in one fixed pose {}, whose p are uniform with {:.2f}, by "
               "Kolmogorov and Smirnov\n",
               trials, pf, positives, pairs / trials, tested, least, pf * static_cast<double>(trials), fixed,
               watermark::uniformity(fixed_p));
}

/// The number of the first centre of a lattice that is within its covering of the true one.
double number_of(const search::Outline& out, const Vec3& there, double covering, std::size_t most) {
    search::CentreOptions options;
    options.covering = covering;
    const std::vector<Vec3> centres = search::centres(out, most, options);
    const double near = covering * std::sqrt(1 + there.squaredNorm()); // wider outwards
    const auto found =
        std::ranges::find_if(centres, [&](const Vec3& c) { return (c - there).norm() <= near; });
    return static_cast<double>(found - centres.begin()) + 1;
}

/// How many centres of verify's lattices come before one that is near enough to the true centre.
void places(std::size_t trials) {
    struct Lattice {
        const char* name;
        double covering, of_effort_one; ///< centres
    };
    fmt::print(
        "| cut away | lattice | copies | within the centres of effort 0.2 | 1 | 4 | median number | most "
        "|\n|---|---|---|---|---|---|---|---|\n");
    for (const char* percent : {"10", "30", "50"})
        for (const Lattice& lattice :
             {Lattice{"wide, 0.045", 0.045, 2100}, Lattice{"fine, 0.03", 0.03, 2280}}) {
            std::vector<double> numbers;
            for (const std::string& name : scans) {
                const TriangleMesh original = load(name);
                const Vec3 truth = canonical_frame(original).centroid;
                for (std::uint64_t seed = 1; seed <= trials; ++seed) {
                    search::Outline out = search::outline(
                        attack::apply(original, attack::parse(fmt::format("cropping:{}", percent)), seed));
                    const Vec3 there = (truth - out.centroid) / out.radius;
                    out.centroid.setZero();
                    out.radius = 1;
                    numbers.push_back(number_of(out, there, lattice.covering,
                                                static_cast<std::size_t>(4 * lattice.of_effort_one)));
                }
            }
            const auto within = [&](double effort) {
                return std::ranges::count_if(
                    numbers, [&](double number) { return number <= effort * lattice.of_effort_one; });
            };
            fmt::print("| {} % | {} | {} | {} | {} | {} | {:.0f} | {:.0f} |\n", percent, lattice.name,
                       numbers.size(), within(0.2), within(1), within(4), median(numbers),
                       std::ranges::max(numbers));
            std::fflush(stdout);
        }
}

/// Borders of scans, and of scans less a part: their openings, and how flat the surface goes on around them.
void openings(std::size_t trials) {
    const auto row = [](const std::string& name, const std::string& copy, const TriangleMesh& mesh) {
        const double surface = surface_area(mesh);
        std::vector<BorderLoop> loops = border_loops(mesh);
        std::ranges::stable_sort(loops, std::greater{}, [](const BorderLoop& l) { return l.opening.norm(); });
        std::string text;
        for (std::size_t k = 0; k < std::min<std::size_t>(loops.size(), 6); ++k)
            text += fmt::format("{}{:.3f} % ({:.2f})", k > 0 ? ", " : "",
                                100 * loops[k].opening.norm() / surface, loops[k].flatness());
        fmt::print("| {} | {} | {} | {} |\n", name, copy, loops.size(), text);
    };
    fmt::print("| model | copy | borders | opening in % of the surface (flatness of its rim) "
               "|\n|---|---|---|---|\n");
    for (const char* name : {"stanford-bunny.obj", "horse.ply", "nefertiti.obj", "igea.ply", "rocker-arm.obj",
                             "fandisk.obj", "spot.obj", "DamagedHelmet.glb", "thing-73416.stl"}) {
        const TriangleMesh mesh = load(name);
        row(name, "whole", mesh);
        for (const char* attack : {"noise:0.1", "noise:0.3", "smoothing:30", "simplification:90"})
            row(name, attack, attack::apply(mesh, attack::parse(attack), 1));
        for (const char* percent : {"2", "5", "10"})
            for (std::uint64_t seed = 1; seed <= trials; ++seed) {
                const TriangleMesh cut =
                    attack::apply(mesh, attack::parse(fmt::format("cropping:{}", percent)), seed);
                row(name, fmt::format("less {} %, {}", percent, seed), cut);
            }
    }
}

/// T of the best of all rotations of some functions.
float highest(const search::RotationCorrelation<float>& correlation, std::span<const search::Harmonics> f,
              const search::Harmonics& w) {
    float best = 0;
    correlation(f, w, [&](std::size_t, std::size_t, std::span<const std::complex<float>> t) {
        for (const std::complex<float>& both : t)
            best = std::max({best, both.real(), both.imag()});
    });
    return best;
}

/// The same search of one centre by trying one rotation after the other, of which `trials` are timed.
void peer(std::size_t trials) {
    const TriangleMesh mesh = load(scans.front());
    const search::Outline out = search::outline(mesh);
    TriangleMesh base = watermark::simplify_suspect(mesh, watermark::default_vertices).base;
    for (Vec3& p : base.positions)
        p = (p - out.centroid) / out.radius;
    const detect::Evidence evidence(base);
    const std::vector<double> q = evidence.weights_at(search::SearchOptions{}.filter);
    const sphere::Icosphere sphere(5);
    const search::KeyFunction key(sphere, key::watermark_sequence(key::null_secret(1, 1), 5, 0.1), 0.1);
    constexpr unsigned bandwidth = 64;
    const search::HarmonicTransform transform(bandwidth);
    const search::RotationCorrelation<float> correlation(bandwidth, 2 * bandwidth);
    const search::Harmonics w = key.harmonics(bandwidth);
    const auto seconds = [](auto&& work) {
        const std::clock_t begin = std::clock();
        work();
        return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    };
    constexpr int rounds = 5, together = 4; // as the search does it
    float best = 0;
    const double by_transform =
        seconds([&] {
            for (int k = 0; k < rounds; ++k) {
                const std::vector<search::Harmonics> f(together, transform.of_points(base.positions, q));
                best = std::max(best, highest(correlation, f, w));
            }
        }) /
        (rounds * together);
    const double one =
        seconds([&] {
            for (std::size_t k = 0; k < trials; ++k) {
                search::Pose pose;
                pose.turn = correlation.rotation(k % 128, k / 128 % 128, 7 * k % 128);
                best = std::max(best, static_cast<float>(search::correlation(base.positions, q, key, pose)));
            }
        }) /
        static_cast<double>(trials);
    const double rotations = std::pow(2.0 * bandwidth, 3);
    fmt::print(
        "all rotations about one centre: {:.4f} s by the transform, {:.0f} s one after the other ({:.2e} s "
        "each): {:.0f} times as long (largest {:.3g})\n",
        by_transform, one * rotations, one, one * rotations / by_transform, best);
}

/// The highest of all rotations about a centre, in standard deviations.
float highest(const TriangleMesh& base, const detect::Evidence& evidence, const Vec3& centre,
              const search::Harmonics& w) {
    std::vector<Vec3> directions = base.positions;
    for (Vec3& d : directions)
        d -= centre;
    const search::Harmonics f =
        search::HarmonicTransform(w.bandwidth)
            .of_points(directions, evidence.seen_from(centre).weights_at(search::SearchOptions{}.filter));
    const search::RotationCorrelation<float> correlation(w.bandwidth, 2 * w.bandwidth);
    return highest(correlation, {&f, 1}, w) / static_cast<float>(search::spread(f, w));
}

/// What the default budget gives on a coarser level of the sphere: how sure the mark is, and how far off a
/// centre may be to show it, in harmonics below 32 and below 64.
void levels(std::size_t trials) {
    const std::vector<double> off{0, 0.03, 0.045, 0.09, 0.18};
    fmt::print(
        "| model | level | log10 p | harmonics below | highest of all rotations, about a centre off by {} "
        "|\n|---|---|---|---|---|\n",
        fmt::join(off, ", "));
    for (std::size_t k = 0; k < std::min(trials, scans.size()); ++k)
        for (const unsigned level : {5U, 4U, 3U}) {
            const key::Key key = bench_key();
            TriangleMesh mesh = load(scans[k]);
            watermark::MarkOptions options;
            options.level = level;
            mesh.positions = watermark::mark(mesh, key, options).positions;
            const double log10_p = watermark::verify(mesh, key).score.log10_p;
            const Frame frame = canonical_frame(mesh);
            const TriangleMesh base =
                watermark::simplify_suspect(to_frame(mesh, frame), watermark::default_vertices).base;
            const detect::Evidence evidence(base);
            const sphere::Icosphere sphere(level);
            const search::KeyFunction function(sphere, key::watermark_sequence(key.secret(), level, 0.1),
                                               0.1);
            for (const unsigned bandwidth : {32U, 64U}) {
                std::vector<float> sigmas;
                for (const double distance : off)
                    sigmas.push_back(highest(base, evidence, distance * Vec3(2, -1, 2) / 3,
                                             function.harmonics(bandwidth)));
                fmt::print("| {} | {} | {:.0f} | {} | {:.1f} |\n", scans[k], level, log10_p, bandwidth,
                           fmt::join(sigmas, ", "));
                std::fflush(stdout);
            }
        }
}

/// Best score over all rotations about the centres of a plane through the suspect's own centre and the true
/// one: for docs/figures/search-scores.
void picture(std::size_t trials) {
    const std::size_t n = std::max<std::size_t>(trials, 3);
    const key::Key key = bench_key();
    const TriangleMesh original = load(scans.front());
    TriangleMesh cut = attack::apply(marked(original, key, 0.05), attack::parse("cropping:30"), 1);
    const Frame truth = canonical_frame(original);
    const search::Outline out = search::outline(cut);
    for (Vec3& p : cut.positions)
        p = (p - out.centroid) / out.radius;
    const TriangleMesh base = watermark::simplify_suspect(cut, watermark::default_vertices).base;
    const detect::Evidence evidence(base);
    const sphere::Icosphere sphere(5);
    const search::KeyFunction function(sphere, key::watermark_sequence(key.secret(), 5, 0.1), 0.1);
    const Vec3 there = (truth.centroid - out.centroid) / out.radius, along = there.normalized(),
               across = along.unitOrthogonal();
    constexpr unsigned bandwidth = 64;
    const search::HarmonicTransform transform(bandwidth);
    const search::RotationCorrelation<float> correlation(bandwidth, 2 * bandwidth);
    const search::Harmonics w = function.harmonics(bandwidth);
    fmt::print("along,across,sigmas\n");
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const double u =
                -0.1 + (there.norm() + 0.2) * static_cast<double>(i) / static_cast<double>(n - 1);
            const double v =
                (there.norm() + 0.2) * (static_cast<double>(j) / static_cast<double>(n - 1) - 0.5);
            const Vec3 centre = u * along + v * across;
            std::vector<Vec3> directions = base.positions;
            for (Vec3& d : directions)
                d -= centre;
            const search::Harmonics f = transform.of_points(
                directions, evidence.seen_from(centre).weights_at(search::SearchOptions{}.filter));
            fmt::print("{:.4f},{:.4f},{:.3f}\n", u, v,
                       highest(correlation, {&f, 1}, w) / search::spread(f, w));
        }
}

} // namespace

int main(int argc, char** argv) {
    const std::map<std::string, void (*)(std::size_t)> all{
        {"places", places}, {"levels", levels},   {"absent", absent},    {"keys", keys},
        {"peer", peer},     {"picture", picture}, {"openings", openings}};
    std::size_t trials = 3;
    std::vector<std::string> chosen;
    for (int k = 1; k < argc; ++k) {
        if (all.contains(argv[k]))
            chosen.emplace_back(argv[k]);
        else if (const int number = std::atoi(argv[k]); number > 0)
            trials = static_cast<std::size_t>(number);
        else {
            fmt::print(stderr,
                       "usage: search_bench [places|levels|absent|keys|peer|picture|openings]... [TRIALS]\n");
            return 2;
        }
    }
    for (const std::string& name : chosen)
        all.at(name)(trials);
}
