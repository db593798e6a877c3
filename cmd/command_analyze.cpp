// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_analyze.hpp"

#include <cmath>
#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/core/error.hpp>
#include <wm3d/study/damage.hpp>
#include <wm3d/study/paper_roc.hpp>
#include <wm3d/study/recommend.hpp>
#include <wm3d/study/trial_log.hpp>

#include "analysis_report.hpp"
#include "support/key_files.hpp"
#include "support/mesh_files.hpp"
#include "support/number_list.hpp"
#include "support/profile_option.hpp"
#include "support/usage.hpp"

namespace wm3d::cmd {

namespace {

using nlohmann::ordered_json;

struct AnalyzeArguments {
    MeshFiles files;
    std::string pf, pf_range = "1e-12:0.5:50", gamma, vertices, visibility, strength;
    watermark::Profile profile = watermark::Profile::masked;
    double sigma_r2 = 0, delta_range = 0;
    std::string key, attack;
    std::optional<unsigned> level;
    std::size_t pilots = 24, trials = 0;
    std::uint64_t seed = 1;
    std::string resume;
    bool recommend = false;
    double pm = 1e-6;
    std::string survive;
    bool csv = false;
    std::string plot;
};

std::vector<double> probabilities_of(const AnalyzeArguments& arguments) {
    if (!arguments.pf.empty())
        return parse_numbers(arguments.pf, "--pf", probabilities());
    return parse_log_range(arguments.pf_range, "--pf-range", probabilities());
}

void check_plot(const AnalyzeArguments& arguments) {
    if (arguments.plot.empty())
        return;
    const std::string extension = std::filesystem::path(arguments.plot).extension();
    if (extension != ".svg" && extension != ".png" && extension != ".html")
        throw ParameterError(fmt::format("{}: a plot is .svg, .png or .html; name it so", arguments.plot));
    check_target(arguments.plot, arguments.files.overwrite);
}

void write_plot(const AnalyzeArguments& arguments, const AnalysisReport& report, const ordered_json& json,
                Output& output) {
    if (arguments.plot.empty())
        return;
    const std::string extension = std::filesystem::path(arguments.plot).extension();
    const std::string bytes =
        extension == ".html"
            ? roc_page(report, json.dump(2))
            : report::render(roc_plot(report), extension == ".svg" ? report::Image::svg : report::Image::png);
    io::write_file(arguments.plot, bytes, {.overwrite = arguments.files.overwrite});
    output.say(fmt::format("Wrote the plot to {}.", arguments.plot));
}

std::string text_of(const AnalysisReport& report) {
    std::string text;
    if (!report.mesh.empty())
        text = report::to_text(mesh_table(report));
    for (const RocTable& table : roc_tables(report)) {
        if (!table.heading.empty())
            text += fmt::format("\n{}\n", table.heading);
        text += report::to_text(table.table);
    }
    return text;
}

void deliver(const AnalyzeArguments& arguments, const AnalysisReport& report, ordered_json json,
             Output& output) {
    add_json(json, report);
    write_plot(arguments, report, json, output);
    output.print(arguments.csv ? report::to_csv(long_table(report)) : text_of(report));
    output.print_json(json);
}

AnalysisReport analyze_model(const AnalyzeArguments& arguments) {
    AnalysisReport report;
    report.title =
        fmt::format("ROC curves of eq. (5) for \u03c3\u1d63\u00b2 = {:g} and \u0394 in [\u2212{:g}, {:g}]",
                    arguments.sigma_r2, arguments.delta_range, arguments.delta_range);
    const std::vector<double> pf = probabilities_of(arguments);
    for (double gamma : parse_numbers(arguments.gamma, "--gamma", positive_numbers("0.1")))
        for (std::size_t n : parse_counts(arguments.vertices, "--vertices", 1))
            report.predicted.push_back(
                study::paper_roc({arguments.sigma_r2, arguments.delta_range}, gamma, n, pf));
    return report;
}

// With a mesh

/// A key's parameters, or those of a new key.
key::PublicParameters parameters_of(const std::optional<key::Key>& key) {
    return key ? key->parameters() : key::PublicParameters{};
}

study::TrialSetting setting_of(const AnalyzeArguments& arguments, const TriangleMesh& mesh,
                               const std::optional<key::Key>& key, std::size_t vertices) {
    study::TrialSetting setting;
    setting.profile = arguments.profile;
    setting.sizing = arguments.strength.empty() ? study::Sizing::visibility : study::Sizing::strength;
    if (arguments.recommend)
        setting.sizing = study::best_sizing(arguments.profile);
    setting.vertices = vertices;
    setting.parameters = parameters_of(key);
    setting.level = arguments.level.value_or(
        watermark::default_level(setting.parameters, mesh.positions.size(), arguments.profile));
    return setting;
}

/// The one damage that --attack names, if it does.
study::NamedDamage damage_of(const AnalyzeArguments& arguments) {
    if (arguments.attack.empty())
        return {"none", {}};
    std::vector<study::NamedDamage> damages = study::parse_damages(arguments.attack);
    if (damages.size() != 1)
        throw ParameterError(
            fmt::format("--attack: '{}' names {} attacks; join those that follow each other by '+'",
                        arguments.attack, damages.size()));
    return std::move(damages.front());
}

/// Numbers of base vertices to analyze; what wasn't asked for is made to fit the mesh.
std::vector<std::size_t> vertices_of(const AnalyzeArguments& arguments) {
    if (arguments.vertices.empty())
        return {watermark::default_vertices};
    return parse_counts(arguments.vertices, "--vertices", 4);
}

/// Sizes of marks, in the setting's sizing.
std::vector<double> sizes_of(const AnalyzeArguments& arguments) {
    if (!arguments.strength.empty())
        return parse_numbers(arguments.strength, "--strength", positive_numbers("0.05"));
    if (!arguments.visibility.empty())
        return parse_numbers(arguments.visibility, "--visibility", shares("0.1"));
    return {watermark::default_visibility};
}

void require_base(const AnalyzeArguments& arguments, const study::TrialBench& bench, std::size_t asked) {
    const std::size_t got = bench.base().size();
    if (!arguments.vertices.empty() && got < asked)
        throw ParameterError(
            fmt::format("{}: the mesh has {} vertices, too few for a base domain of {}; ask for "
                        "--vertices {} or fewer",
                        display_name(arguments.files.input), got, asked, got));
}

/// All trials of one bench and size: those in the log, and the rest, which go there.
std::vector<study::Trial> trials_of(const AnalyzeArguments& arguments, const study::TrialBench& bench,
                                    double size, const std::string& damage, study::TrialLog* log,
                                    const Progress& progress) {
    const study::TrialSetting& setting = bench.setting();
    const std::string name =
        fmt::format("profile {} {} {} vertices {} level {} rmax {} damage {} seed {}",
                    watermark::name(setting.profile), study::name(setting.sizing), size, setting.vertices,
                    setting.level, setting.parameters.rmax, damage, arguments.seed);
    std::map<std::size_t, study::Trial> done;
    if (log != nullptr)
        done = log->trials(name);
    std::vector<std::size_t> missing;
    for (std::size_t number = 0; number < arguments.trials; ++number)
        if (!done.contains(number))
            missing.push_back(number);
    const auto keep = [&](const study::Trial& trial) {
        if (log != nullptr)
            log->append(name, trial);
    };
    for (study::Trial& trial : study::run_trials(bench, size, arguments.seed, missing, keep, progress))
        done[trial.number] = std::move(trial);
    std::vector<study::Trial> trials;
    for (std::size_t number = 0; number < arguments.trials; ++number)
        trials.push_back(std::move(done[number]));
    return trials;
}

void measure(const AnalyzeArguments& arguments, const study::TrialBench& bench, double size,
             const std::string& damage, study::TrialLog* log, AnalysisReport& report, Output& output) {
    const std::vector<study::Trial> trials =
        trials_of(arguments, bench, size, damage, log, output.progress());
    for (study::RocKind kind : study::detectors_for(arguments.profile))
        report.measured.push_back(
            study::measured_roc(kind, trials, bench, size, probabilities_of(arguments)));
}

AnalysisReport analyze_mesh(const AnalyzeArguments& arguments, const TriangleMesh& mesh,
                            const std::optional<key::Key>& key, Output& output) {
    const std::vector<double> pf = probabilities_of(arguments), sizes = sizes_of(arguments);
    const study::NamedDamage damage = damage_of(arguments);
    std::unique_ptr<study::TrialLog> log;
    if (!arguments.resume.empty())
        log = std::make_unique<study::TrialLog>(arguments.resume, study::mesh_fingerprint(mesh));
    AnalysisReport report;
    report.title = fmt::format("ROC curves of {}{}",
                               std::filesystem::path(display_name(arguments.files.input)).filename().string(),
                               damage.damage ? " after " + damage.name : "");
    for (std::size_t n : vertices_of(arguments)) {
        study::TrialSetting setting = setting_of(arguments, mesh, key, n);
        setting.damage = damage.damage;
        const study::TrialBench bench(mesh, std::move(setting), output.progress());
        require_base(arguments, bench, n);
        report.mesh.push_back(
            study::mesh_statistics(bench, key ? key->secret() : key::null_secret(arguments.seed, 0)));
        for (double size : sizes) {
            std::vector<study::RocCurve> curves = study::predicted_rocs(bench, report.mesh.back(), size, pf,
                                                                        arguments.pilots, output.progress());
            std::ranges::move(curves, std::back_inserter(report.predicted));
            if (arguments.trials > 0)
                measure(arguments, bench, size, damage.name, log.get(), report, output);
        }
    }
    return report;
}

// --recommend

study::Requirement requirement_of(const AnalyzeArguments& arguments) {
    study::Requirement requirement;
    if (!arguments.pf.empty()) {
        const std::vector<double> pf = parse_numbers(arguments.pf, "--pf", probabilities());
        if (pf.size() != 1)
            throw ParameterError("--recommend takes one --pf: the false-positive probability of the verdict");
        requirement.pf = pf.front();
    }
    requirement.pm = arguments.pm;
    requirement.pilots = std::max<std::size_t>(arguments.pilots / 2, 2);
    if (!arguments.survive.empty())
        requirement.survive = study::parse_damages(arguments.survive);
    return requirement;
}

ordered_json to_json(const study::Recommendation& advice, const study::Requirement& requirement) {
    ordered_json outcomes = ordered_json::array();
    for (const study::Outcome& outcome : advice.outcomes)
        outcomes.push_back({{"attack", outcome.damage},
                            {"pm", std::pow(10, outcome.log10_pm)},
                            {"log10_pm", outcome.log10_pm}});
    ordered_json json{{"reached", advice.reached}, {"pf", requirement.pf}, {"pm", requirement.pm}};
    if (advice.sizing == study::Sizing::visibility)
        json["visibility"] = advice.size;
    json.update({{"strength_percent",
                  advice.sizing == study::Sizing::strength ? advice.size : advice.distortion.normal_rms},
                 {"gamma", advice.gamma},
                 {"rms_percent", advice.distortion.normal_rms},
                 {"vertex_rms_percent", advice.distortion.vertex_rms},
                 {"max_percent", advice.distortion.max},
                 {"outcomes", outcomes}});
    return json;
}

/// The options of `mark` that make such marks.
std::string mark_options(const study::Recommendation& advice, watermark::Profile profile) {
    std::string options = fmt::format("--{} {:.4g}", study::name(advice.sizing), advice.size);
    if (profile != watermark::Profile::masked)
        options += fmt::format(" --profile {}", watermark::name(profile));
    return options;
}

std::string sentence(const study::Recommendation& advice, const study::Requirement& requirement,
                     watermark::Profile profile) {
    if (!advice.reached)
        return fmt::format("No {} up to {} meets P_f = {:g} and P_m = {:g} on this mesh.\n",
                           study::name(advice.sizing), study::largest_size(advice.sizing), requirement.pf,
                           requirement.pm);
    return fmt::format("Mark with {}: at P_f = {:g} the mark is missed with probability {:g} at most.\n",
                       mark_options(advice, profile), requirement.pf, requirement.pm);
}

int recommend(const AnalyzeArguments& arguments, const TriangleMesh& mesh, const std::optional<key::Key>& key,
              Output& output) {
    const study::Requirement requirement = requirement_of(arguments);
    const std::vector<std::size_t> vertices = vertices_of(arguments);
    if (vertices.size() != 1)
        throw ParameterError("--recommend takes one number of --vertices");
    const study::Recommendation advice = study::recommend(
        mesh, setting_of(arguments, mesh, key, vertices.front()), requirement, output.progress());
    output.print(sentence(advice, requirement, arguments.profile));
    report::Table table{{"after", "log10 P_m"}, {}};
    for (const study::Outcome& outcome : advice.outcomes)
        table.rows.push_back({outcome.damage, fmt::format("{:.2f}", outcome.log10_pm)});
    output.print(fmt::format("move along the normals   {:.4f} % of the box's diagonal (root mean square)\n"
                             "move of the vertices     {:.4f} % (root mean square), {:.4f} % (largest)\n\n{}",
                             advice.distortion.normal_rms, advice.distortion.vertex_rms,
                             advice.distortion.max, report::to_text(table)));
    output.print_json({{"input", arguments.files.input}, {"recommended", to_json(advice, requirement)}});
    return advice.reached ? exit_done : exit_check_failed;
}

// Command line

/// Options that belong to one of the two uses only.
void require_consistent(const CLI::App& app, const AnalyzeArguments& arguments) {
    const bool mesh = !arguments.files.input.empty();
    for (const char* name : {"--sigma-r2", "--delta-range", "--gamma"})
        if (mesh && app.count(name) > 0)
            throw ParameterError(
                fmt::format("{} is for the model without a mesh; the mesh tells it itself, and "
                            "--visibility or --strength says how large the marks are",
                            name));
    for (const char* name : {"--sigma-r2", "--delta-range", "--gamma", "--vertices"})
        if (!mesh && app.count(name) == 0)
            throw ParameterError(
                fmt::format("without a mesh, {} is needed; the paper's figure 8 has --sigma-r2 0.032 "
                            "--delta-range 0.1 with lists of --gamma and --vertices",
                            name));
    for (const char* name : {"--visibility", "--strength", "--profile", "--key", "--level", "--attack",
                             "--trials", "--resume", "--recommend"})
        if (!mesh && app.count(name) > 0)
            throw ParameterError(fmt::format("{} needs a mesh; name its file", name));
    if (app.count("--pf") > 0 && arguments.pf.empty())
        throw ParameterError("--pf: the list is empty; give numbers joined by commas");
    if (arguments.csv && (arguments.recommend || app.count("--json") > 0))
        throw ParameterError("--csv is for curves on standard output; leave out --json and --recommend");
}

int run(const CLI::App& app, const AnalyzeArguments& arguments, Output& output) {
    require_consistent(app, arguments);
    check_plot(arguments);
    probabilities_of(arguments); // before any file is opened
    if (arguments.files.input.empty()) {
        deliver(arguments, analyze_model(arguments), {}, output);
        return exit_done;
    }
    std::optional<key::Key> key;
    if (!arguments.key.empty())
        key = load_key(arguments.key, output);
    const io::Model model = read_input(arguments.files);
    if (arguments.recommend)
        return recommend(arguments, model.mesh(), key, output);
    deliver(arguments, analyze_mesh(arguments, model.mesh(), key, output), {{"input", arguments.files.input}},
            output);
    return exit_done;
}

void add_mesh_options(CLI::App& app, AnalyzeArguments& arguments) {
    add_input(app, arguments.files);
    app.get_option("IN")->required(false);
    app.add_option("--key", arguments.key, "Take levels, rmax and Delta from this key")
        ->option_text("FILE")
        ->group("With a mesh");
    auto* visibility = app.add_option("--visibility", arguments.visibility,
                                      "Sizes of the marks: one-sided MSDM2 that they keep to [0.1]");
    visibility->option_text("LIST")->group("With a mesh");
    app.add_option("--strength", arguments.strength,
                   "Sizes instead: root mean square move along the normals, in % of the box's diagonal")
        ->option_text("LIST")
        ->excludes(visibility)
        ->group("With a mesh");
    add_profile(app, arguments.profile)->group("With a mesh");
    app.add_option("--level", arguments.level, "Subdivisions of the watermarking sphere [5]")
        ->option_text("L")
        ->check(whole_number_between(0, sphere::max_level))
        ->group("With a mesh");
    app.add_option("--attack", arguments.attack, "What happens to the marked mesh, as `wm3d attack` names it")
        ->option_text("ATTACK")
        ->group("With a mesh");
    app.add_option("--pilots", arguments.pilots, "Marks that a prediction tries [24]")
        ->option_text("N")
        ->check(whole_number_between(2, 100'000))
        ->group("With a mesh");
    app.add_option("--trials", arguments.trials, "Measure: count misses of N marks with random keys")
        ->option_text("N")
        ->check(whole_number_between(1, 100'000'000))
        ->group("With a mesh");
    app.add_option("--seed", arguments.seed, "Which random keys [1]")->option_text("S")->group("With a mesh");
    app.add_option("--resume", arguments.resume,
                   "Keep every trial in FILE, and go on with those that are there")
        ->option_text("FILE")
        ->group("With a mesh");
    app.add_flag("--recommend", arguments.recommend,
                 "Find the least visible mark that meets --pf and --pm; with --profile robust or paper the "
                 "smallest strength")
        ->group("With a mesh");
    app.add_option("--pm", arguments.pm, "Miss probability to recommend for [1e-6]")
        ->option_text("P")
        ->check(probability())
        ->group("With a mesh");
    app.add_option("--survive", arguments.survive, "Attacks that the recommended mark survives, each alone")
        ->option_text("LIST")
        ->group("With a mesh");
}

void add_options(CLI::App& app, AnalyzeArguments& arguments) {
    auto* pf = app.add_option("--pf", arguments.pf, "False-positive probabilities, joined by commas");
    pf->option_text("LIST");
    app.add_option("--pf-range", arguments.pf_range, "The same as a range at equal ratios [1e-12:0.5:50]")
        ->option_text("LOW:HIGH:COUNT")
        ->excludes(pf);
    app.add_option("--vertices", arguments.vertices, "Numbers n of base vertices [20000]")
        ->option_text("LIST");
    app.add_flag("--csv", arguments.csv, "Comma-separated values on standard output");
    app.add_option("--plot", arguments.plot, "Draw the curves: FILE.svg, .png or .html (by gnuplot)")
        ->option_text("FILE");
    app.add_flag("--overwrite", arguments.files.overwrite, "Replace a plot that exists");
    app.add_option("--sigma-r2", arguments.sigma_r2, "Variance of the radii")
        ->option_text("V")
        ->check(positive_number())
        ->group("Without a mesh");
    app.add_option("--delta-range", arguments.delta_range, "Delta is uniform in [-D, D]")
        ->option_text("D")
        ->check(positive_number())
        ->group("Without a mesh");
    app.add_option("--gamma", arguments.gamma, "Strengths gamma of eq. (3)")
        ->option_text("LIST")
        ->group("Without a mesh");
    add_mesh_options(app, arguments);
}

} // namespace

Action declare_analyze(CLI::App& app) {
    const auto arguments = std::make_shared<AnalyzeArguments>();
    app.description(
        "Says how sure an owner can be: the miss probability P_m over the false-positive probability P_f.\n"
        "Without a mesh, that of the paper's model, eq. (5) and (6). With a mesh, that of the marks which\n"
        "`mark` makes there: predicted, and measured with --trials. With --profile paper, also what the\n"
        "paper's detector truly does.");
    add_options(app, *arguments);
    app.footer(
        "Examples:\n"
        "  wm3d analyze --sigma-r2 0.032 --delta-range 0.1 --gamma 0.1,0.2 --vertices 2500,10000\n"
        "  wm3d analyze scan.ply --visibility 0.02,0.1 --trials 200 --resume scan.trials --plot roc.html\n"
        "  wm3d analyze scan.ply --recommend --pf 1e-9 --pm 1e-6 --survive noise:0.3,simplify:90");
    return [arguments, &app](Output& output) { return run(app, *arguments, output); };
}

} // namespace wm3d::cmd
