// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_verify.hpp"

#include <cmath>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/core/error.hpp>
#include <wm3d/payload/soft_binding.hpp>
#include <wm3d/resync/receipt.hpp>
#include <wm3d/watermark/verify.hpp>

#include "support/key_files.hpp"
#include "support/mesh_files.hpp"
#include "support/probability_text.hpp"
#include "support/usage.hpp"
#include "verify_condition.hpp"

namespace wm3d::cmd {

namespace {

using detect::Verdict;
using nlohmann::ordered_json;

struct VerifyArguments {
    MeshFiles files;
    std::string key;
    watermark::VerifyOptions options;
    std::string detector = "whitened";
    std::string resync; ///< empty: pca, and icp where a receipt or a reference is given
    std::string receipt, reference;
    std::string commitment;
    bool exit_zero = false;
};

int exit_status(Verdict verdict) {
    switch (verdict) {
    case Verdict::present:
        return 0;
    case Verdict::absent:
        return 1;
    default:
        return 3;
    }
}

Tone tone(Verdict verdict) {
    return verdict == Verdict::present  ? Tone::good
           : verdict == Verdict::absent ? Tone::plain
                                        : Tone::warning;
}

/// What keeps a search from ruling out a mark.
std::string search_limits(const watermark::VerifyReport& report) {
    if (!report.search || report.search->centres == 0)
        return ", and the rest alone doesn't tell where the mark lies (--resync search looks for it "
               "everywhere)";
    if (!report.search->complete)
        return fmt::format(", and the search was not wide enough for any cut (--effort {:g} is)",
                           report.search->enough);
    return ", and the search would miss a mark of the usual strength on so little or so rough a surface";
}

std::string too_few_vertices(const watermark::TooFewVertices& few) {
    return fmt::format(
        "{} vertices are too few to find a mark whose pose isn't known: of 100 keys 99 would score below "
        "{:.1f} standard "
        "deviations there, however strong their marks, and {:.1f} are needed, so nothing was searched; give "
        "--receipt or --reference, which tell where the mark would lie.",
        few.vertices, few.most_sigmas, few.needed_sigmas);
}

/// Why a verdict is inconclusive, and what would help.
std::string reason(const watermark::VerifyReport& report) {
    switch (report.doubt) {
    case watermark::Doubt::opening:
        if (report.lone_flat > report.largest_opening)
            return fmt::format(
                "a plane face has {:.1f} % of its surface, which is nowhere else plane, so a cut "
                "may have been closed there{}; give "
                "--receipt or --reference, which tell where the mark would lie.",
                100 * report.lone_flat, search_limits(report));
        return fmt::format("it has an opening as large as {:.1f} % of its surface, so a part may have been "
                           "cut off there{}; give "
                           "--receipt or --reference, which tell where the mark would lie.",
                           100 * report.largest_opening, search_limits(report));
    case watermark::Doubt::vertices:
        return too_few_vertices(*report.search->too_few);
    case watermark::Doubt::axes:
        return "its shape has no clear axes, and the search of all poses was too short or would miss a mark "
               "of the "
               "usual strength; give a larger --effort, or --receipt or --reference, which tell the pose.";
    case watermark::Doubt::alignment:
        return "it could not be aligned with what was given, so the place where the mark would lie is not "
               "known.";
    default:
        return fmt::format(
            "this mesh is too small, too plain or too damaged to say that the mark is absent: one of "
            "the usual strength would be missed with probability {:.2g}.",
            report.predicted_miss);
    }
}

std::string_view name(watermark::Doubt doubt) {
    switch (doubt) {
    case watermark::Doubt::opening:
        return "opening";
    case watermark::Doubt::vertices:
        return "vertices";
    case watermark::Doubt::axes:
        return "axes";
    case watermark::Doubt::alignment:
        return "alignment";
    default:
        return "power";
    }
}

std::string sentence(const VerifyArguments& arguments, const watermark::VerifyReport& report,
                     const std::string& key) {
    const std::string file = display_name(arguments.files.input);
    const double pf = arguments.options.pf;
    const std::string p = power_of_ten(report.score.log10_p);
    if (report.verdict == Verdict::present && arguments.detector == "paper")
        return fmt::format(
            "present by the paper's own test: {} passes the threshold of eq. (6) for P_f = {:g} with {}. On "
            "this mesh a random "
            "key passes it with probability {}; the default detector's verdict is the one to rely on.",
            file, pf, key, power_of_ten(report.paper.log10_true_pf));
    switch (report.verdict) {
    case Verdict::present:
        return fmt::format(
            "present: {} carries the mark of {}. A random key scores like this with probability {} at "
            "most.",
            file, key, p);
    case Verdict::absent:
        return fmt::format(
            "absent: {} does not carry the mark of {} (p = {}, and {:g} is asked for). A mark of the usual "
            "strength would be missed with probability {}.",
            file, key, p, pf, power_of_ten(std::log10(std::max(report.predicted_miss, 1e-300))));
    default:
        return fmt::format("inconclusive: nothing of {} was found in {} (p = {}), but {}", key, file, p,
                           reason(report));
    }
}

std::string search_figures(const watermark::VerifyReport& report) {
    if (!report.search || (report.search->centres == 0 && !report.search->pose))
        return "";
    const watermark::SearchReport& search = *report.search;
    std::string text = fmt::format("\nsearch          {} centres, {:.2g} rotations in {:.1f} s",
                                   search.centres, search.rotations, search.seconds);
    if (!search.pose)
        return text + fmt::format("; {:.1f} standard deviations expected there", search.expected_sigmas);
    text += fmt::format("; the pose pays for 10^{:.1f} hypotheses", search.log10_hypotheses);
    if (search.pose->piece)
        text += fmt::format("; in piece {} of {}", *search.pose->piece + 1, search.pieces - 1);
    if (search.pose->deformation != search::Deformation::none)
        text += fmt::format("; the shape was {}", search::name(search.pose->deformation));
    return text;
}

std::string figures(const watermark::VerifyReport& report) {
    std::string text = fmt::format(
        "log10 p         {:.2f} (family-wise, {} hypotheses)\nscore           {:.2f} standard deviations; "
        "{:.1f} expected of a mark of the usual strength\nbase vertices   {}\nbest            level {}, pose "
        "{}",
        report.score.log10_p, report.score.hypotheses, report.score.best.sigmas, report.expected_sigmas,
        report.base_vertices, report.level, report.pose);
    if (report.filter)
        text += ", " + detect::describe(*report.filter);
    if (report.by_difference)
        text += ", difference from the reference";
    text += fmt::format(" ({})", report.pose_origin);
    if (report.registration)
        text +=
            fmt::format("\nalignment       {:.1f} % of the suspect explained, residual {:.2g} mean radii, "
                        "confidence {:.2f}",
                        100 * report.registration->coverage, report.registration->residual,
                        report.registration->confidence);
    text += search_figures(report);
    const watermark::PaperReport& paper = report.paper;
    text += fmt::format("\npaper           rho = {:.3e}, T_rho = {:.3e}, whose true P_f on this mesh is {}\n",
                        paper.statistics.rho, paper.threshold, power_of_ten(paper.log10_true_pf));
    if (report.payload)
        text += fmt::format(
            "payload         {} ({} bits, {:.1f} standard deviations; a random key would show any with "
            "probability {})\n",
            payload::to_argument(report.payload->message), payload::capacity(report.payload->format),
            report.payload->sigmas, power_of_ten(report.payload->log10_p));
    if (report.null)
        text +=
            fmt::format("random keys     {} of {} reach the verdict \"present\"; uniformity of p: {:.3f}\n",
                        report.null->false_positives, report.null->keys, report.null->p_uniformity);
    return text;
}

ordered_json paper_json(const watermark::PaperReport& paper) {
    const detect::PaperStatistics& s = paper.statistics;
    return {{"rho", s.rho},
            {"threshold", paper.threshold},
            {"n", s.n},
            {"mu_r", s.mu_r},
            {"sigma_r2", s.sigma_r2},
            {"delta_mean", s.delta_mean},
            {"delta_mean_square", s.delta_mean_square},
            {"true_pf", std::pow(10, paper.log10_true_pf)},
            {"log10_true_pf", paper.log10_true_pf},
            {"log10_p", paper.log10_p}};
}

ordered_json registration_json(const resync::Registration& registration) {
    return {{"aligned", registration.aligned},       {"mirrored", registration.transform.mirrors()},
            {"coverage", registration.coverage},     {"residual", registration.residual},
            {"confidence", registration.confidence}, {"searched", registration.searched}};
}

ordered_json pose_json(const watermark::FoundPose& pose) {
    const Frame& f = pose.frame;
    ordered_json axes = ordered_json::array();
    for (Eigen::Index r = 0; r < 3; ++r)
        axes.push_back({f.axes(r, 0), f.axes(r, 1), f.axes(r, 2)});
    ordered_json json{{"centre", {f.centroid.x(), f.centroid.y(), f.centroid.z()}},
                      {"axes", axes},
                      {"scale", f.scale},
                      {"mirrored", pose.mirrored},
                      {"deformation", search::name(pose.deformation)}};
    if (pose.piece)
        json["piece"] = *pose.piece;
    return json;
}

ordered_json search_json(const watermark::SearchReport& search) {
    ordered_json json{{"pieces", search.pieces},       {"centres", search.centres},
                      {"rotations", search.rotations}, {"seconds", search.seconds},
                      {"complete", search.complete},   {"expected_sigmas", search.expected_sigmas}};
    if (search.too_few)
        json["too_few"] = {{"vertices", search.too_few->vertices},
                           {"most_sigmas", search.too_few->most_sigmas},
                           {"needed_sigmas", search.too_few->needed_sigmas}};
    if (search.pose) {
        json["log10_hypotheses"] = search.log10_hypotheses;
        json["pose"] = pose_json(*search.pose);
    }
    return json;
}

/// The payload as text or digits, and what is known about its reading.
void add_payload(ordered_json& json, const payload::Reading& reading) {
    json["payload"] = reading.message.value;
    json["payload_reading"] = {
        {"kind", reading.message.kind == payload::Message::Kind::text ? "text" : "hex"},
        {"bits", payload::capacity(reading.format)},
        {"log10_p", reading.log10_p},
        {"sigmas", reading.sigmas},
        {"coded_bits", reading.coded_bits},
        {"coded_errors", reading.coded_errors}};
    json["soft_binding"] = {{"alg", payload::soft_binding_alg},
                            {"value", payload::soft_binding_value(reading.message)}};
}

ordered_json to_json(const VerifyArguments& arguments, const watermark::VerifyReport& report,
                     const key::Key& key) {
    ordered_json json{{"input", arguments.files.input},
                      {"key", key.fingerprint()},
                      {"verdict", detect::name(report.verdict)},
                      {"pf", arguments.options.pf},
                      {"log10_p", report.score.log10_p},
                      {"log10_p_is_bound", report.score.bound},
                      {"hypotheses", report.score.hypotheses},
                      {"detector", arguments.detector},
                      {"resync", arguments.resync.empty() ? "pca" : arguments.resync},
                      {"sigmas", report.score.best.sigmas},
                      {"expected_sigmas", report.expected_sigmas},
                      {"predicted_miss", report.predicted_miss},
                      {"largest_opening_percent", 100 * report.largest_opening},
                      {"base_vertices", report.base_vertices},
                      {"level", report.level},
                      {"pose", report.pose},
                      {"pose_origin", report.pose_origin},
                      {"paper", paper_json(report.paper)}};
    if (report.doubt != watermark::Doubt::none)
        json["reason"] = name(report.doubt);
    if (report.filter)
        json["filter"] = {{"t", report.filter->t},
                          {"power", report.filter->power},
                          {"hinges", report.filter->hinges},
                          {"noise", report.filter->noise}};
    if (report.search) {
        json["search"] = search_json(*report.search);
        if (report.search->pose) // more than an integer holds
            json["hypotheses"] = std::pow(10.0, report.search->log10_hypotheses);
    }
    if (report.registration)
        json["registration"] = registration_json(*report.registration);
    if (!arguments.reference.empty())
        json["reference"] = {{"covered", report.reference_coverage}, {"decided", report.by_difference}};
    if (report.payload)
        add_payload(json, *report.payload);
    if (report.null)
        json["null"] = {{"keys", report.null->keys},
                        {"false_positives", report.null->false_positives},
                        {"p_uniformity", report.null->p_uniformity}};
    return json;
}

/// What the owner gave besides the key.
struct Evidence {
    std::optional<std::string> receipt_text;
    std::optional<resync::Receipt> receipt;
    std::optional<io::Model> reference;
};

Evidence read_evidence(const VerifyArguments& arguments, Output& output) {
    Evidence evidence;
    if (!arguments.receipt.empty()) {
        evidence.receipt_text = io::read_file(arguments.receipt);
        evidence.receipt = resync::parse_receipt(*evidence.receipt_text, arguments.receipt);
    }
    if (!arguments.reference.empty())
        evidence.reference = read_mesh(arguments.reference);
    if (evidence.receipt && arguments.resync.empty() && !resync::has_registration())
        output.warn(
            "this build was made without Ceres, so the receipt's frame is tried as it stands alone; a copy "
            "that was cut and moved needs a build with -DWM3D_RESYNC=ON");
    return evidence;
}

watermark::VerifyOptions with_evidence(const VerifyArguments& arguments, const Evidence& evidence) {
    watermark::VerifyOptions options = arguments.options;
    options.receipt = evidence.receipt ? &*evidence.receipt : nullptr;
    options.reference = evidence.reference ? &evidence.reference->mesh() : nullptr;
    options.align_receipt =
        arguments.resync == "icp" || (arguments.resync.empty() && resync::has_registration());
    return options;
}

/// Which of the receipt's two files the suspect is byte for byte. Whatever the detector says, the hashes
/// can't err.
std::string_view file_in_receipt(const io::Model& suspect, const resync::Receipt& receipt) {
    // Positions that don't change leave every byte as it was read.
    const resync::FileDigest digest = resync::digest_of(suspect.patched(suspect.mesh().positions));
    return digest == receipt.marked ? "marked" : digest == receipt.original ? "original" : "other";
}

std::string receipt_line(std::string_view file) {
    return fmt::format("receipt         the suspect is {}\n",
                       file == "marked"     ? "byte for byte the file that was written when it was marked"
                       : file == "original" ? "byte for byte the original, before it was marked"
                                            : "neither the marked file nor the original, byte for byte");
}

/// What the pose that a search found tells besides the verdict.
void tell_pose(const VerifyArguments& arguments, const watermark::VerifyReport& report, Output& output) {
    if (!report.search || !report.search->pose)
        return;
    const watermark::FoundPose& pose = *report.search->pose;
    const std::string file = display_name(arguments.files.input);
    if (pose.mirrored)
        output.warn(fmt::format("{} is a mirror image of what was marked; it was examined as such", file));
    if (pose.piece)
        output.warn(fmt::format("the mark is on a piece of {}, not on all of it", file));
}

/// What a registration tells besides the verdict.
void tell_alignment(const VerifyArguments& arguments, const watermark::VerifyReport& report, Output& output) {
    if (!report.registration)
        return;
    const std::string against = arguments.reference.empty() ? arguments.receipt : arguments.reference;
    if (!report.registration->aligned)
        output.warn(
            fmt::format("{} could not be aligned with {}: the best pose explains {:.0f} % of it; either it "
                        "is another object, or too little of it is left",
                        display_name(arguments.files.input), against, 100 * report.registration->coverage));
    else if (report.registration->transform.mirrors())
        output.warn(fmt::format("{} is a mirror image of {}; it was examined as such",
                                display_name(arguments.files.input), against));
    else if (report.registration->confidence < 0.1 && report.verdict != Verdict::present)
        output.warn(
            fmt::format("{} fits {} in clearly different poses almost equally well, so the pose that was "
                        "examined may be a wrong one",
                        display_name(arguments.files.input), against));
}

int run(const VerifyArguments& arguments, Output& output) {
    if (arguments.resync == "icp" && arguments.receipt.empty() && arguments.reference.empty())
        throw ParameterError(
            "--resync icp aligns the suspect with something: give --receipt or --reference, or use "
            "--resync pca");
    const key::Key key = load_key(arguments.key, output);
    const Evidence evidence = read_evidence(arguments, output);
    const Condition condition =
        condition_of(arguments.commitment, key, {arguments.options.vertices}, evidence.receipt_text);
    io::Model model = read_input(arguments.files);
    const std::string_view file = evidence.receipt ? file_in_receipt(model, *evidence.receipt) : "";
    const TriangleMesh mesh = std::move(model).take_mesh();
    const watermark::VerifyReport report =
        watermark::verify(mesh, key, with_evidence(arguments, evidence), output.progress());
    tell_alignment(arguments, report, output);
    tell_pose(arguments, report, output);
    const std::string name =
        key.name().empty() ? "key " + key.fingerprint() : fmt::format("key '{}'", key.name());
    output.print(output.toned(sentence(arguments, report, name), tone(report.verdict)) + "\n");
    if (!output.quiet())
        output.print(figures(report));
    ordered_json json = to_json(arguments, report, key);
    if (evidence.receipt) {
        if (!output.quiet())
            output.print(receipt_line(file));
        json["receipt"] = {{"file", file}};
    }
    if (!output.quiet())
        output.print(condition_line(condition));
    json["condition"] = to_json(condition);
    output.print_json(json);
    return arguments.exit_zero ? exit_done : exit_status(report.verdict);
}

void add_options(CLI::App& app, VerifyArguments& arguments) {
    add_input(app, arguments.files);
    app.add_option("--key", arguments.key, "Owner's key file")->option_text("FILE (required)")->required();
    app.add_option("--pf", arguments.options.pf, "False-positive probability of the verdict [1e-6]")
        ->option_text("P")
        ->check(probability());
    app.add_option("--detector", arguments.detector,
                   "whitened: exactly calibrated; paper: eq. (4) and (6) word for word [whitened]")
        ->option_text("NAME")
        ->check(CLI::IsMember({"whitened", "paper"}));
    app.add_option(
           "--resync", arguments.resync,
           "pca: principal axes, every sign; search: every pose, where pca finds nothing; none: canonical "
           "frame alone; icp: align with what is given [pca, and search where the suspect could be a part, a "
           "scene or without clear axes; with --receipt or --reference pca and icp]")
        ->option_text("NAME")
        ->check(CLI::IsMember({"pca", "search", "none", "icp"}));
    app.add_option("--effort", arguments.options.effort,
                   "How long to search: 1 takes a minute or two on two cores, 0 doesn't [1]")
        ->option_text("E")
        ->check(number_between(0, 1000));
    app.add_option("--receipt", arguments.receipt,
                   "What `mark --receipt` wrote: finds cut and ambiguous copies")
        ->option_text("FILE");
    app.add_option("--commitment", arguments.commitment,
                   "What keygen or mark --commitment wrote: checks that it fixed this key and this receipt")
        ->option_text("FILE");
    app.add_option("--reference", arguments.reference,
                   "The unmarked original: align with it and look at the difference")
        ->option_text("FILE");
    app.add_option(
           "--vertices", arguments.options.vertices,
           "Vertices to simplify the suspect to [20000]; where that shows nothing, all of up to 50000 "
           "are looked at")
        ->option_text("N")
        ->check(number_between(4, 1e8));
    app.add_option("--null-keys", arguments.options.null_keys, "Also score N random keys on this mesh")
        ->option_text("N")
        ->check(number_between(1, 1e8));
    app.add_option("--null-seed", arguments.options.null_seed, "Which random keys [1]")->option_text("S");
    app.add_flag("--exit-zero", arguments.exit_zero, "Exit with 0 whatever the verdict");
}

} // namespace

Action declare_verify(CLI::App& app) {
    const auto arguments = std::make_shared<VerifyArguments>();
    app.description("Says whether a key's mark is in a mesh: present, absent, or inconclusive where the "
                    "mesh can't tell.\n"
                    "The probability that it names is exact for this very mesh: how often a random key "
                    "scores like this.\n"
                    "Needs the key file alone, for cut copies and pieces of scenes too; a receipt or "
                    "original finds more.\n"
                    "Exit status: 0 present, 1 absent, 3 inconclusive, 2 error.");
    add_options(app, *arguments);
    app.footer("Examples:\n  wm3d verify suspect.obj --key museum.key\n"
               "  wm3d verify suspect.ply --key museum.key --pf 1e-9 --json\n"
               "  wm3d verify head.ply --key museum.key --receipt statue.receipt\n"
               "  wm3d verify any.stl --key museum.key --pf 0.05 --null-keys 200");
    return [arguments](Output& output) {
        arguments->options.detector =
            arguments->detector == "paper" ? watermark::Detector::paper : watermark::Detector::whitened;
        arguments->options.search = arguments->resync.empty()       ? watermark::SearchUse::when_needed
                                    : arguments->resync == "search" ? watermark::SearchUse::always
                                                                    : watermark::SearchUse::never;
        arguments->options.resync = arguments->resync == "none"  ? watermark::Resync::none
                                    : arguments->resync == "icp" ? watermark::Resync::icp
                                                                 : watermark::Resync::pca;
        return run(*arguments, output);
    };
}

} // namespace wm3d::cmd
