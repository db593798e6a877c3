// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Measures what the search of all poses finds and what it takes, and prints the tables of
/// docs/resync.md as Markdown. Usage: search_bench [crop|scene|deform|mirror|shapes|absent|keys|picture]...
/// [TRIALS]; the models are looked for in WM3D_MESHES. Times are of the processor, over all threads.

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

#include <wm3d/attack.hpp>
#include <wm3d/detect/tail.hpp>
#include <wm3d/io.hpp>
#include <wm3d/key/stream.hpp>
#include <wm3d/mesh/frame.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/search.hpp>
#include <wm3d/shapes/shapes.hpp>
#include <wm3d/shapes/turned.hpp>
#include <wm3d/watermark/mark.hpp>
#include <wm3d/watermark/verify.hpp>

namespace {

using namespace wm3d;

const std::vector<std::string> scans{"stanford-bunny.obj", "horse.ply", "nefertiti.obj", "igea.ply",
                                     "rocker-arm.obj"};

TriangleMesh load(const std::string& name) {
    const char* folder = std::getenv("WM3D_MESHES");
    return io::read(std::filesystem::path(folder ? folder : ".") / name).mesh();
}

/// Turned, scaled and shifted at random.
TriangleMesh moved(const TriangleMesh& mesh, std::uint64_t seed) {
    return attack::apply(mesh, attack::parse("similarity"), seed);
}

key::Key bench_key() {
    return key::Key::generate("bench");
}

TriangleMesh marked(const TriangleMesh& mesh, const key::Key& key, double strength) {
    watermark::MarkOptions options;
    options.strength = strength;
    TriangleMesh result = mesh;
    result.positions = watermark::mark(mesh, key, options).positions;
    return result;
}

struct Trial {
    watermark::VerifyReport report;
    double seconds; ///< of the processor
};

Trial searched(const TriangleMesh& suspect, const key::Key& key, double effort = 1, double pf = 1e-6) {
    watermark::VerifyOptions options;
    options.search = watermark::SearchUse::always;
    options.effort = effort;
    options.pf = pf;
    const std::clock_t begin = std::clock();
    watermark::VerifyReport report = watermark::verify(suspect, key, options);
    return {std::move(report), static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC};
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// "found of all | median log10 p | worst | median and largest seconds | median centres".
std::string summary(const std::vector<Trial>& trials) {
    std::vector<double> p, seconds, centres;
    for (const Trial& t : trials) {
        p.push_back(t.report.score.log10_p);
        seconds.push_back(t.seconds);
        centres.push_back(t.report.search ? static_cast<double>(t.report.search->centres) : 0.0);
    }
    return fmt::format(
        "{} of {} | {:.0f} | {:.1f} | {:.0f} | {:.0f} | {:.0f}",
        std::ranges::count(trials, detect::Verdict::present, [](const Trial& t) { return t.report.verdict; }),
        trials.size(), median(p), std::ranges::max(p), median(seconds), std::ranges::max(seconds),
        median(centres));
}

constexpr const char* columns =
    "present at 1e-6 | median log10 p | worst | seconds of the processor, median | most | "
    "centres, median |\n|---|---|---|---|---|---|---|";

void row(const std::string& name, const std::vector<Trial>& trials) {
    fmt::print("| {} | {} |\n", name, summary(trials));
    std::fflush(stdout);
}

void crop(std::size_t trials) {
    fmt::print("| cut away, strength 0.08 | {}\n", columns);
    for (const std::string& name : scans) {
        const TriangleMesh original = load(name);
        for (const char* percent : {"10", "30", "50"}) {
            std::vector<Trial> all;
            for (std::uint64_t seed = 1; seed <= trials; ++seed) {
                const key::Key key = bench_key();
                const TriangleMesh cut = attack::apply(
                    marked(original, key, 0.08), attack::parse(fmt::format("cropping:{}", percent)), seed);
                all.push_back(searched(moved(cut, seed), key));
            }
            row(fmt::format("{}, {} %", name, percent), all);
        }
    }
}

/// Both meshes side by side, the second so large that its box's diagonal is `ratio` times the first one's.
TriangleMesh joined(const TriangleMesh& a, TriangleMesh b, double ratio) {
    const Box of_a = surface_box(a), of_b = surface_box(b);
    const double factor = ratio * of_a.diagonal() / of_b.diagonal();
    const Vec3 place = of_a.max + Vec3(0.1, 0, 0) * of_a.diagonal();
    TriangleMesh scene = a;
    const auto first = static_cast<Index>(a.positions.size());
    for (const Vec3& p : b.positions)
        scene.positions.push_back(place + factor * (p - of_b.min));
    for (Triangle t : b.triangles) {
        for (Index& v : t)
            v += first;
        scene.triangles.push_back(t);
    }
    return scene;
}

void scene(std::size_t trials) {
    fmt::print("| in a scene with another model three times its size | {}\n", columns);
    for (const bool half : {false, true}) {
        std::vector<Trial> all;
        for (std::uint64_t seed = 0; seed < trials; ++seed) {
            const key::Key key = bench_key();
            TriangleMesh model = marked(load(scans[seed % scans.size()]), key, 0.08);
            if (half)
                model = attack::apply(model, attack::parse("cropping:50"), seed);
            const TriangleMesh other = load(scans[(seed + 1 + seed / scans.size()) % scans.size()]);
            all.push_back(searched(moved(joined(model, other, 3), seed), key));
        }
        row(half ? "half of a model" : "a whole model", all);
    }
}

void with_attack(std::initializer_list<const char*> attacks, std::size_t trials) {
    for (const char* text : attacks)
        for (const std::string& name : scans) {
            std::vector<Trial> all;
            const TriangleMesh original = load(name);
            for (std::uint64_t seed = 0; seed < trials; ++seed) {
                const key::Key key = bench_key();
                const TriangleMesh copy =
                    attack::apply(marked(original, key, 0.08), attack::parse_chain(text), seed);
                all.push_back(searched(moved(copy, seed), key));
            }
            row(fmt::format("{}, {}", name, text), all);
        }
}

void deform(std::size_t trials) {
    fmt::print("| deformed, strength 0.08 | {}\n", columns);
    with_attack({"scale:1.02,1,0.98", "bend:5"}, trials);
}

void mirror(std::size_t trials) {
    fmt::print("| mirrored | {}\n", columns);
    for (const std::string& name : scans) {
        std::vector<Trial> all;
        for (std::uint64_t seed = 0; seed < trials; ++seed) {
            const key::Key key = bench_key();
            TriangleMesh copy = marked(load(name), key, 0.05);
            for (Vec3& p : copy.positions)
                p.x() = -p.x();
            for (Triangle& t : copy.triangles)
                std::swap(t[0], t[1]);
            all.push_back(searched(moved(copy, seed), key));
            if (!all.back().report.search || !all.back().report.search->pose ||
                !all.back().report.search->pose->mirrored)
                fmt::print("not said to be mirrored\n");
        }
        row(name, all);
    }
}

void shapes_without_axes(std::size_t trials) {
    fmt::print("| shape without clear axes, default strength | {}\n", columns);
    const std::map<std::string, std::function<TriangleMesh()>> shapes{
        {"vase", [] { return shapes::vase(30000); }},
        {"gear", [] { return shapes::gear(24, 30000); }},
        {"disc", [] { return shapes::disc(30000); }}};
    for (const auto& [name, make] : shapes) {
        std::vector<Trial> all;
        for (std::uint64_t seed = 0; seed < trials; ++seed) {
            const key::Key key = bench_key();
            all.push_back(searched(moved(marked(make(), key, watermark::default_strength), seed), key));
        }
        row(name, all);
    }
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
            const Trial t = searched(moved(cut, seed), bench_key());
            said += t.report.verdict == detect::Verdict::absent ? 1 : 0;
            seconds.push_back(t.seconds);
            expected.push_back(t.report.search->expected_sigmas);
        }
        fmt::print("| {} | {} of {} | {:.0f} | {:.1f} |\n", name, said, trials, median(seconds),
                   median(expected));
        std::fflush(stdout);
    }
}

/// Wrong keys through a search of full width on a small cut model, at P_f = 0.01: every peak that is climbed
/// is tested, however low. Coarser harmonics than verify's make it quick; the price of the lattice doesn't
/// depend on them.
void keys(std::size_t trials) {
    constexpr double pf = 0.01;
    constexpr unsigned level = 3;
    TriangleMesh cut = attack::apply(shapes::blob(1500, 1), attack::parse("cropping:20"), 1);
    const search::Outline out = search::outline(cut);
    for (Vec3& p : cut.positions)
        p = (p - out.centroid) / out.radius;
    const detect::Evidence evidence(cut);
    search::CentreOptions wide;
    wide.covering = 0.08;
    const std::vector<Vec3> centres = search::centres(search::outline(cut), 100, wide);
    search::SearchOptions options;
    options.bandwidth = 24;
    options.convincing = options.hopeful = 0;
    options.clear = 0;
    const sphere::Icosphere sphere(level);
    const search::PoseLattice lattice;
    std::size_t positives = 0, fixed = 0, tested = 0, pairs = 0;
    double least = 0;
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
        fixed += p_at(search::Pose{}, 0) <= std::log10(pf) ? 1 : 0;
    }
    fmt::print("{} wrong keys at P_f = {}: {} found by a search of {} centres each, {} poses tested exactly, "
               "smallest log10 p "
               "{:.2f}; in one fixed pose {}; {} expected at most\n",
               trials, pf, positives, pairs / trials, tested, least, fixed, pf * static_cast<double>(trials));
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
            const search::Harmonics f =
                transform.of_points(directions, evidence.seen_from(centre).weights_at(1));
            float best = 0;
            correlation(f, w, [&](std::size_t, std::span<const float> t) {
                best = std::max(best, std::ranges::max(t));
            });
            fmt::print("{:.4f},{:.4f},{:.3f}\n", u, v, best / search::spread(f, w));
        }
}

} // namespace

int main(int argc, char** argv) {
    const std::map<std::string, void (*)(std::size_t)> all{{"crop", crop},
                                                           {"scene", scene},
                                                           {"deform", deform},
                                                           {"mirror", mirror},
                                                           {"shapes", shapes_without_axes},
                                                           {"absent", absent},
                                                           {"keys", keys},
                                                           {"picture", picture}};
    std::size_t trials = 3;
    std::vector<std::string> chosen;
    for (int k = 1; k < argc; ++k) {
        if (all.contains(argv[k]))
            chosen.emplace_back(argv[k]);
        else if (const int number = std::atoi(argv[k]); number > 0)
            trials = static_cast<std::size_t>(number);
        else {
            fmt::print(
                stderr,
                "usage: search_bench [crop|scene|deform|mirror|shapes|absent|keys|picture]... [TRIALS]\n");
            return 2;
        }
    }
    for (const std::string& name : chosen)
        all.at(name)(trials);
}
