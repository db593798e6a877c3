// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_summary.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <wm3d/report/table.hpp>
#include <wm3d/study/published_figures.hpp>

namespace wm3d::cmd {

namespace {

using namespace study;

std::string log10_text(double log10_p) {
    return fmt::format("{:.1f}", log10_p > -0.05 ? 0 : log10_p); // never "-0.0"
}

std::string cell_text(const BenchCell& cell) {
    if (cell.keys == 0)
        return cell.error.empty() ? "" : "none";
    const std::string number = log10_text(cell.worst_log10_p);
    return cell.missed > 0 ? "**" + number + "**" : number;
}

/// The protocol whose limit is nearer to what the marks of a table moved.
Protocol protocol_of(const BenchTable& table) {
    double mrms = 0;
    for (const BenchMarkRow& row : table.marks)
        mrms = std::max(mrms, row.mean_mrms);
    return mrms < 0.04 ? Protocol::geometric : Protocol::perceptual;
}

std::string rate_text(double rate, double log10_target) {
    const double log10_pf = log10_false_positive(rate);
    const char* bold = log10_pf > log10_target ? "**" : "";
    return fmt::format("{:.2f} ({}{:.1f}{})", rate, bold, log10_pf, bold);
}

std::string attack_table(const BenchTable& table, const std::vector<std::vector<BenchCell>>& cells,
                         bool published) {
    report::Table text{{"attack"}, {}};
    for (const std::string& model : model_headings(table.models))
        text.columns.push_back(model);
    if (published)
        text.columns.insert(text.columns.end(), {"Cho 2007", "Wang 2011"});
    for (std::size_t a = 0; a < table.attacks.size(); ++a) {
        std::vector<std::string> row{table.attacks[a]};
        for (const BenchCell& cell : cells[a])
            row.push_back(cell_text(cell));
        if (std::ranges::all_of(row.begin() + 1, row.end(), &std::string::empty))
            continue;
        if (published) {
            const auto rates = published_rates(table.attacks[a], protocol_of(table));
            row.push_back(rates ? rate_text(rates->cho, table.log10_target) : "");
            row.push_back(rates ? rate_text(rates->wang, table.log10_target) : "");
        }
        text.rows.push_back(std::move(row));
    }
    return report::to_markdown(text);
}

std::string marks_table(const BenchTable& table) {
    report::Table text{
        {"model", "vertices", "strength, %", "MRMS, %", "largest", "MSDM2", "largest", "both sides"}, {}};
    const std::vector<std::string> names = model_headings(table.models);
    for (std::size_t m = 0; m < names.size(); ++m) {
        const BenchMarkRow& row = table.marks[m];
        text.rows.push_back(
            {names[m], fmt::format("{}", row.vertices), fmt::format("{:.4f}", row.mean_strength),
             fmt::format("{:.4f}", row.mean_mrms), fmt::format("{:.4f}", row.largest_mrms),
             fmt::format("{:.3f}", row.mean_msdm2), fmt::format("{:.3f}", row.largest_msdm2),
             std::isnan(row.mean_msdm2_both) ? "" : fmt::format("{:.3f}", row.mean_msdm2_both)});
    }
    return report::to_markdown(text);
}

/// A line for every attack that a key did not survive, and for every copy that there is not.
std::string list_misses(const BenchTable& table, const std::vector<std::vector<BenchCell>>& cells) {
    std::string text;
    const std::vector<std::string> names = model_headings(table.models);
    for (std::size_t a = 0; a < table.attacks.size(); ++a) {
        std::vector<std::string> misses;
        for (std::size_t m = 0; m < names.size(); ++m) {
            const BenchCell& cell = cells[a][m];
            if (cell.missed > 0)
                misses.push_back(fmt::format("{} ({} of {} keys, worst {})", names[m], cell.missed, cell.keys,
                                             log10_text(cell.worst_log10_p)));
            if (!cell.error.empty())
                misses.push_back(fmt::format("{} (no copy to examine: {})", names[m], cell.error));
        }
        if (!misses.empty())
            text += fmt::format("- {}: {}\n", table.attacks[a], fmt::join(misses, ", "));
    }
    return text.empty() ? "None.\n" : text;
}

/// Whether payloads do at least as well as published ones did: no more errors before decoding, none behind it where
/// theirs were few.
bool matches_published(const PayloadCell& cell, const PublishedRates& rates) {
    constexpr double few = 0.1;
    const double best = best_published(rates);
    return cell.mean_rate() <= best && (best >= few || cell.read == cell.keys);
}

std::string payload_text(const PayloadCell& cell, const std::optional<PublishedRates>& rates) {
    if (cell.keys == 0)
        return "";
    const char* bold = cell.wrong > 0 || (rates && !matches_published(cell, *rates)) ? "**" : "";
    return fmt::format("{}{:.3f} / {:.3f}, {} of {}{}", bold, cell.mean_rate(), cell.worst_rate(), cell.read,
                       cell.keys, bold);
}

std::string payload_table(const BenchTable& table) {
    report::Table text{{"attack"}, {}};
    for (const std::string& model : model_headings(table.models))
        text.columns.push_back(model);
    text.columns.insert(text.columns.end(), {"Cho 2007", "Wang 2011"});
    for (std::size_t a = 0; a < table.attacks.size(); ++a) {
        std::vector<std::string> row{table.attacks[a]};
        const auto rates = published_rates(table.attacks[a], protocol_of(table));
        for (const PayloadCell& cell : table.payloads[a])
            row.push_back(payload_text(cell, rates));
        if (std::ranges::all_of(row.begin() + 1, row.end(), &std::string::empty))
            continue;
        row.push_back(rates ? fmt::format("{:.2f}", rates->cho) : "");
        row.push_back(rates ? fmt::format("{:.2f}", rates->wang) : "");
        text.rows.push_back(std::move(row));
    }
    return report::to_markdown(text);
}

std::string payload_section(const BenchTable& table) {
    if (table.payloads.empty())
        return "";
    const PayloadCount count = count_payloads(table);
    return fmt::format(
        "### Payloads\n\nA random payload of {} bits in every mark. In each cell the bit error rate without "
        "a code, "
        "mean and worst of the keys, and how many payloads were decoded without error. Published rates are "
        "those of 64 "
        "uncoded bits, the mean of several keys. Bold is what has more errors than the better published "
        "rate, is not "
        "decoded with every key though that rate is below 0.1, or gave another payload.\n\n{}\n"
        "{} of {} payloads were decoded, {} gave another. {} of {} cells with a published rate do as well as "
        "that or "
        "better.\n\n",
        count.bits, payload_table(table), count.read, count.keys, count.wrong, count.as_published,
        count.published);
}

std::string table_section(const BenchTable& table) {
    std::string text = fmt::format("## Marks of {}\n\n{}\n", size_text(table.size), marks_table(table));
    text += fmt::format("log10 p of the worst key; what stays above {:.4g} is bold and listed below.\n\n{}\n",
                        table.log10_target, attack_table(table, table.cells, true));
    text += fmt::format("{} of {} cells reach {:.4g} with every key. Missed:\n\n{}\n",
                        table.filled() - table.missed(), table.filled(), table.log10_target,
                        list_misses(table, table.cells));
    return text;
}

std::string assisted_section(const BenchTable& table) {
    if (table.assisted.empty())
        return "";
    return fmt::format(
        "### With the original at hand\n\nThe same copies, aligned with the unmarked original: log10 p "
        "of the worst key.\n\n{}\nMissed:\n\n{}\n",
        attack_table(table, table.assisted, false), list_misses(table, table.assisted));
}

std::string wrong_section(const WrongKeys& wrong) {
    if (wrong.keys == 0)
        return "";
    report::Table text{{"P_f", "expected at most", "wrong keys found", "as many or more", "in one hypothesis",
                        "as far from expected"},
                       {}};
    for (const WrongKeyCount& count : wrong.counts)
        text.rows.push_back({fmt::format("{:g}", count.pf),
                             fmt::format("{:.0f}", count.pf * static_cast<double>(wrong.keys)),
                             fmt::format("{}", count.family), fmt::format("{:.3g}", count.family_excess),
                             fmt::format("{}", count.one), fmt::format("{:.3g}", count.one_strays)});
    return fmt::format("## Wrong keys\n\n{} wrong keys were tried on the marked and attacked copies, each on "
                       "one. Family-wise p is an "
                       "upper bound, so fewer than expected may be found; in one hypothesis p is exact, and "
                       "as many as expected have "
                       "to be. Beside each count stands its probability if p is what it says.\n\n{}\nThe "
                       "smallest p of all is "
                       "10^{:.1f}. Uniformity of p in one hypothesis (Kolmogorov-Smirnov): {:.3f}.\n\n",
                       wrong.keys, report::to_markdown(text), wrong.smallest_log10_p, wrong.uniformity);
}

std::vector<std::string> payload_fields(const std::optional<PayloadResult>& payload) {
    if (!payload)
        return {"", "", "", ""};
    return {fmt::format("{}", payload->bits), fmt::format("{}", payload->raw_errors),
            payload->read ? "1" : "0", fmt::format("{:.6g}", payload->log10_p)};
}

std::string introduction(const BenchSummary& summary) {
    std::string text = fmt::format(
        "# Robustness\n\nEach model is marked with {} random key{}; every marked copy is attacked, then "
        "moved, turned and "
        "scaled at random, and examined blind, as `wm3d verify` does with its defaults. p is family-wise: "
        "the "
        "probability, at most, that a random key scores like this on that copy. Cho 2007 and Wang 2011 are "
        "published "
        "bit error rates of 64 bits in the model Venus at a like distortion, and in parentheses log10 of the "
        "probability that random bits agree as well.\n\nMade by wm3d {} with seed {}:\n\n    {}\n\n",
        summary.keys, summary.keys == 1 ? "" : "s", summary.version, summary.seed,
        fmt::join(summary.commands, "\n    "));
    if (!summary.heat_map.empty())
        text += fmt::format("![log10 p of the worst key by attack and model]({})\n\n", summary.heat_map);
    return text;
}

} // namespace

PayloadCount count_payloads(const BenchTable& table) {
    PayloadCount count;
    for (std::size_t a = 0; a < table.payloads.size(); ++a) {
        const auto rates = published_rates(table.attacks[a], protocol_of(table));
        for (const PayloadCell& cell : table.payloads[a]) {
            if (cell.keys == 0)
                continue;
            count.bits = cell.bits;
            count.keys += cell.keys;
            count.read += cell.read;
            count.wrong += cell.wrong;
            count.published += rates.has_value();
            count.as_published += rates && matches_published(cell, *rates);
        }
    }
    return count;
}

BenchSummary summarize(const BenchResults& results, const BenchSetting& setting,
                       const std::vector<double>& log10_targets) {
    BenchSummary summary;
    for (std::size_t s = 0; s < setting.sizes.size(); ++s)
        summary.tables.push_back(bench_table(results, setting.sizes[s], log10_targets[s]));
    summary.commands = results.commands;
    summary.wrong = count_wrong_keys(results);
    for (const auto& [name, model] : results.models)
        if (!model.error.empty())
            summary.unusable.push_back(fmt::format("{}: {}", name, model.error));
    for (const auto& [name, mark] : results.marks)
        if (!mark.error.empty())
            summary.unusable.push_back(
                fmt::format("{}, {}, key {}: {}", name.model, size_text(name.size), name.key, mark.error));
    summary.seed = setting.seed;
    for (const auto& [name, mark] : results.marks)
        summary.keys = std::max(summary.keys, name.key + 1);
    return summary;
}

std::string bench_markdown(const BenchSummary& summary) {
    std::string text = introduction(summary);
    if (!summary.unusable.empty()) {
        text += "Not examined:\n\n";
        for (const std::string& line : summary.unusable)
            text += fmt::format("- {}\n", line);
        text += '\n';
    }
    for (const BenchTable& table : summary.tables)
        text += table_section(table) + payload_section(table) + assisted_section(table);
    return text + wrong_section(summary.wrong);
}

std::string bench_csv(const BenchResults& results) {
    report::Table table{{"model",        "size",
                         "size_percent", "key",
                         "attack",       "strength_percent",
                         "mrms_percent", "msdm2",
                         "log10_p",      "sigmas",
                         "hypotheses",   "level",
                         "pose",         "filter_t",
                         "filter_power", "filter_hinges",
                         "vertices",     "assisted_log10_p",
                         "payload_bits", "payload_raw_errors",
                         "payload_read", "payload_log10_p",
                         "error"},
                        {}};
    for (const auto& [name, item] : results.items) {
        const BenchMark& mark = results.marks.at(name.mark);
        const MarkSize& size = name.mark.size;
        table.rows.push_back({name.mark.model, std::string(study::name(size.unit)),
                              fmt::format("{}", size.value), fmt::format("{}", name.mark.key), name.attack,
                              fmt::format("{:.6g}", mark.strength), fmt::format("{:.6g}", mark.mrms),
                              fmt::format("{:.6g}", mark.msdm2)});
        std::vector<std::string>& row = table.rows.back();
        if (item.error.empty()) {
            row.insert(row.end(), {fmt::format("{:.6g}", item.log10_p), fmt::format("{:.6g}", item.sigmas),
                                   fmt::format("{}", item.hypotheses), fmt::format("{}", item.level),
                                   fmt::format("{}", item.pose), fmt::format("{:g}", item.filter_t),
                                   fmt::format("{:g}", item.filter_power),
                                   fmt::format("{:g}", item.filter_hinges), fmt::format("{}", item.vertices),
                                   item.assisted ? fmt::format("{:.6g}", item.assisted->log10_p) : ""});
            const std::vector<std::string> payload = payload_fields(item.payload);
            row.insert(row.end(), payload.begin(), payload.end());
            row.emplace_back();
        } else {
            row.resize(table.columns.size() - 1);
            row.push_back(item.error);
        }
    }
    return report::to_csv(table);
}

} // namespace wm3d::cmd
