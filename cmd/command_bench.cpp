// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_bench.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <wm3d/core/error.hpp>
#include <wm3d/core/version.hpp>
#include <wm3d/report/render.hpp>
#include <wm3d/resync/registration.hpp>
#include <wm3d/study/bench_log.hpp>
#include <wm3d/study/damage.hpp>
#include <wm3d/study/trial_log.hpp>

#include "bench_heat_map.hpp"
#include "bench_summary.hpp"
#include "support/mesh_files.hpp"
#include "support/number_list.hpp"
#include "support/usage.hpp"

namespace wm3d::cmd {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct BenchArguments {
    std::vector<std::string> models;
    std::string out;
    std::string strengths, mrms, visibility, attacks;
    std::string pf = "1e-9";
    std::optional<watermark::Profile> profile; ///< if not given, that which suits the sizes
    study::BenchSetting setting;
};

// What is asked for

/// The option that gives the sizes, without its hyphens, the unit it counts in, and its list.
struct SizeOption {
    std::string_view name;
    study::MarkSize::Unit unit;
    const std::string& list;
};

SizeOption size_option(const BenchArguments& arguments) {
    using Unit = study::MarkSize::Unit;
    if (!arguments.mrms.empty())
        return {"mrms", Unit::mrms, arguments.mrms};
    if (!arguments.visibility.empty())
        return {"visibility", Unit::visibility, arguments.visibility};
    return {"strengths", Unit::strength, arguments.strengths};
}

std::vector<study::MarkSize> sizes_of(const BenchArguments& arguments) {
    const SizeOption option = size_option(arguments);
    std::vector<study::MarkSize> sizes;
    for (double value :
         parse_numbers(option.list, fmt::format("--{}", option.name), positive_numbers("0.02"))) {
        const study::MarkSize size{option.unit, value};
        if (option.unit == study::MarkSize::Unit::visibility && value > 1)
            throw ParameterError(
                fmt::format("--visibility: {} is no MSDM2, which lies above 0 and up to 1", value));
        if (std::ranges::find(sizes, size) != sizes.end())
            throw ParameterError(fmt::format("--{}: {} is named twice; name it once", option.name, value));
        sizes.push_back(size);
    }
    return sizes;
}

/// One for each size; one probability goes for all of them.
std::vector<double> log10_targets_of(const BenchArguments& arguments, std::size_t sizes) {
    std::vector<double> targets;
    for (double pf : parse_numbers(arguments.pf, "--pf", probabilities()))
        targets.push_back(std::log10(pf));
    if (targets.size() == 1)
        targets.resize(sizes, targets.front());
    if (targets.size() != sizes)
        throw ParameterError(
            fmt::format("--pf: there are {} probabilities for {} sizes of marks; give one, or one for "
                        "each size",
                        targets.size(), sizes));
    return targets;
}

std::vector<study::AttackChain> attacks_of(const BenchArguments& arguments) {
    if (arguments.attacks.empty())
        return study::default_attacks();
    std::vector<study::AttackChain> chains;
    for (const study::NamedDamage& damage : study::parse_damages(arguments.attacks))
        if (study::AttackChain chain = attack::parse_chain(damage.name);
            std::ranges::find(chains, chain) == chains.end())
            chains.push_back(std::move(chain));
    for (const study::AttackChain& chain : chains)
        for (const attack::AttackSpec& spec : chain)
            if (!std::ranges::find(attack::known_attacks(), spec.name, &attack::AttackInfo::name)->available)
                throw ParameterError(
                    fmt::format("--attacks: this build has no attack {}, which needs OpenVDB; leave "
                                "it out, or build with it",
                                spec.name));
    return chains;
}

std::string name_of(watermark::Profile profile) {
    return std::string(watermark::name(profile));
}

/// Everything that the results depend on, besides models, keys and attacks, of which more may be added.
ordered_json settings_of(const study::BenchSetting& setting) {
    ordered_json sizes = ordered_json::array();
    for (const study::MarkSize& size : setting.sizes)
        sizes.push_back(study::to_string(size));
    return {{"version", std::string(version())},
            {"seed", setting.seed},
            {"sizes", sizes},
            {"wrong_keys", setting.wrong_keys},
            {"effort", setting.search_effort},
            {"vertices", setting.vertices},
            {"profile", name_of(setting.profile)},
            {"payload", setting.payload > 0 ? ordered_json(setting.payload) : ordered_json()},
            {"levels", setting.parameters.levels},
            {"rmax", setting.parameters.rmax}};
}

// Files

/// Mesh files of a folder, by their names' endings.
std::vector<fs::path> files_of(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file() && io::format_of_name(entry.path().string()))
            files.push_back(entry.path());
    return files;
}

/// The models in the order of their names, which tell them apart.
std::vector<fs::path> models_of(const BenchArguments& arguments) {
    std::vector<fs::path> files;
    for (const std::string& name : arguments.models) {
        std::error_code ignored;
        if (fs::is_directory(name, ignored)) {
            const std::vector<fs::path> found = files_of(name);
            if (found.empty())
                throw InputError(
                    fmt::format("{}: there is no mesh in this folder; its files would end in .obj, .ply, "
                                ".stl, .off, .gltf or .glb",
                                name));
            files.insert(files.end(), found.begin(), found.end());
        } else if (fs::exists(name, ignored)) {
            files.emplace_back(name);
        } else {
            throw InputError(fmt::format("{}: there is no such file or folder; name one with meshes", name));
        }
    }
    std::ranges::sort(files, {}, [](const fs::path& path) { return path.filename(); });
    const auto twice =
        std::ranges::adjacent_find(files, {}, [](const fs::path& path) { return path.filename(); });
    if (twice != files.end())
        throw InputError(
            fmt::format("{} and {} have the same name, so their results could not be told apart; rename "
                        "one",
                        twice->string(), std::next(twice)->string()));
    return files;
}

void make_folder(const std::string& out) {
    std::error_code error;
    if (fs::exists(out, error) && !fs::is_directory(out, error))
        throw OutputError(fmt::format("{}: this is a file; name a folder", out));
    fs::create_directories(out, error);
    if (error)
        throw OutputError(fmt::format("{}: the folder can't be made: {}", out, error.message()));
}

void write_result(const BenchArguments& arguments, const char* name, const std::string& bytes) {
    io::write_file((fs::path(arguments.out) / name).string(), bytes, {.overwrite = true});
}

// The run

/// Tells how many items are done and how long the others will take.
class Countdown {
public:
    Countdown(std::size_t items, Progress progress)
        : left_(items), progress_(std::move(progress)), begin_(std::chrono::steady_clock::now()) {}

    void tick() {
        --left_;
        ++done_;
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin_;
        const double seconds = spent.count() / static_cast<double>(done_) * static_cast<double>(left_);
        notify(progress_,
               fmt::format("{} of {} items, {} left", done_, done_ + left_, duration_text(seconds)),
               static_cast<double>(done_) / static_cast<double>(done_ + left_));
    }

    void skip(std::size_t items) { left_ -= items; }

private:
    static std::string duration_text(double seconds) {
        if (seconds < 90)
            return fmt::format("{:.0f} s", seconds);
        return seconds < 5400 ? fmt::format("{:.0f} min", seconds / 60)
                              : fmt::format("{:.1f} h", seconds / 3600);
    }

    std::size_t left_, done_ = 0;
    Progress progress_;
    std::chrono::steady_clock::time_point begin_;
};

/// The mesh of a file, or why there is none.
std::optional<io::Model> read_model(const fs::path& path, study::BenchModel& model) {
    try {
        io::Model file = read_mesh(path.string());
        const TriangleMesh& mesh = file.mesh();
        model = {study::mesh_fingerprint(mesh), mesh.positions.size(), mesh.triangles.size(), ""};
        return file;
    } catch (const Error& error) {
        model.error = error.what();
        return {};
    }
}

/// One model from its file to its last item.
/// \return whether anything could be done with it
bool run_model(const fs::path& path, const study::BenchSetting& setting, study::BenchLog& log,
               Countdown& countdown, Output& output) {
    const std::string name = path.filename().string();
    const study::BenchWork work = study::missing_work(name, setting, log.results());
    study::BenchModel model;
    const std::optional<io::Model> file = read_model(path, model);
    log.add(name, model);
    output.detail(fmt::format("{}: {} items to do", name, work.items.size()));
    if (file) {
        try {
            study::run_bench(
                file->mesh(), setting, work, log, [&] { countdown.tick(); }, output.progress());
            return true;
        } catch (const GeometryError& error) {
            model.error = fmt::format("{}: {}", path.string(), error.what());
            log.add(name, model);
        }
    }
    output.warn(model.error);
    countdown.skip(work.items.size());
    return false;
}

std::size_t items_left(const std::vector<fs::path>& models, const study::BenchSetting& setting,
                       const study::BenchResults& done) {
    std::size_t items = 0;
    for (const fs::path& path : models)
        items += study::missing_work(path.filename().string(), setting, done).items.size();
    return items;
}

std::string command_line(const BenchArguments& arguments) {
    const SizeOption sizes = size_option(arguments);
    std::string text = fmt::format("wm3d bench --models {} --out {} --{} {} --pf {} --keys {}",
                                   fmt::join(arguments.models, " "), arguments.out, sizes.name, sizes.list,
                                   arguments.pf, arguments.setting.keys);
    if (!arguments.attacks.empty())
        text += " --attacks " + arguments.attacks;
    if (arguments.setting.vertices != watermark::default_vertices)
        text += fmt::format(" --vertices {}", arguments.setting.vertices);
    if (arguments.profile)
        text += " --profile " + name_of(*arguments.profile);
    if (arguments.setting.search_effort != study::BenchSetting{}.search_effort)
        text += fmt::format(" --effort {}", arguments.setting.search_effort);
    if (arguments.setting.payload > 0)
        text += fmt::format(" --payload {}", arguments.setting.payload);
    if (arguments.setting.assisted)
        text += " --reference";
    return text +
           fmt::format(" --wrong-keys {} --seed {}", arguments.setting.wrong_keys, arguments.setting.seed);
}

/// Draws the heat map as SVG and PNG.
/// \return whether gnuplot is there to do it
bool draw_heat_map(const BenchArguments& arguments, const BenchSummary& summary, Output& output) {
    if (!report::can_render()) {
        output.warn(
            "there is no heat map, which gnuplot would draw; install it, for example with 'apt-get install "
            "gnuplot-nox', and run the same command again");
        return false;
    }
    const report::HeatMap map = bench_heat_map(summary.tables);
    write_result(arguments, "summary.svg", report::render(map, report::Image::svg));
    write_result(arguments, "summary.png", report::render(map, report::Image::png));
    return true;
}

ordered_json to_json(const study::BenchTable& table) {
    ordered_json json{{"size", study::to_string(table.size)},
                      {"log10_target", table.log10_target},
                      {"cells", table.filled()},
                      {"missed", table.missed()}};
    if (const PayloadCount count = count_payloads(table); count.keys > 0)
        json["payloads"] = {{"bits", count.bits},           {"keys", count.keys},
                            {"read", count.read},           {"wrong", count.wrong},
                            {"published", count.published}, {"as_published", count.as_published}};
    return json;
}

ordered_json to_json(const study::WrongKeys& wrong) {
    ordered_json counts = ordered_json::array();
    for (const study::WrongKeyCount& count : wrong.counts)
        counts.push_back({{"pf", count.pf},
                          {"found", count.family},
                          {"p_found", count.family_excess},
                          {"found_in_one", count.one},
                          {"p_found_in_one", count.one_strays}});
    return {{"keys", wrong.keys}, {"counts", counts}, {"p_uniformity", wrong.uniformity}};
}

void deliver(const BenchArguments& arguments, BenchSummary summary, const study::BenchResults& results,
             Output& output) {
    if (draw_heat_map(arguments, summary, output))
        summary.heat_map = "summary.svg";
    write_result(arguments, "summary.md", bench_markdown(summary));
    write_result(arguments, "summary.csv", bench_csv(results));
    ordered_json tables = ordered_json::array();
    for (const study::BenchTable& table : summary.tables) {
        output.print(fmt::format("{}: {} of {} cells reach log10 p = {:.4g} with every key\n",
                                 size_text(table.size), table.filled() - table.missed(), table.filled(),
                                 table.log10_target));
        if (const PayloadCount count = count_payloads(table); count.keys > 0)
            output.print(fmt::format("{}: {} of {} payloads of {} bits are decoded without error, {} give "
                                     "another; {} of {} cells do as well as "
                                     "published marks\n",
                                     size_text(table.size), count.read, count.keys, count.bits, count.wrong,
                                     count.as_published, count.published));
        tables.push_back(to_json(table));
    }
    output.say(fmt::format("Wrote the summary to {}.", (fs::path(arguments.out) / "summary.md").string()));
    output.print_json({{"out", arguments.out},
                       {"items", results.items.size()},
                       {"tables", tables},
                       {"wrong_keys", to_json(summary.wrong)},
                       {"not_examined", summary.unusable}});
}

int run(BenchArguments arguments, Output& output) {
    arguments.setting.profile = arguments.profile.value_or(
        arguments.visibility.empty() ? watermark::Profile::robust : watermark::Profile::masked);
    study::BenchSetting& setting = arguments.setting;
    setting.sizes = sizes_of(arguments);
    setting.attacks = attacks_of(arguments);
    const std::vector<double> targets = log10_targets_of(arguments, setting.sizes.size());
    if (setting.assisted && !resync::has_registration())
        throw ParameterError("--reference: this build was made without Ceres and can't align; build it with "
                             "-DWM3D_RESYNC=ON",
                             ErrorCode::missing_feature);
    const std::vector<fs::path> models = models_of(arguments);
    make_folder(arguments.out);
    study::BenchLog log((fs::path(arguments.out) / "items.jsonl").string(), settings_of(setting));
    log.add_command(command_line(arguments));
    Countdown countdown(items_left(models, setting, log.results()), output.progress());
    std::size_t readable = 0;
    for (const fs::path& path : models)
        readable += run_model(path, setting, log, countdown, output);
    if (readable == 0)
        throw InputError("none of the models can be examined; the warnings say why");
    BenchSummary summary = summarize(log.results(), setting, targets);
    summary.version = version();
    deliver(arguments, summary, log.results(), output);
    return exit_done;
}

void add_options(CLI::App& app, BenchArguments& arguments) {
    app.add_option("--models", arguments.models, "Folder of meshes, or mesh files")
        ->option_text("PATH... (required)")
        ->required();
    app.add_option("--out", arguments.out,
                   "Folder for results and summary; work that is there is not repeated")
        ->option_text("DIR (required)")
        ->required();
    auto* strengths = app.add_option("--strengths", arguments.strengths,
                                     "Strengths of the marks, as `mark --strength` [0.019,0.075]");
    strengths->option_text("LIST");
    auto* mrms = app.add_option("--mrms", arguments.mrms,
                                "Instead, the largest MRMS that marks may reach, % of the diagonal");
    mrms->option_text("LIST")->excludes(strengths);
    app.add_option("--visibility", arguments.visibility,
                   "Instead, the largest one-sided MSDM2 that marks may reach, as `mark --visibility`")
        ->option_text("LIST")
        ->excludes(strengths)
        ->excludes(mrms);
    app.add_option("--keys", arguments.setting.keys, "Random keys, each marking every model [5]")
        ->option_text("N")
        ->check(whole_number_between(1, 1'000'000));
    app.add_option("--attacks", arguments.attacks,
                   "Attacks joined by commas, as `wm3d attack` names them [the published benchmark and more]")
        ->option_text("LIST");
    app.add_option("--pf", arguments.pf,
                   "Probability that p is to reach: one, or one for each size of marks [1e-9]")
        ->option_text("LIST");
    app.add_option("--wrong-keys", arguments.setting.wrong_keys,
                   "Wrong keys to try on every attacked copy [20]")
        ->option_text("N")
        ->check(whole_number_between(0, 1'000'000));
    app.add_option("--vertices", arguments.setting.vertices,
                   "Vertices of base domains, as of `mark` and `verify` [20000]")
        ->option_text("N")
        ->check(number_between(4, 1e8));
    app.add_option(
           "--profile", arguments.profile,
           "How marks are laid out, as of `mark`: masked, robust or paper [robust; with --visibility masked]")
        ->option_text("NAME")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, watermark::Profile>{{"masked", watermark::Profile::masked},
                                                      {"robust", watermark::Profile::robust},
                                                      {"paper", watermark::Profile::paper}}));
    app.add_option(
           "--effort", arguments.setting.search_effort,
           "Of the search in all poses where a quick look finds nothing, as of `verify`; 0: none [0.2]")
        ->option_text("E")
        ->check(number_between(0, 1000));
    app.add_option(
           "--payload", arguments.setting.payload,
           "Random payload of 32, 64 or 128 bits in every mark, its errors before and behind decoding [none]")
        ->option_text("BITS")
        ->check(CLI::IsMember({32, 64, 128}));
    app.add_flag("--reference", arguments.setting.assisted,
                 "Also examine with the unmarked original at hand");
    app.add_option("--seed", arguments.setting.seed, "Which random keys and attacks [1]")->option_text("S");
}

} // namespace

Action declare_bench(CLI::App& app) {
    const auto arguments = std::make_shared<BenchArguments>();
    arguments->strengths = "0.019,0.075";
    app.description(
        "Measures what marks survive: every model is marked with every key at every size, attacked in every\n"
        "way, then moved, turned and scaled at random, and examined blind as verify does.\n"
        "Leaves in --out the results (items.jsonl, a line each), a summary (summary.md, summary.csv) and a\n"
        "heat map (summary.svg, summary.png; by gnuplot). Stopped work goes on with the same command line.");
    add_options(app, *arguments);
    app.footer("Examples:\n  wm3d bench --models scans --out results\n"
               "  wm3d bench --models bunny.ply horse.ply --out results --mrms 0.02,0.08 --pf 1e-6,1e-9\n"
               "  wm3d bench --models scans --out quick --keys 1 --attacks "
               "noise:0.3,smoothing:30");
    return [arguments](Output& output) { return run(*arguments, output); };
}

} // namespace wm3d::cmd
