// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/bench_cells.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

#include <boost/math/distributions/binomial.hpp>
#include <fmt/format.h>

#include <wm3d/watermark/null_keys.hpp>

namespace wm3d::study {

namespace {

/// Where an attack stands in the tables: that of the default list, or behind it, similar ones side by side.
struct Rank {
    std::size_t listed;
    std::string name;
    std::vector<double> values;

    // NOLINTNEXTLINE(modernize-use-nullptr): a category is compared with 0
    auto operator<=>(const Rank&) const = default;
};

std::size_t index_of(const std::vector<std::string>& names, const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

Rank rank_of(const std::string& attack, const std::vector<std::string>& listed) {
    const AttackChain chain = attack::parse_chain(attack);
    Rank rank{index_of(listed, attack), "", chain.front().values};
    for (const attack::AttackSpec& spec : chain)
        rank.name += spec.name + '+';
    return rank;
}

void add(BenchCell& cell, std::size_t key, double log10_p, double log10_target) {
    if (cell.keys++ == 0 || !(log10_p <= cell.worst_log10_p)) {
        cell.worst_log10_p = log10_p;
        cell.worst_key = key;
    }
    cell.missed += !(log10_p <= log10_target);
}

void add(PayloadCell& cell, const PayloadResult& payload) {
    ++cell.keys;
    cell.bits = payload.bits;
    cell.raw_errors += payload.raw_errors;
    cell.worst_errors = std::max(cell.worst_errors, payload.raw_errors);
    cell.read += payload.read;
    cell.wrong += payload.wrong;
    cell.worst_log10_p = std::max(cell.worst_log10_p, payload.log10_p);
}

double rate(std::size_t errors, std::size_t bits) {
    return bits == 0 ? 0 : static_cast<double>(errors) / static_cast<double>(bits);
}

void fill_cells(BenchTable& table, const BenchResults& results) {
    table.cells.assign(table.attacks.size(), std::vector<BenchCell>(table.models.size()));
    table.assisted = table.cells;
    table.payloads.assign(table.attacks.size(), std::vector<PayloadCell>(table.models.size()));
    bool any_assisted = false, any_payload = false;
    for (const auto& [name, item] : results.items) {
        const std::size_t a = index_of(table.attacks, name.attack),
                          m = index_of(table.models, name.mark.model);
        if (name.mark.size != table.size || m == table.models.size())
            continue;
        BenchCell &blind = table.cells[a][m], &assisted = table.assisted[a][m];
        if (!item.error.empty())
            blind.error = assisted.error = item.error;
        else
            add(blind, name.mark.key, item.log10_p, table.log10_target);
        if (item.assisted) {
            any_assisted = true;
            add(assisted, name.mark.key, item.assisted->log10_p, table.log10_target);
        }
        if (item.payload) {
            any_payload = true;
            add(table.payloads[a][m], *item.payload);
        }
    }
    if (!any_assisted)
        table.assisted.clear();
    if (!any_payload)
        table.payloads.clear();
}

BenchMarkRow mark_row(const BenchResults& results, const std::string& model, const MarkSize& size) {
    BenchMarkRow row;
    row.model = model;
    row.vertices = results.models.at(model).vertices;
    for (const auto& [name, mark] : results.marks) {
        if (name.model != model || name.size != size || !mark.error.empty())
            continue;
        ++row.keys;
        row.mean_strength += mark.strength;
        row.mean_mrms += mark.mrms;
        row.mean_msdm2 += mark.msdm2;
        row.mean_msdm2_both += mark.msdm2_both.value_or(std::numeric_limits<double>::quiet_NaN());
        row.largest_mrms = std::max(row.largest_mrms, mark.mrms);
        row.largest_msdm2 = std::max(row.largest_msdm2, mark.msdm2);
    }
    for (double* mean : {&row.mean_strength, &row.mean_mrms, &row.mean_msdm2, &row.mean_msdm2_both})
        *mean /= static_cast<double>(std::max<std::size_t>(row.keys, 1));
    return row;
}

std::size_t count_at_most(const std::vector<double>& log10_p, double pf) {
    const double bound = std::log10(pf);
    return static_cast<std::size_t>(std::ranges::count_if(log10_p, [&](double x) { return x <= bound; }));
}

/// P(X >= count) for X binomial.
double upper_tail(std::size_t count, std::size_t trials, double p) {
    if (count == 0)
        return 1;
    const boost::math::binomial_distribution<> law(static_cast<double>(trials), p);
    return cdf(complement(law, static_cast<double>(count - 1)));
}

double lower_tail(std::size_t count, std::size_t trials, double p) {
    return cdf(boost::math::binomial_distribution<>(static_cast<double>(trials), p),
               static_cast<double>(count));
}

/// Attacks of all items, each once.
std::vector<std::string> bench_attacks(const BenchResults& results) {
    std::vector<std::string> listed;
    for (const AttackChain& chain : default_attacks())
        listed.push_back(attack::to_string(chain));
    std::set<std::string> names;
    for (const auto& [name, item] : results.items)
        names.insert(name.attack);
    std::vector<std::string> attacks(names.begin(), names.end());
    std::ranges::sort(attacks, {}, [&](const std::string& attack) { return rank_of(attack, listed); });
    return attacks;
}

template<typename Condition>
std::size_t count_cells(const std::vector<std::vector<BenchCell>>& cells, const Condition& condition) {
    std::size_t count = 0;
    for (const std::vector<BenchCell>& row : cells)
        count += static_cast<std::size_t>(std::ranges::count_if(row, condition));
    return count;
}

} // namespace

double PayloadCell::mean_rate() const {
    return rate(raw_errors, keys * bits);
}

double PayloadCell::worst_rate() const {
    return rate(worst_errors, bits);
}

std::size_t BenchTable::filled() const {
    return count_cells(cells, [](const BenchCell& c) { return c.keys > 0; });
}

std::size_t BenchTable::missed() const {
    return count_cells(cells, [](const BenchCell& c) { return c.missed > 0; });
}

BenchTable bench_table(const BenchResults& results, const MarkSize& size, double log10_target) {
    BenchTable table;
    table.size = size;
    table.log10_target = log10_target;
    table.attacks = bench_attacks(results);
    for (const auto& [name, model] : results.models) {
        BenchMarkRow row = mark_row(results, name, size);
        if (row.keys == 0)
            continue;
        table.models.push_back(name);
        table.marks.push_back(std::move(row));
    }
    fill_cells(table, results);
    return table;
}

std::string size_text(const MarkSize& size) {
    if (size.unit == MarkSize::Unit::visibility)
        return fmt::format("MSDM2 up to {}", size.value);
    return fmt::format("{} {} %", size.unit == MarkSize::Unit::mrms ? "MRMS up to" : "strength", size.value);
}

std::vector<std::string> model_headings(const std::vector<std::string>& files) {
    std::vector<std::string> names;
    for (const std::string& file : files)
        names.push_back(std::filesystem::path(file).stem().string());
    return std::set(names.begin(), names.end()).size() == names.size() ? names : files;
}

WrongKeys count_wrong_keys(const BenchResults& results) {
    std::vector<double> family, one;
    for (const auto& [name, item] : results.items) {
        family.insert(family.end(), item.wrong.begin(), item.wrong.end());
        one.insert(one.end(), item.wrong_one.begin(), item.wrong_one.end());
    }
    WrongKeys result;
    result.keys = family.size();
    if (family.empty())
        return result;
    for (double pf : {0.1, 0.01, 0.001}) {
        WrongKeyCount count;
        count.pf = pf;
        count.family = count_at_most(family, pf);
        count.family_excess = upper_tail(count.family, family.size(), pf);
        count.one = count_at_most(one, pf);
        count.one_strays = std::min(
            1.0, 2 * std::min(upper_tail(count.one, one.size(), pf), lower_tail(count.one, one.size(), pf)));
        result.counts.push_back(count);
    }
    result.smallest_log10_p = *std::ranges::min_element(family);
    for (double& x : one)
        x = std::pow(10, x);
    result.uniformity = watermark::uniformity(std::move(one));
    return result;
}

} // namespace wm3d::study
