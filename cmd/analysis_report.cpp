// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wm3d::cmd {

namespace {

using nlohmann::ordered_json;
using study::MeasuredCurve;
using study::MeasuredPoint;
using study::RocCurve;
using study::RocKind;
using study::RocPoint;

std::string kind_for_people(RocKind kind) {
    switch (kind) {
    case RocKind::paper:
        return "paper, eq. (5)";
    case RocKind::paper_true:
        return "paper, true P_f";
    default:
        return "whitened";
    }
}

/// "visibility 0.1", "0.05 %" or a gamma: what was asked for.
template<typename Curve>
std::string setting_for_people(const Curve& curve) {
    const std::optional<double> strength = curve.strength;
    const std::string size = curve.visibility ? fmt::format("visibility {:g}", *curve.visibility)
                             : strength       ? fmt::format("{:g} %", *strength)
                                              : fmt::format("\u03b3 = {:g}", curve.gamma);
    return fmt::format("{}, n = {}", size, curve.vertices);
}

bool of_mesh(const AnalysisReport& report) {
    return !report.mesh.empty();
}

std::string heading(const AnalysisReport& report, const RocCurve& curve) {
    const std::string setting = setting_for_people(curve);
    return of_mesh(report) ? fmt::format("{}, {}", kind_for_people(curve.kind), setting) : setting;
}

std::string heading(const MeasuredCurve& curve) {
    return fmt::format("{} measured, {}", kind_for_people(curve.kind), setting_for_people(curve));
}

/// A probability in a few digits, also where it underflows.
std::string short_probability(double p, double log10_p) {
    if (p > 1e-300 || !(log10_p < 0))
        return fmt::format("{:.3g}", p);
    const double exponent = std::floor(log10_p);
    return fmt::format("{:.2f}e{:.0f}", std::pow(10, log10_p - exponent), exponent);
}

std::string interval(const MeasuredPoint& p) {
    return fmt::format("{:.3g} [{:.2g}, {:.2g}]", p.pm, p.low, p.high);
}

std::string optional_number(std::optional<double> x) {
    return x ? fmt::format("{}", *x) : std::string();
}

/// Curves of one group stand side by side.
template<typename C>
std::string group(const C& curve) {
    return "P_m, " + setting_for_people(curve);
}

/// The table with this heading, made with a row for every P_f if there is none yet.
template<typename Points>
report::Table& table_for(std::vector<RocTable>& tables, const std::string& heading, const Points& points) {
    const auto found = std::ranges::find(tables, heading, &RocTable::heading);
    if (found != tables.end())
        return found->table;
    RocTable fresh{heading, {{"P_f"}, {}}};
    for (const auto& p : points)
        fresh.table.rows.push_back({fmt::format("{:.3g}", p.pf)});
    tables.push_back(std::move(fresh));
    return tables.back().table;
}

template<typename Points, typename Cell>
void add_column(report::Table& table, std::string heading, const Points& points, Cell&& cell) {
    table.columns.push_back(std::move(heading));
    for (std::size_t i = 0; i < points.size(); ++i)
        table.rows[i].push_back(cell(points[i]));
}

ordered_json to_json(const RocCurve& curve, const RocPoint& p) {
    ordered_json json{{"detector", study::name(curve.kind)},
                      {"gamma", curve.gamma},
                      {"vertices", curve.vertices},
                      {"pf", p.pf},
                      {"pm", p.pm},
                      {"log10_pm", p.log10_pm}};
    if (p.threshold)
        json["threshold"] = *p.threshold;
    if (p.log10_true_pf)
        json["log10_true_pf"] = *p.log10_true_pf;
    if (curve.visibility)
        json["visibility"] = *curve.visibility;
    if (curve.strength)
        json["strength_percent"] = *curve.strength;
    return json;
}

ordered_json to_json(const MeasuredCurve& curve, const MeasuredPoint& p) {
    ordered_json json{
        {"detector", study::name(curve.kind)}, {"gamma", curve.gamma}, {"vertices", curve.vertices}};
    if (curve.visibility)
        json["visibility"] = *curve.visibility;
    json.update({{"strength_percent", curve.strength},
                 {"pf", p.pf},
                 {"trials", curve.trials},
                 {"missed", p.missed},
                 {"pm", p.pm},
                 {"low", p.low},
                 {"high", p.high},
                 {"confidence", study::roc_confidence}});
    return json;
}

ordered_json to_json(const study::MeshStatistics& s) {
    return {{"vertices", s.paper.n},
            {"level", s.level},
            {"mu_r", s.paper.mu_r},
            {"sigma_r", std::sqrt(s.paper.sigma_r2)},
            {"sigma_r2", s.paper.sigma_r2},
            {"delta_mean", s.paper.delta_mean},
            {"delta_mean_square", s.paper.delta_mean_square},
            {"null_sigma_ratio", s.null_sigma_ratio}};
}

/// What was asked for.
template<typename Curve>
double size_of(const Curve& curve) {
    const std::optional<double> strength = curve.strength;
    return curve.visibility.value_or(strength.value_or(curve.gamma));
}

/// Curves that share gamma, strength or visibility share the colour; those that share n and detector share the dash.
class Looks {
public:
    int colour(double size, RocKind kind) { return number(colours_, {size, static_cast<double>(kind)}); }
    int dash(std::size_t vertices) { return number(dashes_, {static_cast<double>(vertices), 0}); }

private:
    using Numbers = std::map<std::array<double, 2>, int>;
    static int number(Numbers& numbers, std::array<double, 2> of) {
        return numbers.try_emplace(of, static_cast<int>(numbers.size())).first->second;
    }
    Numbers colours_, dashes_;
};

} // namespace

std::vector<RocTable> roc_tables(const AnalysisReport& report) {
    std::vector<RocTable> tables;
    for (const RocCurve& curve : report.predicted)
        add_column(table_for(tables, of_mesh(report) ? group(curve) : std::string(), curve.points),
                   of_mesh(report) ? kind_for_people(curve.kind) : setting_for_people(curve), curve.points,
                   [](const RocPoint& p) { return short_probability(p.pm, p.log10_pm); });
    for (const MeasuredCurve& curve : report.measured)
        add_column(table_for(tables, group(curve), curve.points), kind_for_people(curve.kind) + " measured",
                   curve.points, interval);
    return tables;
}

report::Table mesh_table(const AnalysisReport& report) {
    report::Table table{
        {"n", "level", "mu_r", "sigma_r", "mean Delta", "mean Delta^2", "true sigma of rho / eq. (6)'s"}, {}};
    for (const study::MeshStatistics& s : report.mesh)
        table.rows.push_back(
            {fmt::format("{}", s.paper.n), fmt::format("{}", s.level), fmt::format("{:.5g}", s.paper.mu_r),
             fmt::format("{:.5g}", std::sqrt(s.paper.sigma_r2)), fmt::format("{:.3g}", s.paper.delta_mean),
             fmt::format("{:.4g}", s.paper.delta_mean_square), fmt::format("{:.3f}", s.null_sigma_ratio)});
    return table;
}

report::Table long_table(const AnalysisReport& report) {
    report::Table table{{"source", "detector", "gamma", "vertices", "visibility", "strength_percent", "pf",
                         "pm", "log10_pm", "threshold", "log10_true_pf", "trials", "missed", "low", "high"},
                        {}};
    for (const RocCurve& curve : report.predicted)
        for (const RocPoint& p : curve.points)
            table.rows.push_back({"predicted", std::string(study::name(curve.kind)),
                                  fmt::format("{}", curve.gamma), fmt::format("{}", curve.vertices),
                                  optional_number(curve.visibility), optional_number(curve.strength),
                                  fmt::format("{}", p.pf), fmt::format("{}", p.pm),
                                  fmt::format("{}", p.log10_pm), optional_number(p.threshold),
                                  optional_number(p.log10_true_pf), "", "", "", ""});
    for (const MeasuredCurve& curve : report.measured)
        for (const MeasuredPoint& p : curve.points)
            table.rows.push_back({"measured", std::string(study::name(curve.kind)),
                                  fmt::format("{}", curve.gamma), fmt::format("{}", curve.vertices),
                                  optional_number(curve.visibility), fmt::format("{}", curve.strength),
                                  fmt::format("{}", p.pf), fmt::format("{}", p.pm), "", "", "",
                                  fmt::format("{}", curve.trials), fmt::format("{}", p.missed),
                                  fmt::format("{}", p.low), fmt::format("{}", p.high)});
    return table;
}

void add_json(ordered_json& object, const AnalysisReport& report) {
    for (const study::MeshStatistics& s : report.mesh)
        object["mesh"].push_back(to_json(s));
    object["predicted"] = ordered_json::array();
    for (const RocCurve& curve : report.predicted)
        for (const RocPoint& p : curve.points)
            object["predicted"].push_back(to_json(curve, p));
    for (const MeasuredCurve& curve : report.measured)
        for (const MeasuredPoint& p : curve.points)
            object["measured"].push_back(to_json(curve, p));
}

report::Plot roc_plot(const AnalysisReport& report) {
    report::Plot plot;
    plot.title = report.title;
    plot.x_label = "false-positive probability P_f";
    plot.y_label = "miss probability P_m";
    Looks looks;
    for (const RocCurve& curve : report.predicted) {
        report::Curve line{.name = heading(report, curve),
                           .colour = looks.colour(size_of(curve), curve.kind),
                           .dash = looks.dash(curve.vertices),
                           .points = {}};
        for (const RocPoint& p : curve.points)
            line.points.push_back({.x = p.pf, .y = p.pm});
        plot.curves.push_back(std::move(line));
    }
    for (const MeasuredCurve& curve : report.measured) {
        report::Curve points{.name = heading(curve),
                             .style = report::Curve::Style::points,
                             .colour = looks.colour(size_of(curve), curve.kind),
                             .dash = looks.dash(curve.vertices),
                             .points = {}};
        for (const MeasuredPoint& p : curve.points)
            points.points.push_back({.x = p.pf, .y = p.pm, .low = p.low, .high = p.high});
        plot.curves.push_back(std::move(points));
    }
    return plot;
}

std::string roc_page(const AnalysisReport& report, const std::string& json) {
    report::Page page;
    page.title = report.title;
    page.paragraphs.emplace_back(
        "How likely a mark is missed (P_m) when an unmarked model may be accused with "
        "probability P_f. Lines are predictions, points are measurements.");
    page.svg = report::render(roc_plot(report), report::Image::svg);
    page.caption =
        report.measured.empty()
            ? "Both axes are logarithmic; the probabilities have no unit."
            : "Both axes are logarithmic; the probabilities have no unit. Bars are 95 % Clopper-Pearson "
              "intervals; a point on the lower axis says that no mark was missed.";
    if (of_mesh(report))
        page.sections.push_back({"The mesh", "Lengths in units of the mean radius.", mesh_table(report)});
    for (RocTable& table : roc_tables(report))
        page.sections.push_back(
            {table.heading.empty() ? "Figures" : std::move(table.heading), "", std::move(table.table)});
    page.json = json;
    return report::to_html(page);
}

} // namespace wm3d::cmd
