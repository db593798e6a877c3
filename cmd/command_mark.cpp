// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_mark.hpp"

#include <filesystem>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/core/error.hpp>
#include <wm3d/core/version.hpp>
#include <wm3d/payload/message.hpp>
#include <wm3d/study/recommend.hpp>
#include <wm3d/watermark/mark_file.hpp>

#include "support/commitment_files.hpp"
#include "support/copies.hpp"
#include "support/key_files.hpp"
#include "support/mesh_files.hpp"
#include "support/profile_option.hpp"
#include "support/usage.hpp"

namespace wm3d::cmd {

namespace {

struct MarkArguments {
    MeshFiles files;
    std::string key;
    std::string receipt;
    std::string commitment;
    std::string normals = "keep";
    watermark::MarkOptions options;
    bool automatic = false; ///< find the visibility or the strength
    double pm = 1e-6;       ///< for `automatic`
    std::string survive;
    std::optional<std::string> payload, recipient;
    std::string ledger; ///< empty: the key's name with .ledger
};

void warn_if_too_coarse(const watermark::MarkedModel& result, Output& output) {
    if (result.coordinate_step > result.marked.distortion.normal_rms)
        output.warn(fmt::format(
            "the file stores coordinates in steps of {:.2g}, coarser than the mark's move of {:.2g}; "
            "write the model with more digits before marking it",
            result.coordinate_step, result.marked.distortion.normal_rms));
}

/// Refuses to write over the key, which nothing could bring back.
void protect_key(const MarkArguments& arguments) {
    for (const std::string& target :
         {arguments.files.output, arguments.receipt, arguments.ledger, arguments.commitment}) {
        std::error_code ignored;
        if (std::filesystem::equivalent(target, arguments.key, ignored))
            throw ParameterError(
                fmt::format("{}: this is the key, which is never written over; name another file", target));
    }
}

/// Whether visibility is what the mark keeps to.
bool budgeted(const watermark::MarkOptions& options) {
    return !options.strength && !options.gamma;
}

nlohmann::ordered_json to_json(const MarkArguments& arguments, const key::Key& key,
                               const watermark::MarkedModel& result) {
    const watermark::Marked& marked = result.marked;
    const embed::Distortion d = watermark::percent(marked.distortion, marked.diagonal);
    nlohmann::ordered_json json = {{"input", arguments.files.input},
                                   {"output", arguments.files.output},
                                   {"key", key.fingerprint()},
                                   {"base_vertices", marked.base_vertices},
                                   {"profile", watermark::name(marked.profile)},
                                   {"level", marked.level},
                                   {"rmax", marked.rmax},
                                   {"gamma", marked.gamma},
                                   {"msdm2", marked.msdm2.value_or(0)},
                                   {"rms_percent", d.normal_rms},
                                   {"vertex_rms_percent", d.vertex_rms},
                                   {"max_percent", d.max},
                                   {"pf", arguments.options.pf},
                                   {"log10_p", result.check.score.log10_p},
                                   {"verdict", detect::name(result.check.verdict)}};
    if (budgeted(arguments.options))
        json["visibility"] = arguments.options.visibility;
    for (const watermark::Rehearsed& r : result.rehearsed)
        json["rehearsed"].push_back({{"attack", r.attack}, {"log10_p", r.log10_p}});
    return json;
}

/// The copy as the ledger will know it. The work is the file that is marked, byte for byte.
ledger::Entry entry_for(const watermark::MarkedModel& result, const key::Key& key,
                        const MarkArguments& arguments, const payload::CopyLabel& copy) {
    ledger::Entry entry;
    entry.work = copy.work;
    entry.file = std::filesystem::path(arguments.files.input).filename().string();
    entry.recipient = copy.recipient;
    entry.copy = resync::digest_of(result.files.bytes).sha256;
    entry.level = result.marked.level;
    nlohmann::ordered_json settings = to_json(arguments, key, result);
    for (const char* elsewhere : {"input", "output", "key", "level"})
        settings.erase(elsewhere);
    entry.settings = settings.dump();
    entry.tool = fmt::format("wm3d {}", version());
    return entry;
}

/// The marked file, its side files and the receipt, and where it is somebody's copy its entry in the ledger:
/// all of them, or none.
std::optional<ledger::Entry> write(const watermark::MarkedModel& result, const io::Model& model,
                                   const key::Key& key, const MarkArguments& arguments,
                                   const std::optional<payload::CopyLabel>& copy, Output& output) {
    const bool to_stream = arguments.files.output == "-";
    io::FileSet set({.overwrite = arguments.files.overwrite});
    std::vector<std::filesystem::path> targets;
    if (!to_stream) {
        io::add_files(set, arguments.files.output, result.files);
        targets = names_of(arguments.files.output, result.files);
    }
    const std::string ledger = ledger_path(arguments.ledger, arguments.key);
    std::optional<std::string> receipt;
    if (!arguments.receipt.empty() || (copy && !has_receipt(ledger, copy->work)))
        receipt = resync::to_text(watermark::make_receipt(model, result, key, output.progress()));
    std::optional<std::string> deposited;
    if (!arguments.receipt.empty()) { // after the files that it speaks of
        set.add(arguments.receipt, *receipt);
        targets.emplace_back(arguments.receipt);
        deposited = receipt;
    }
    add_commitment_files(set, arguments.commitment,
                         commitment::commit_to(key, {arguments.options.vertices}, deposited));
    if (to_stream)
        output.write_bytes(result.files.bytes);
    if (copy)
        return enter_copy(ledger, key, entry_for(result, key, arguments, *copy), receipt.value_or(""), set,
                          targets, arguments.files.overwrite);
    set.commit();
    return {};
}

std::string rehearsal_line(const std::vector<watermark::Rehearsed>& rehearsed) {
    std::string line;
    for (const watermark::Rehearsed& r : rehearsed)
        line += fmt::format("{}{} {:.1f}", line.empty() ? "" : ", ", r.attack, r.log10_p);
    return line;
}

void tell(const MarkArguments& arguments, const watermark::MarkedModel& result, Output& output) {
    const watermark::Marked& marked = result.marked;
    const embed::Distortion d = watermark::percent(marked.distortion, marked.diagonal);
    output.say(fmt::format("Marked {} and wrote {}; verify finds the mark there with log10 p = {:.1f}.",
                           display_name(arguments.files.input),
                           display_name(arguments.files.output, "standard output"),
                           result.check.score.log10_p));
    if (arguments.files.output == "-")
        return;
    output.print(fmt::format(
        "seen                     MSDM2 {:.4f}{}\n"
        "move along the normals   {:.4f} % of the box's diagonal (root mean square)\n"
        "move of the vertices     {:.4f} % (root mean square), {:.4f} % (largest)\n"
        "log10 p, rehearsed       {}\n"
        "profile                  {}, on {} vertices\n"
        "level, gamma, rmax       {}, {:.4g}, {:g}\n",
        marked.msdm2.value_or(0),
        budgeted(arguments.options) ? fmt::format(" of at most {:g}", arguments.options.visibility) : "",
        d.normal_rms, d.vertex_rms, d.max, rehearsal_line(result.rehearsed), watermark::name(marked.profile),
        marked.base_vertices, marked.level, marked.gamma, marked.rmax));
}

study::TrialSetting trial_setting(const watermark::MarkOptions& options, const TriangleMesh& mesh,
                                  const key::Key& key) {
    study::TrialSetting setting;
    setting.profile = options.profile;
    setting.sizing = study::best_sizing(options.profile);
    setting.vertices = options.vertices;
    setting.parameters = key.parameters();
    setting.level = options.level.value_or(
        watermark::default_level(setting.parameters, mesh.positions.size(), options.profile));
    setting.content = options.content;
    return setting;
}

/// With --auto the least visible mark that meets --pf and --pm, as `analyze --recommend` finds it.
void find_size(watermark::MarkOptions& options, const MarkArguments& arguments, const TriangleMesh& mesh,
               const key::Key& key, Output& output) {
    study::Requirement requirement;
    requirement.pf = options.pf;
    requirement.pm = arguments.pm;
    if (!arguments.survive.empty())
        requirement.survive = study::parse_damages(arguments.survive);
    const study::Recommendation advice =
        study::recommend(mesh, trial_setting(options, mesh, key), requirement, output.progress());
    if (!advice.reached)
        throw GeometryError(fmt::format(
            "{}: no {} up to {} meets P_f = {:g} and P_m = {:g} on this mesh; ask for less, or mark a finer "
            "scan of the model",
            display_name(arguments.files.input), study::name(advice.sizing),
            study::largest_size(advice.sizing), requirement.pf, requirement.pm));
    if (advice.sizing == study::Sizing::visibility)
        options.visibility = advice.size;
    else
        options.strength = advice.size;
    output.say(fmt::format("The smallest that meets P_f = {:g} and P_m = {:g} is --{} {:.4g}.",
                           requirement.pf, requirement.pm, study::name(advice.sizing), advice.size));
}

watermark::MarkModelOptions model_options(const MarkArguments& arguments, const io::Model& model,
                                          const key::Key& key, Output& output) {
    watermark::MarkModelOptions options;
    options.mark = arguments.options;
    options.normals = arguments.normals == "recompute" ? io::Normals::turn : io::Normals::keep;
    if (arguments.files.output != "-") // what goes to a stream has no files beside it
        options.output_name = arguments.files.output;
    if (arguments.recipient) {
        options.mark.content.copy = {resync::digest_of(model.bytes()).sha256, *arguments.recipient};
        check_entry(ledger_path(arguments.ledger, arguments.key), key, options.mark.content.copy->work,
                    *arguments.recipient);
    }
    if (arguments.automatic)
        find_size(options.mark, arguments, model.mesh(), key, output);
    return options;
}

int run(MarkArguments arguments, Output& output) {
    const io::Format format = check_output(arguments.files, output);
    if (!arguments.receipt.empty())
        check_target(arguments.receipt, arguments.files.overwrite);
    check_commitment_target(arguments.commitment, arguments.files.overwrite);
    protect_key(arguments);
    const key::Key key = load_key(arguments.key, output);
    const io::Model model = read_input(arguments.files);
    watermark::require_same_format(model.format(), format, arguments.files.output);

    const watermark::MarkModelOptions options = model_options(arguments, model, key, output);
    arguments.options = options.mark; // with what was found
    const watermark::MarkedModel result = watermark::mark_model(model, key, options, output.progress());
    if (result.loss != watermark::Loss::visibility && result.loss != watermark::Loss::distance)
        warn_if_too_coarse(result, output);
    if (result.loss != watermark::Loss::none) {
        output.fail(fmt::format("{}: {}", arguments.files.input,
                                watermark::describe_loss(result, arguments.options.pf)),
                    ErrorCode::self_check);
        return exit_check_failed;
    }
    const std::optional<ledger::Entry> entry =
        write(result, model, key, arguments, options.mark.content.copy, output);
    tell(arguments, result, output);
    nlohmann::ordered_json json = to_json(arguments, key, result);
    if (result.check.payload)
        json["payload"] = result.check.payload->message.value;
    if (entry)
        json["copy"] = {{"recipient", entry->recipient}, {"work", entry->work}, {"entry", entry->number}};
    if (!arguments.receipt.empty())
        json["receipt"] = arguments.receipt;
    if (!arguments.commitment.empty())
        json["commitment"] = arguments.commitment;
    output.print_json(json);
    return exit_done;
}

void add_options(CLI::App& app, MarkArguments& arguments) {
    watermark::MarkOptions& options = arguments.options;
    add_input(app, arguments.files);
    add_output(app, arguments.files);
    app.add_option("--key", arguments.key, "Owner's key file")->option_text("FILE (required)")->required();
    auto* visibility =
        app.add_option("--visibility", options.visibility,
                       "What may be seen of the mark: one-sided MSDM2, above 0 and up to 1 [0.1]");
    visibility->option_text("V")->check(share());
    auto* strength =
        app.add_option("--strength", options.strength,
                       "Root mean square move along the surface normal, in % of the diagonal of the bounding "
                       "box, instead of --visibility");
    strength->option_text("P")->check(positive_number())->excludes(visibility);
    auto* gamma =
        app.add_option("--gamma", options.gamma, "Strength as gamma of the paper's eq. (3), and its profile");
    gamma->option_text("G")->check(positive_number())->excludes(strength)->excludes(visibility);
    auto* automatic = app.add_flag("--auto", arguments.automatic,
                                   "The smallest that meets --pf and --pm, as analyze --recommend");
    automatic->option_text("(finds the strength)")->excludes(visibility)->excludes(strength)->excludes(gamma);
    app.add_option("--pm", arguments.pm, "With --auto: miss probability at most [1e-6]")
        ->option_text("P")
        ->check(probability())
        ->needs(automatic);
    app.add_option("--survive", arguments.survive,
                   "With --auto: attacks to survive, such as noise:0.3,simplify:90")
        ->option_text("LIST")
        ->needs(automatic);
    app.add_option("--vertices", options.vertices,
                   "Vertices of the base domain, where the profile has one [20000]")
        ->option_text("N")
        ->check(number_between(4, 1e8));
    app.add_option("--level", options.level,
                   "Subdivisions of the watermarking sphere [5, or 4 on small meshes]")
        ->option_text("L")
        ->check(number_between(0, sphere::max_level));
    add_profile(app, options.profile);
    app.add_option("--rmax", options.rmax, "Height of the bumps [the key's: 0.1]")
        ->option_text("R")
        ->check(number_between(1e-6, 0.999));
    app.add_option("--normals", arguments.normals,
                   "Stored normals: keep, or recompute for the marked surface [keep]")
        ->option_text("MODE")
        ->check(CLI::IsMember({"keep", "recompute"}));
    app.add_option(
           "--payload", arguments.payload,
           "Message that verify reads back: text of up to 8 bytes or 0x and up to 16 digits; twice as "
           "much where the model bears it")
        ->option_text("TEXT|0xHEX");
    auto* recipient = app.add_option("--for", arguments.recipient,
                                     "Make a copy of its own for this recipient and enter it in the ledger");
    recipient->option_text("NAME");
    app.add_option("--ledger", arguments.ledger,
                   "With --for: ledger of the copies [the key's name with .ledger]")
        ->option_text("FILE")
        ->needs(recipient);
    app.add_option("--receipt", arguments.receipt,
                   "Also write what finds cut or ambiguous copies again without the original")
        ->option_text("FILE");
    add_commitment_output(app, arguments.commitment);
    app.add_option("--pf", options.pf,
                   "False-positive probability at which the mark must be found again [1e-6]")
        ->option_text("P")
        ->check(probability());
}

} // namespace

Action declare_mark(CLI::App& app) {
    const auto arguments = std::make_shared<MarkArguments>();
    app.description(
        "Hides the mark of a key in a mesh. Only vertex coordinates change; everything else in the file "
        "stays\n"
        "byte for byte. Before the file is written it is verified: where the mark would not be found again,\n"
        "nothing is written and the exit status is 1.");
    add_options(app, *arguments);
    app.footer("Examples:\n  wm3d mark scan.ply -o marked.ply --key museum.key\n"
               "  wm3d mark model.glb -o marked.glb --key shop.key --visibility 0.05");
    return [arguments](Output& output) {
        if (arguments->payload)
            arguments->options.content.message = payload::parse_message(*arguments->payload);
        if (arguments->recipient)
            check_recipient(*arguments->recipient);
        if (arguments->recipient && arguments->files.output == "-")
            throw ParameterError(
                "--for enters a copy once it is written whole, which standard output can't tell; name a "
                "file with -o");
        return run(*arguments, output);
    };
}

} // namespace wm3d::cmd
