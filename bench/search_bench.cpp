// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Measures what the search of all poses finds and what it takes, and prints the tables of
/// docs/resync.md as Markdown. Usage: search_bench [crop|scene|deform|mirror|shapes|absent|keys]... [TRIALS];
/// the models are looked for in WM3D_MESHES. Times are of the processor, over all threads.

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
#include <wm3d/io.hpp>
#include <wm3d/mesh/frame.hpp>
#include <wm3d/mesh/measure.hpp>
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

/// Wrong keys through a search of a small cut model, at P_f = 0.01.
void keys(std::size_t trials) {
    const TriangleMesh whole = marked(shapes::blob(3000, 1), bench_key(), 0.1);
    const TriangleMesh cut = attack::apply(whole, attack::parse("cropping:20"), 1);
    std::size_t positives = 0, centres = 0;
    double least = 0;
    for (std::uint64_t k = 1; k <= trials; ++k) {
        const Trial t = searched(cut, bench_key(), 0.05, 0.01);
        positives += t.report.verdict == detect::Verdict::present ? 1 : 0;
        centres += t.report.search ? t.report.search->centres : 0;
        least = std::min(least, t.report.score.log10_p);
    }
    fmt::print("wrong keys at P_f = 0.01: {} of {} present, {} expected at most; {} pairs of a centre and a "
               "sequence; smallest log10 p {:.2f}\n",
               positives, trials, 0.01 * static_cast<double>(trials), centres, least);
}

} // namespace

int main(int argc, char** argv) {
    const std::map<std::string, void (*)(std::size_t)> all{{"crop", crop},
                                                           {"scene", scene},
                                                           {"deform", deform},
                                                           {"mirror", mirror},
                                                           {"shapes", shapes_without_axes},
                                                           {"absent", absent},
                                                           {"keys", keys}};
    std::size_t trials = 3;
    std::vector<std::string> chosen;
    for (int k = 1; k < argc; ++k) {
        if (all.contains(argv[k]))
            chosen.emplace_back(argv[k]);
        else if (const int number = std::atoi(argv[k]); number > 0)
            trials = static_cast<std::size_t>(number);
        else {
            fmt::print(stderr,
                       "usage: search_bench [crop|scene|deform|mirror|shapes|absent|keys]... [TRIALS]\n");
            return 2;
        }
    }
    for (const std::string& name : chosen)
        all.at(name)(trials);
}
