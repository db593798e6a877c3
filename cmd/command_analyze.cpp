// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_analyze.hpp"

#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/mesh/error.hpp>

#include "analysis_report.hpp"
#include "pipeline/paper_roc.hpp"
#include "support/mesh_files.hpp"
#include "support/number_list.hpp"
#include "support/usage.hpp"

namespace wm3d::cmd {

namespace {

using nlohmann::ordered_json;

struct AnalyzeArguments {
    MeshFiles files;
    std::string pf, pf_range, gamma, vertices;
    double sigma_r2 = 0, delta_range = 0;
    bool csv = false;
    std::string plot;
};

std::vector<double> probabilities_of(const AnalyzeArguments& arguments) {
    if (!arguments.pf.empty())
        return parse_numbers(arguments.pf, "--pf", probabilities());
    return parse_log_range(arguments.pf_range, "--pf-range", probabilities());
}

void write_plot(const AnalyzeArguments& arguments, const AnalysisReport& report, const ordered_json& json) {
    const std::string extension = std::filesystem::path(arguments.plot).extension();
    const std::string bytes = extension == ".html" ? roc_page(report, json.dump(2))
                              : extension == ".svg"
                                  ? reporting::render(roc_plot(report), reporting::Image::svg)
                                  : reporting::render(roc_plot(report), reporting::Image::png);
    io::write_file(arguments.plot, bytes, {.overwrite = arguments.files.overwrite});
}

void check_plot(const AnalyzeArguments& arguments) {
    if (arguments.plot.empty())
        return;
    const std::string extension = std::filesystem::path(arguments.plot).extension();
    if (extension != ".svg" && extension != ".png" && extension != ".html")
        throw ParameterError(fmt::format("{}: a plot is .svg, .png or .html; name it so", arguments.plot));
    check_target(arguments.plot, arguments.files.overwrite);
}

void deliver(const AnalyzeArguments& arguments, const AnalysisReport& report, Output& output) {
    ordered_json json;
    add_json(json, report);
    if (!arguments.plot.empty()) {
        write_plot(arguments, report, json);
        output.say(fmt::format("Wrote the plot to {}.", arguments.plot));
    }
    if (arguments.csv)
        output.print(reporting::to_csv(long_table(report)));
    else
        output.print((report.mesh.empty() ? "" : reporting::to_text(mesh_table(report)) + "\n") +
                     reporting::to_text(roc_table(report)));
    output.print_json(json);
}

AnalysisReport analyze_model(const AnalyzeArguments& arguments) {
    AnalysisReport report;
    report.title =
        fmt::format("ROC curves of eq. (5) for \u03c3_r\u00b2 = {:g} and \u0394 in [\u2212{:g}, {:g}]",
                    arguments.sigma_r2, arguments.delta_range, arguments.delta_range);
    const std::vector<double> pf = probabilities_of(arguments);
    for (double gamma : parse_numbers(arguments.gamma, "--gamma", positive_numbers("0.1")))
        for (std::size_t n : parse_counts(arguments.vertices, "--vertices", 1))
            report.predicted.push_back(
                pipeline::paper_roc({arguments.sigma_r2, arguments.delta_range}, gamma, n, pf));
    return report;
}

void require_model(const CLI::App& app) {
    for (const char* name : {"--sigma-r2", "--delta-range", "--gamma", "--vertices"})
        if (app.count(name) == 0)
            throw ParameterError(
                fmt::format("without a mesh, {} is needed; the paper's figure 8 has --sigma-r2 0.032 "
                            "--delta-range 0.1 with lists of --gamma and --vertices",
                            name));
}

void add_options(CLI::App& app, AnalyzeArguments& arguments) {
    auto* pf = app.add_option("--pf", arguments.pf, "False-positive probabilities, joined by commas");
    pf->option_text("LIST");
    app.add_option("--pf-range", arguments.pf_range, "The same as a range at equal ratios [1e-12:0.5:50]")
        ->option_text("LOW:HIGH:COUNT")
        ->excludes(pf);
    app.add_option("--gamma", arguments.gamma, "Strengths gamma of eq. (3)")->option_text("LIST");
    app.add_option("--vertices", arguments.vertices, "Numbers n of base vertices")->option_text("LIST");
    app.add_option("--sigma-r2", arguments.sigma_r2, "Without a mesh: variance of the radii")
        ->option_text("V")
        ->check(positive_number());
    app.add_option("--delta-range", arguments.delta_range, "Without a mesh: Delta is uniform in [-D, D]")
        ->option_text("D")
        ->check(positive_number());
    app.add_flag("--csv", arguments.csv, "Comma-separated values on standard output");
    app.add_option("--plot", arguments.plot, "Draw the curves: FILE.svg, .png or .html (by gnuplot)")
        ->option_text("FILE");
    app.add_flag("--overwrite", arguments.files.overwrite, "Replace a plot that exists");
}

} // namespace

Action declare_analyze(CLI::App& app) {
    const auto arguments = std::make_shared<AnalyzeArguments>();
    arguments->pf_range = "1e-12:0.5:50";
    app.description(
        "Says how sure an owner can be: the miss probability P_m over the false-positive probability P_f\n"
        "of the paper's model, eq. (5) and (6).");
    add_options(app, *arguments);
    app.footer(
        "Examples:\n"
        "  wm3d analyze --sigma-r2 0.032 --delta-range 0.1 --gamma 0.1,0.2 --vertices 2500,10000\n"
        "  wm3d analyze --sigma-r2 0.032 --delta-range 0.1 --gamma 0.1 --vertices 10000 --plot roc.html");
    return [arguments, &app](Output& output) {
        if (arguments->csv && output.json())
            throw ParameterError("--csv and --json both want standard output; choose one");
        check_plot(*arguments);
        require_model(app);
        deliver(*arguments, analyze_model(*arguments), output);
        return static_cast<int>(exit_done);
    };
}

} // namespace wm3d::cmd
