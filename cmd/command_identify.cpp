// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_identify.hpp"

#include <cmath>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <wm3d/core/error.hpp>
#include <wm3d/ledger.hpp>
#include <wm3d/watermark/identify.hpp>

#include "support/copies.hpp"
#include "support/key_files.hpp"
#include "support/mesh_files.hpp"
#include "support/probability_text.hpp"
#include "support/usage.hpp"

namespace wm3d::cmd {

namespace {

using detect::Verdict;
using nlohmann::ordered_json;

struct IdentifyArguments {
    MeshFiles files;
    std::string key;
    std::string ledger;
    std::string resync; ///< empty: pca, and a search where it is needed
    watermark::VerifyOptions options;
};

/// A copy that the suspect was made from.
struct Match {
    ledger::Entry entry;
    payload::Accusation accusation;
};

/// The copies of a ledger, in the order of their numbers, and what it knows of their works.
struct Copies {
    std::vector<watermark::IssuedCopy> issued;
    std::vector<std::int64_t> entry;
    std::vector<std::string> works; ///< of the receipts, those of the latest works first
    std::vector<resync::Receipt> receipts;
};

/// Receipts that are tried at an effort of 1, a second or two each. Where there are more works, the latest.
constexpr double receipts_at_usual_effort = 50;

Copies read_copies(const ledger::Ledger& book, const IdentifyArguments& arguments) {
    Copies copies;
    book.visit([&](const ledger::Entry& entry) {
        copies.issued.push_back(
            {payload::copy_number(entry.work, entry.recipient, entry.level), entry.level});
        copies.entry.push_back(entry.number);
    });
    const auto most = static_cast<std::size_t>(receipts_at_usual_effort * arguments.options.effort);
    if (!arguments.resync.empty()) // the poses were named
        return copies;
    for (const ledger::WorkReceipt& receipt : book.receipts()) {
        if (copies.receipts.size() == most)
            break;
        copies.receipts.push_back(
            resync::parse_receipt(receipt.text, arguments.ledger + ", receipt of work " + receipt.work));
        copies.works.push_back(receipt.work);
    }
    return copies;
}

std::vector<Match> matches_of(const watermark::IdentifyReport& report, const Copies& copies,
                              const ledger::Ledger& book) {
    std::vector<Match> matches;
    for (const payload::Accusation& accusation : report.accused)
        if (const auto entry = book.find(copies.entry[accusation.copy]))
            matches.push_back({*entry, accusation});
    return matches;
}

/// In a word or two.
std::string_view answer(const watermark::IdentifyReport& report) {
    if (!report.accused.empty())
        return "matched";
    switch (report.mark.verdict) {
    case Verdict::present:
        return "ours";
    case Verdict::absent:
        return "not ours";
    default:
        return "inconclusive";
    }
}

std::string sentence(const IdentifyArguments& arguments, const watermark::IdentifyReport& report,
                     const std::vector<Match>& matches, std::size_t copies, const std::string& key) {
    const std::string file = display_name(arguments.files.input);
    if (!matches.empty()) {
        std::vector<std::string> whose;
        for (const Match& match : matches)
            whose.push_back(fmt::format("that of '{}' for {} (entry {}, {})", match.entry.file,
                                        match.entry.recipient, match.entry.number,
                                        power_of_ten(match.accusation.log10_p)));
        return fmt::format(
            "matched: {} was made from {}: {}. In brackets the probability, at most, that any of the {} "
            "copies is named like this though it had no part in it.",
            file, matches.size() == 1 ? "one copy" : fmt::format("{} copies", matches.size()),
            fmt::join(whose, "; "), copies);
    }
    if (report.mark.verdict == Verdict::present)
        return fmt::format("ours, of none of these copies: {} carries the mark of {} (p = {}), but none of "
                           "the {} copies in {} shows in "
                           "it.",
                           file, key, power_of_ten(report.mark.score.log10_p), copies, arguments.ledger);
    return fmt::format(
        "{}: neither the mark of {} (p = {}) nor any of the {} copies in {} was found in {}{}",
        answer(report), key, power_of_ten(report.mark.score.log10_p), copies, arguments.ledger, file,
        report.mark.verdict == Verdict::absent
            ? "."
            : "; but it is too damaged, too plain or too small a part to say that it is not the owner's.");
}

std::string figures(const watermark::IdentifyReport& report, const std::vector<Match>& matches,
                    const Copies& copies) {
    std::string text;
    for (const Match& match : matches)
        text += fmt::format("match           {}, log10 p {:.2f}, {:.2f} standard deviations, work {}\n",
                            match.entry.recipient, match.accusation.log10_p, match.accusation.sigmas,
                            match.entry.work);
    if (report.receipts_tried > 0)
        text += fmt::format("receipts        {} tried{}\n", report.receipts_tried,
                            report.receipt ? "; that of work " + copies.works[*report.receipt].substr(0, 12) +
                                                 " told the pose"
                                           : "");
    return text +
           fmt::format("mark            {}, log10 p {:.2f}, level {} ({})\ncompared        {} copies; the "
                       "clearest scores {:.2f} standard deviations\n",
                       detect::name(report.mark.verdict), report.mark.score.log10_p, report.mark.level,
                       report.mark.pose_origin, report.compared, report.best_sigmas);
}

ordered_json to_json(const IdentifyArguments& arguments, const watermark::IdentifyReport& report,
                     const std::vector<Match>& matches, const Copies& copies, const key::Key& key) {
    ordered_json list = ordered_json::array();
    for (const Match& match : matches)
        list.push_back({{"work", match.entry.work},
                        {"file", match.entry.file},
                        {"recipient", match.entry.recipient},
                        {"entry", match.entry.number},
                        {"log10_p", match.accusation.log10_p},
                        {"sigmas", match.accusation.sigmas}});
    return {{"input", arguments.files.input},
            {"key", key.fingerprint()},
            {"ledger", arguments.ledger},
            {"pf", arguments.options.pf},
            {"answer", answer(report)},
            {"copies", copies.issued.size()},
            {"compared", report.compared},
            {"matches", list},
            {"mark",
             {{"verdict", detect::name(report.mark.verdict)},
              {"log10_p", report.mark.score.log10_p},
              {"hypotheses", report.mark.score.hypotheses},
              {"level", report.mark.level},
              {"pose_origin", report.mark.pose_origin}}},
            {"receipts",
             {{"tried", report.receipts_tried},
              {"work", report.receipt ? ordered_json(copies.works[*report.receipt]) : ordered_json()}}},
            {"best_sigmas", report.best_sigmas}};
}

int run(const IdentifyArguments& arguments, Output& output) {
    const key::Key key = load_key(arguments.key, output);
    IdentifyArguments known = arguments;
    known.ledger = ledger_path(arguments.ledger, arguments.key);
    const ledger::Ledger book(known.ledger, {.owner = owner_of(key)});
    const Copies copies = read_copies(book, known);
    const TriangleMesh mesh = read_input(arguments.files).take_mesh();
    const watermark::IdentifyReport report = watermark::identify(
        mesh, key, copies.issued, {arguments.options, copies.receipts}, output.progress());
    const std::vector<Match> matches = matches_of(report, copies, book);
    const std::string name =
        key.name().empty() ? "key " + key.fingerprint() : fmt::format("key '{}'", key.name());
    output.print(output.toned(sentence(known, report, matches, copies.issued.size(), name),
                              matches.empty() ? Tone::plain : Tone::good) +
                 "\n");
    if (!output.quiet())
        output.print(figures(report, matches, copies));
    output.print_json(to_json(known, report, matches, copies, key));
    return matches.empty() ? exit_check_failed : exit_done;
}

} // namespace

Action declare_identify(CLI::App& app) {
    const auto arguments = std::make_shared<IdentifyArguments>();
    app.description(
        "Says whose copy a suspect was made from: the copies that `mark --for` entered in the ledger, one "
        "or\n"
        "several where copies were mixed. Needs neither the original nor the copies. The probability that\n"
        "anybody who had no part in the suspect is named is exact, and all copies are paid for in it.\n"
        "Exit status: 0 matched, 1 none, 2 error.");
    add_input(app, arguments->files);
    app.add_option("--key", arguments->key, "Owner's key file")->option_text("FILE (required)")->required();
    app.add_option("--ledger", arguments->ledger, "Ledger of the copies [the key's name with .ledger]")
        ->option_text("FILE");
    app.add_option("--pf", arguments->options.pf, "Probability at most that anybody innocent is named [1e-6]")
        ->option_text("P")
        ->check(probability());
    app.add_option(
           "--resync", arguments->resync,
           "pca: principal axes alone; none: canonical frame alone; search: every pose, as verify does "
           "[pca, and receipts and search where they are needed]")
        ->option_text("NAME")
        ->check(CLI::IsMember({"pca", "none", "search"}));
    app.add_option(
           "--effort", arguments->options.effort,
           "How long to search: 1 tries 50 receipts and takes a minute or two on two cores, 0 doesn't [1]")
        ->option_text("E")
        ->check(number_between(0, 1000));
    app.add_option(
           "--vertices", arguments->options.vertices,
           "Vertices to simplify the suspect to [20000]; where that shows nothing, all of up to 50000 "
           "are looked at")
        ->option_text("N")
        ->check(number_between(4, 1e8));
    app.footer("Examples:\n  wm3d mark statue.obj -o ann.obj --key shop.key --for Ann\n"
               "  wm3d identify suspect.obj --key shop.key --ledger shop.ledger");
    return [arguments](Output& output) {
        arguments->options.resync =
            arguments->resync == "none" ? watermark::Resync::none : watermark::Resync::pca;
        arguments->options.search = arguments->resync.empty()       ? watermark::SearchUse::when_needed
                                    : arguments->resync == "search" ? watermark::SearchUse::always
                                                                    : watermark::SearchUse::never;
        return run(*arguments, output);
    };
}

} // namespace wm3d::cmd
