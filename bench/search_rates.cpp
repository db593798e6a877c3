// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  How often the search of all poses finds a mark: copies that were cut, put into a scene, mirrored or
/// deformed, and shapes without clear axes, all turned, scaled and shifted at random too.
/// Usage: search_rates FOLDER MINUTES [PREFIX]... makes the trials whose names begin so and that the folder
/// lacks, for so long; search_rates FOLDER prints the tables of all that are there. Planes, models and keys
/// take turns, so that whatever was made is a fair sample, until every plane has been tried with every key.
/// Models are looked for in WM3D_MESHES.

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include <fmt/format.h>

#include <wm3d/shapes/shapes.hpp>
#include <wm3d/shapes/turned.hpp>
#include <wm3d/watermark/mark.hpp>

#include "search_models.hpp"

namespace {

using namespace wm3d;
using namespace wm3d::bench;
namespace fs = std::filesystem;

constexpr std::size_t key_count = 3;
constexpr std::size_t plane_count = 10;

/// One copy to be found: which mark, what becomes of it, and how it is looked for.
struct Trial {
    std::string row; ///< of the tables
    std::string model;
    bool visible = false; ///< marked to a visibility of 0.10, else shaped at a strength of 0.08 %
    std::uint64_t seed = 0;
    std::function<TriangleMesh(const TriangleMesh& marked, std::uint64_t seed)> attack;
    bool mirrored = false; ///< and to be said so
    std::size_t turn = 0;  ///< of the keys

    /// What is done to which mark, whoever's it is.
    std::string cell() const {
        return fmt::format("{}/{}/{}/{}", visible ? "visibility" : "strength", row, model, seed);
    }
    std::string name() const { return turn == 0 ? cell() : fmt::format("{}/turn {}", cell(), turn); }
    std::size_t key() const { return (seed + turn) % key_count; }
};

struct Result {
    bool present = false;
    double log10_p = 0, seconds = 0;
    std::size_t centres = 0;
    double effort = 0; ///< the last that was tried
};

TriangleMesh model(const std::string& name) {
    if (name == "vase")
        return shapes::vase(30000);
    if (name == "gear")
        return shapes::gear(24, 30000);
    if (name == "disc")
        return shapes::disc(30000);
    return load(name);
}

std::vector<Trial> all_trials() {
    std::vector<Trial> trials;
    const auto attacked = [](const std::string& text) {
        return [text](const TriangleMesh& mesh, std::uint64_t seed) {
            return attack::apply(mesh, attack::parse_chain(text), seed);
        };
    };
    const auto scene = [](bool half) {
        return [half](const TriangleMesh& mesh, std::uint64_t seed) {
            const TriangleMesh part = half ? attack::apply(mesh, attack::parse("cropping:50"), seed) : mesh;
            return joined(part, load(scans[(seed + 1 + seed / scans.size() % 4) % scans.size()]), 3);
        };
    };
    for (std::uint64_t seed = 1; seed <= plane_count; ++seed)
        for (const bool visible : {false, true}) {
            for (const char* percent : {"10", "30", "50"})
                for (const std::string& name : scans)
                    trials.push_back({fmt::format("{} % cut away", percent), name, visible, seed,
                                      attacked(fmt::format("cropping:{}", percent))});
            const std::string& of_scene = scans[seed % scans.size()];
            trials.push_back({"in a scene", of_scene, visible, seed, scene(false)});
            trials.push_back({"half in a scene", of_scene, visible, seed, scene(true)});
            if (seed > key_count)
                continue;
            for (const char* text : {"scale:1.02,z=0.98", "bend:5"})
                trials.push_back({text, "igea.ply", visible, seed, attacked(text)});
            for (const char* name : {"vase", "gear", "disc"})
                trials.push_back({"turned", name, visible, seed, attacked("file")});
            for (const std::string& name : scans)
                trials.push_back({"mirrored", name, visible, seed,
                                  [](const TriangleMesh& m, std::uint64_t) { return mirrored(m); }, true});
        }
    const std::size_t of_a_turn = trials.size();
    for (std::size_t turn = 1; turn < key_count; ++turn)
        for (std::size_t i = 0; i < of_a_turn; ++i)
            trials.emplace_back(trials[i]).turn = turn;
    return trials;
}

/// The folder with its keys, marked copies, and results.
class Rates {
public:
    explicit Rates(fs::path folder) : folder_(std::move(folder)) {
        fs::create_directories(folder_);
        std::ifstream log(folder_ / "results.tsv");
        for (std::string line; std::getline(log, line);) {
            std::istringstream fields(line);
            std::string name;
            Result r;
            std::getline(fields, name, '\t');
            if (fields >> r.present >> r.log10_p >> r.seconds >> r.centres >> r.effort)
                results_[name] = r;
        }
    }

    /// The result so far, if there is one.
    const Result* result(const Trial& trial) const {
        const auto found = results_.find(trial.name());
        return found == results_.end() ? nullptr : &found->second;
    }
    void make(const Trial& trial, double effort);

private:
    key::Key key(std::size_t number) const;
    const TriangleMesh& marked(const Trial& trial);

    fs::path folder_;
    std::map<std::string, Result> results_;
    std::map<std::string, TriangleMesh> marked_; ///< in memory
};

key::Key Rates::key(std::size_t number) const {
    const fs::path path = folder_ / fmt::format("{}.key", number);
    if (!fs::exists(path))
        key::Key::generate("bench").save(path);
    return key::Key::load(path);
}

/// Positions are kept in the folder: marking takes longer than most searches.
const TriangleMesh& Rates::marked(const Trial& trial) {
    const std::string name = fmt::format("{}-{}-{}", trial.model, trial.visible ? "v" : "s", trial.key());
    const auto [entry, is_new] = marked_.try_emplace(name);
    if (!is_new)
        return entry->second;
    TriangleMesh& mesh = entry->second = model(trial.model);
    const auto size = static_cast<std::streamsize>(mesh.positions.size() * sizeof(Vec3));
    if (std::ifstream file(folder_ / (name + ".raw"), std::ios::binary);
        file.read(reinterpret_cast<char*>(mesh.positions.data()), size))
        return mesh;
    mesh = model(trial.model);
    watermark::MarkOptions options;
    if (!trial.visible) {
        options.profile = watermark::Profile::robust;
        options.strength = 0.08;
    }
    mesh.positions = watermark::mark(mesh, key(trial.key()), options).positions;
    std::ofstream(folder_ / (name + ".raw"), std::ios::binary)
        .write(reinterpret_cast<const char*>(mesh.positions.data()), size);
    return mesh;
}

void Rates::make(const Trial& trial, double effort) {
    const TriangleMesh copy = moved(trial.attack(marked(trial), trial.seed), trial.seed);
    watermark::VerifyOptions options;
    options.effort = effort;
    const Searched found = searched(copy, key(trial.key()), options);
    const auto& search = found.report.search;
    Result& result = results_[trial.name()];
    result.present = found.report.verdict == detect::Verdict::present &&
                     (!trial.mirrored || (search && search->pose && search->pose->mirrored));
    result.log10_p = found.report.score.log10_p;
    result.seconds = found.seconds;
    result.centres = search ? search->centres : 0;
    result.effort = effort;
    std::ofstream(folder_ / "results.tsv", std::ios::app)
        << fmt::format("{}\t{} {} {:.2f} {} {}\n", trial.name(), int(result.present), result.log10_p,
                       result.seconds, result.centres, effort);
}

/// Searches of the usual effort of all trials first; then longer ones of what they missed.
void make_trials(Rates& rates, const std::vector<std::string>& prefixes, double minutes) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(60 * minutes);
    for (const double effort : {1.0, 4.0})
        for (const Trial& trial : all_trials()) {
            if (std::ranges::none_of(prefixes,
                                     [&](const std::string& p) { return trial.name().starts_with(p); }))
                continue;
            const Result* known = rates.result(trial);
            if (known && (known->present || known->effort >= effort))
                continue;
            if (std::chrono::steady_clock::now() > end)
                return;
            rates.make(trial, effort);
        }
}

double middle(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// One row of a table.
struct Row {
    std::vector<Result> results;
    std::map<std::string, bool> cells; ///< whether every key that was tried is found in them
};

/// Rows of what was tried, all models together and each by itself.
void print_tables(const Rates& rates) {
    std::map<std::string, Row> rows;
    for (const Trial& trial : all_trials())
        if (const Result* result = rates.result(trial)) {
            const std::string mark = trial.visible ? "visibility 0.10" : "strength 0.08 %";
            for (const std::string& model : {std::string("all"), trial.model}) {
                Row& row = rows[fmt::format("{} | {} | {}", mark, trial.row, model)];
                row.results.push_back(*result);
                const auto entry = row.cells.try_emplace(trial.cell(), true).first;
                entry->second = entry->second && result->present;
            }
        }
    fmt::print(
        "| mark | copy | model | present at 1e-6 | with every key | median log10 p | worst | seconds of the "
        "processor, median | most | centres, median | most effort "
        "|\n|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const auto& [name, row] : rows) {
        const auto& [results, cells] = row;
        std::vector<double> p, seconds, centres, effort;
        for (const Result& r : results) {
            p.push_back(r.log10_p);
            seconds.push_back(r.seconds);
            centres.push_back(static_cast<double>(r.centres));
            effort.push_back(r.effort);
        }
        fmt::print("| {} | {} of {} | {} of {} | {:.0f} | {:.0f} | {:.1f} | {:.0f} | {:.0f} | {} |\n", name,
                   std::ranges::count(results, true, &Result::present), results.size(),
                   std::ranges::count(cells, true, &std::pair<const std::string, bool>::second), cells.size(),
                   middle(p), std::ranges::max(p), middle(seconds), std::ranges::max(seconds),
                   middle(centres), std::ranges::max(effort));
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        fmt::print(stderr, "usage: search_rates FOLDER [MINUTES [PREFIX]...]\n");
        return 2;
    }
    Rates rates(argv[1]);
    std::vector<std::string> prefixes(argv + std::min(argc, 3), argv + argc);
    if (prefixes.empty())
        prefixes.emplace_back();
    if (argc > 2)
        make_trials(rates, prefixes, std::atof(argv[2]));
    print_tables(rates);
}
