// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Measures what resynchronisation survives and prints the tables of docs/resync.md, as Markdown.
/// Usage: resync_bench [blind|cut|reference|frame|keys|time]... [TRIALS]; the models are looked for in
/// WM3D_MESHES.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <wm3d/attack.hpp>
#include <wm3d/io.hpp>
#include <wm3d/resync/hierarchical_frame.hpp>
#include <wm3d/resync/smoothing_trend.hpp>
#include <wm3d/watermark/mark.hpp>
#include <wm3d/watermark/receipt.hpp>
#include <wm3d/watermark/verify.hpp>

namespace {

using namespace wm3d;
using attack::RandomStream;

const std::vector<std::string> all_models{"DamagedHelmet.glb", "fandisk.obj",        "horse.ply",
                                          "igea.ply",          "nefertiti.obj",      "rocker-arm.obj",
                                          "spot.obj",          "stanford-bunny.obj", "thing-73416.stl"};
const std::vector<std::string> scans{"stanford-bunny.obj", "nefertiti.obj", "horse.ply"};

TriangleMesh load(const std::string& name) {
    const char* folder = std::getenv("WM3D_MESHES");
    return io::read(std::filesystem::path(folder ? folder : ".") / name).mesh();
}

/// Any axis, 0 to 360 degrees, scale 0.1 to 10, translation of up to 5 mean radii.
resync::Similarity random_similarity(std::uint64_t seed, double radius) {
    const RandomStream random(seed, 1);
    const double z = random.between(0, -1, 1), turn = random.between(1, 0, 2 * EIGEN_PI);
    const double across = std::sqrt(1 - z * z);
    const Vec3 axis(across * std::cos(turn), across * std::sin(turn), z);
    resync::Similarity t;
    t.rotation = Eigen::AngleAxisd(random.between(2, 0, 2 * EIGEN_PI), axis).toRotationMatrix();
    t.scale = std::pow(10, random.between(3, -1, 1));
    t.translation =
        5 * radius *
        Vec3(random.between(4, -1, 1), random.between(5, -1, 1), random.between(6, -1, 1)).normalized();
    return t;
}

TriangleMesh moved(TriangleMesh mesh, const resync::Similarity& t) {
    for (Vec3& p : mesh.positions)
        p = t(p);
    return mesh;
}

TriangleMesh moved(const TriangleMesh& mesh, std::uint64_t seed) {
    return moved(mesh, random_similarity(seed, canonical_frame(mesh).scale));
}

/// A model, its marked copy and the receipt of it.
struct Specimen {
    TriangleMesh original, marked;
    key::Key key = key::Key::generate("bench");
    watermark::Marked report;
    resync::Receipt receipt;

    Specimen(const std::string& name, double strength) : original(load(name)), marked(original) {
        watermark::MarkOptions options;
        options.strength = strength;
        report = watermark::mark(original, key, options);
        marked.positions = report.positions;
        receipt = watermark::make_receipt(original, report, key, "", "");
    }
};

double log10_p(const TriangleMesh& suspect, const key::Key& key, const watermark::VerifyOptions& options) {
    return watermark::verify(suspect, key, options).score.log10_p;
}

watermark::VerifyOptions with_receipt(const Specimen& specimen) {
    watermark::VerifyOptions options;
    options.resync = watermark::Resync::icp;
    options.receipt = &specimen.receipt;
    options.align_receipt = true;
    return options;
}

watermark::VerifyOptions with_reference(const Specimen& specimen) {
    watermark::VerifyOptions options;
    options.resync = watermark::Resync::icp;
    options.reference = &specimen.original;
    return options;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// "median (worst), found of all" of log10 p.
std::string summary(const std::vector<double>& values) {
    const auto found = std::ranges::count_if(values, [](double p) { return p <= -6; });
    return fmt::format("{} of {} | {:.0f} | {:.0f}", found, values.size(), median(values),
                       std::ranges::max(values));
}

void blind(std::size_t trials) {
    fmt::print("| model | unmoved, no resync | moved: present at 1e-6 | median log10 p | worst "
               "|\n|---|---|---|---|---|\n");
    for (const std::string& name : all_models) {
        const Specimen specimen(name, 0.05);
        watermark::VerifyOptions none;
        none.resync = watermark::Resync::none;
        const double still = log10_p(specimen.marked, specimen.key, none);
        std::vector<double> values;
        for (std::uint64_t seed = 1; seed <= trials; ++seed)
            values.push_back(log10_p(moved(specimen.marked, seed), specimen.key, {}));
        fmt::print("| {} | {:.1f} | {} of {} | {:.1f} | {:.1f} |\n", name, still,
                   std::ranges::count_if(values, [](double p) { return p <= -6; }), values.size(),
                   median(values), std::ranges::max(values));
        std::fflush(stdout);
    }
}

void cut(std::size_t trials) {
    fmt::print("| model | cut away | receipt: present | median log10 p | worst | original: present | median "
               "log10 p | "
               "worst |\n|---|---|---|---|---|---|---|---|\n");
    for (const std::string& name : scans) {
        const Specimen specimen(name, 0.05);
        for (double percent : {10.0, 30.0, 50.0}) {
            std::vector<double> by_receipt, by_reference;
            for (std::uint64_t seed = 1; seed <= trials; ++seed) {
                attack::CropOptions crop;
                crop.percent = percent;
                const TriangleMesh suspect = moved(attack::crop(specimen.marked, crop, seed), seed + 100);
                by_receipt.push_back(log10_p(suspect, specimen.key, with_receipt(specimen)));
                by_reference.push_back(log10_p(suspect, specimen.key, with_reference(specimen)));
            }
            fmt::print("| {} | {:.0f} % | {} | {} |\n", name, percent, summary(by_receipt),
                       summary(by_reference));
            std::fflush(stdout);
        }
    }
}

void reference(std::size_t trials) {
    fmt::print("| attack on the bunny, strength 0.019 | blind, log10 p | with the original, log10 p: median "
               "| worst |\n"
               "|---|---|---|---|\n");
    for (const char* spec :
         {"simplification:97.5", "smoothing:50", "quantization:7", "noise:0.5", "simplification:90"}) {
        std::vector<double> without, with;
        for (std::uint64_t seed = 1; seed <= trials; ++seed) {
            const Specimen specimen("stanford-bunny.obj", 0.019); // another key each time
            const TriangleMesh suspect =
                moved(attack::apply(specimen.marked, attack::parse(spec), seed), seed);
            without.push_back(log10_p(suspect, specimen.key, {}));
            with.push_back(log10_p(suspect, specimen.key, with_reference(specimen)));
        }
        fmt::print("| {} | {:.1f} | {:.1f} | {:.1f} |\n", spec, median(without), median(with),
                   std::ranges::max(with));
        std::fflush(stdout);
    }
}

double angle(const Frame& frame, const Frame& truth) {
    double least = 180;
    for (const Frame& choice : sign_choices(frame))
        least = std::min(least, resync::angle_between(choice.axes, truth.axes));
    return least;
}

/// Angle between a mesh's true axes and: those of its surface, those of its own substance, the nearest that
/// are tried.
std::array<double, 3> frame_errors(const TriangleMesh& mesh, const TriangleMesh& suspect) {
    const Frame truth = canonical_frame(mesh);
    const watermark::Suspect simplified = watermark::simplify_suspect(suspect, watermark::default_vertices);
    const resync::FrameEstimate estimate = resync::estimate_frame(suspect, simplified.base);
    double nearest = angle(estimate.finest, truth);
    const double own = nearest;
    for (const resync::CandidatePose& pose : resync::candidate_poses(estimate))
        nearest = std::min(nearest, angle(pose.frame, truth));
    for (const resync::CandidatePose& pose :
         resync::frames_before_smoothing(suspect, estimate.finest, estimate.substance))
        nearest = std::min(nearest, angle(pose.frame, truth));
    const double surface =
        angle(canonical_frame(suspect, Substance::surface), canonical_frame(mesh, Substance::surface));
    return {surface, own, nearest};
}

void frame(std::size_t) {
    const std::vector<const char*> attacks{"noise:0.5", "quantization:7", "smoothing:50",
                                           "simplification:95"};
    fmt::print("| model | moments | noise 0.5 % | 7 bits | smoothing 50 | simplification 95 % |\n"
               "|---|---|---|---|---|---|\n");
    std::map<std::string, std::array<std::vector<double>, 3>> errors;
    for (const std::string& name : all_models) {
        const TriangleMesh mesh = load(name);
        const resync::FrameEstimate estimate = resync::estimate_frame(mesh, mesh, {.levels = {}});
        std::string row = fmt::format("| {} | {:.3f}, {:.3f}, {:.3f} {} |", name, estimate.moments[0],
                                      estimate.moments[1], estimate.moments[2],
                                      estimate.ambiguity == resync::Ambiguity::none ? "" : "(ambiguous)");
        for (const char* spec : attacks) {
            const std::array<double, 3> error =
                frame_errors(mesh, attack::apply(mesh, attack::parse(spec), 1));
            if (estimate.ambiguity == resync::Ambiguity::none)
                for (std::size_t k = 0; k < 3; ++k)
                    errors[spec][k].push_back(error[k]);
            row += fmt::format(" {:.3f} / {:.3f} / {:.3f} |", error[0], error[1], error[2]);
        }
        fmt::print("{}\n", row);
        std::fflush(stdout);
    }
    fmt::print("| median, not ambiguous | |");
    for (const char* spec : attacks)
        fmt::print(" {:.3f} / {:.3f} / {:.3f} |", median(errors[spec][0]), median(errors[spec][1]),
                   median(errors[spec][2]));
    fmt::print("\n");
}

void keys(std::size_t) {
    fmt::print("| path | hypotheses | random keys at P_f = 0.01 | expected at most |\n|---|---|---|---|\n");
    const Specimen specimen("stanford-bunny.obj", 0.05);
    const TriangleMesh suspect = moved(specimen.marked, 7);
    const std::vector<std::pair<std::string, watermark::VerifyOptions>> paths{
        {"pca", {}}, {"receipt, icp", with_receipt(specimen)}, {"reference", with_reference(specimen)}};
    for (auto [name, options] : paths) {
        options.pf = 0.01;
        options.null_keys = 2000;
        const watermark::VerifyReport report = watermark::verify(suspect, specimen.key, options);
        fmt::print("| {} | {} | {} of {} | {} |\n", name, report.score.hypotheses,
                   report.null->false_positives, report.null->keys, 20);
    }
}

void timing(std::size_t trials) {
    fmt::print("| verify on the bunny | median seconds |\n|---|---|\n");
    const Specimen specimen("stanford-bunny.obj", 0.05);
    watermark::VerifyOptions none;
    none.resync = watermark::Resync::none;
    const TriangleMesh whole = moved(specimen.marked, 3);
    attack::CropOptions crop;
    const TriangleMesh part = moved(attack::crop(specimen.marked, crop, 1), 3);
    const std::vector<std::tuple<std::string, const TriangleMesh*, watermark::VerifyOptions>> ways{
        {"none", &specimen.marked, none},
        {"pca", &whole, {}},
        {"receipt, whole", &whole, with_receipt(specimen)},
        {"receipt, 30 % cut", &part, with_receipt(specimen)},
        {"reference, whole", &whole, with_reference(specimen)}};
    for (const auto& [name, suspect, options] : ways) {
        std::vector<double> seconds;
        for (std::size_t i = 0; i < trials; ++i) {
            const auto start = std::chrono::steady_clock::now();
            log10_p(*suspect, specimen.key, options);
            seconds.push_back(
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        }
        fmt::print("| {} | {:.2f} |\n", name, median(seconds));
    }
}

} // namespace

int main(int argc, char** argv) {
    const std::map<std::string, std::function<void(std::size_t)>> tables{
        {"blind", blind}, {"cut", cut},   {"reference", reference},
        {"frame", frame}, {"keys", keys}, {"time", timing}};
    std::size_t trials = 20;
    std::vector<std::string> wanted;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (tables.contains(word))
            wanted.push_back(word);
        else
            trials = std::max<std::size_t>(1, std::strtoul(argv[i], nullptr, 10));
    }
    for (const auto& [name, make] : tables)
        if (wanted.empty() || std::ranges::find(wanted, name) != wanted.end()) {
            fmt::print("\n### {}\n\n", name);
            make(trials);
        }
}
