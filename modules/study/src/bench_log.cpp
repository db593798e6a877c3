// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/bench_log.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/json_number.hpp>

namespace wm3d::study {

namespace {

using nlohmann::ordered_json;

constexpr const char* items_schema = "wm3d.bench-items/1";

/// JSON has no NaN; it is written as null.
double number(const ordered_json& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

ordered_json to_json(const std::string& name, const BenchModel& model) {
    ordered_json json{{"kind", "model"}, {"model", name}};
    if (!model.error.empty())
        json["error"] = model.error;
    if (!model.fingerprint.empty()) {
        json["mesh"] = model.fingerprint;
        json["vertices"] = model.vertices;
        json["triangles"] = model.triangles;
    }
    return json;
}

BenchModel model_of(const ordered_json& json) {
    BenchModel model;
    model.error = json.value("error", "");
    model.fingerprint = json.value("mesh", "");
    model.vertices = json.contains("vertices") ? whole_number<std::size_t>(json.at("vertices")) : 0;
    model.triangles = json.contains("triangles") ? whole_number<std::size_t>(json.at("triangles")) : 0;
    return model;
}

const char* field_of(MarkSize::Unit unit) {
    switch (unit) {
    case MarkSize::Unit::mrms:
        return "mrms_limit";
    case MarkSize::Unit::visibility:
        return "visibility_limit";
    default:
        return "strength_asked";
    }
}

ordered_json to_json(const char* kind, const MarkName& name) {
    return {{"kind", kind},
            {"model", name.model},
            {field_of(name.size.unit), name.size.value},
            {"key", name.key}};
}

MarkName mark_name_of(const ordered_json& json) {
    const auto unit = json.contains("mrms_limit")         ? MarkSize::Unit::mrms
                      : json.contains("visibility_limit") ? MarkSize::Unit::visibility
                                                          : MarkSize::Unit::strength;
    return {json.at("model").get<std::string>(),
            {unit, json.at(field_of(unit)).get<double>()},
            whole_number<std::size_t>(json.at("key"))};
}

ordered_json to_json(const MarkName& name, const BenchMark& mark) {
    ordered_json json = to_json("mark", name);
    if (!mark.error.empty())
        json["error"] = mark.error;
    else
        json.update({{"strength", mark.strength},
                     {"gamma", mark.gamma},
                     {"rms_percent", mark.normal_rms},
                     {"mrms_percent", mark.mrms},
                     {"msdm2", mark.msdm2}});
    if (mark.msdm2_both)
        json["msdm2_both"] = *mark.msdm2_both;
    return json;
}

BenchMark mark_of(const ordered_json& json) {
    BenchMark mark;
    mark.error = json.value("error", "");
    if (!mark.error.empty())
        return mark;
    mark.strength = json.at("strength").get<double>();
    mark.gamma = json.at("gamma").get<double>();
    mark.normal_rms = json.at("rms_percent").get<double>();
    mark.mrms = json.at("mrms_percent").get<double>();
    mark.msdm2 = number(json.at("msdm2"));
    if (json.contains("msdm2_both"))
        mark.msdm2_both = number(json.at("msdm2_both"));
    return mark;
}

ordered_json to_json(const ItemName& name, const BenchItem& item) {
    ordered_json json = to_json("item", name.mark);
    json["attack"] = name.attack;
    if (!item.error.empty()) {
        json["error"] = item.error;
        return json;
    }
    json.update(
        {{"log10_p", item.log10_p},
         {"sigmas", item.sigmas},
         {"hypotheses", item.hypotheses},
         {"level", item.level},
         {"pose", item.pose},
         {"filter", {{"t", item.filter_t}, {"power", item.filter_power}, {"hinges", item.filter_hinges}}},
         {"vertices", item.vertices},
         {"wrong_log10_p", item.wrong},
         {"wrong_one_log10_p", item.wrong_one}});
    if (item.searched)
        json["searched"] = {{"found", item.searched->found}, {"centres", item.searched->centres}};
    if (item.assisted)
        json["assisted"] = {{"log10_p", item.assisted->log10_p},
                            {"aligned", item.assisted->aligned},
                            {"coverage", item.assisted->coverage}};
    if (item.payload)
        json["payload"] = {{"bits", item.payload->bits},
                           {"raw_errors", item.payload->raw_errors},
                           {"read", item.payload->read},
                           {"wrong", item.payload->wrong},
                           {"log10_p", item.payload->log10_p}};
    json["seconds"] = std::round(item.seconds * 1000) / 1000;
    return json;
}

std::vector<double> numbers(const ordered_json& json) {
    std::vector<double> result;
    for (const ordered_json& value : json)
        result.push_back(number(value));
    return result;
}

BenchItem item_of(const ordered_json& json) {
    BenchItem item;
    item.error = json.value("error", "");
    if (!item.error.empty())
        return item;
    item.log10_p = number(json.at("log10_p"));
    item.sigmas = number(json.at("sigmas"));
    item.hypotheses = whole_number<std::size_t>(json.at("hypotheses"));
    item.level = whole_number<unsigned>(json.at("level"));
    item.pose = whole_number<std::size_t>(json.at("pose"));
    item.filter_t = json.at("filter").at("t").get<double>();
    item.filter_power = json.at("filter").at("power").get<double>();
    item.filter_hinges = json.at("filter").value("hinges", 0.0); // logs of 0.2.0 have none
    item.vertices = whole_number<std::size_t>(json.at("vertices"));
    item.wrong = numbers(json.at("wrong_log10_p"));
    item.wrong_one = numbers(json.at("wrong_one_log10_p"));
    if (const auto found = json.find("searched"); found != json.end())
        item.searched =
            SearchedResult{found->at("found").get<bool>(), whole_number<std::size_t>(found->at("centres"))};
    if (const auto found = json.find("assisted"); found != json.end())
        item.assisted = AssistedResult{number(found->at("log10_p")), found->at("aligned").get<bool>(),
                                       found->at("coverage").get<double>()};
    if (const auto found = json.find("payload"); found != json.end())
        item.payload = PayloadResult{
            whole_number<std::size_t>(found->at("bits")), whole_number<std::size_t>(found->at("raw_errors")),
            found->at("read").get<bool>(), found->at("wrong").get<bool>(), number(found->at("log10_p"))};
    item.seconds = json.at("seconds").get<double>();
    return item;
}

/// "NAME is X there and Y here" of a setting that differs; empty if none does.
std::string first_difference(const ordered_json& there, const ordered_json& here) {
    for (const auto& [name, value] : here.items()) {
        const ordered_json other =
            there.contains(name) ? there.at(name) : ordered_json(); // an older version's
        if (other != value)
            return fmt::format("{} is {} there and {} here", name, other.dump(), value.dump());
    }
    return "";
}

} // namespace

std::string_view name(MarkSize::Unit unit) {
    switch (unit) {
    case MarkSize::Unit::mrms:
        return "mrms";
    case MarkSize::Unit::visibility:
        return "visibility";
    default:
        return "strength";
    }
}

std::string to_string(const MarkSize& size) {
    return fmt::format("{} {}", name(size.unit), size.value);
}

BenchLog::BenchLog(const std::string& path, const ordered_json& settings)
    : lines_(path, "result of a bench", items_schema, [&](const ordered_json& line, std::size_t number) {
          read(line, number, {{"schema", items_schema}, {"settings", settings}}, path);
      }) {
    if (lines_.was_empty())
        lines_.append({{"schema", items_schema}, {"settings", settings}});
}

void BenchLog::read(const ordered_json& line, std::size_t number, const ordered_json& header,
                    const std::string& path) {
    if (number == 1) {
        if (line.at("schema") != items_schema)
            throw InputError(
                fmt::format("{}: these results are of another version; name another folder", path));
        if (const std::string difference = first_difference(line.at("settings"), header.at("settings"));
            !difference.empty())
            throw InputError(
                fmt::format("{}: these results were made with other settings: {}; name another folder", path,
                            difference));
        return;
    }
    const std::string kind = line.at("kind").get<std::string>();
    if (kind == "command")
        results_.commands.push_back(line.at("command").get<std::string>());
    else if (kind == "model")
        results_.models[line.at("model").get<std::string>()] = model_of(line);
    else if (kind == "mark")
        results_.marks[mark_name_of(line)] = mark_of(line);
    else
        results_.items[{mark_name_of(line), line.at("attack").get<std::string>()}] = item_of(line);
}

void BenchLog::add_command(const std::string& command) {
    if (std::ranges::find(results_.commands, command) != results_.commands.end())
        return;
    lines_.append({{"kind", "command"}, {"command", command}});
    results_.commands.push_back(command);
}

void BenchLog::add(const std::string& name, BenchModel model) {
    if (const auto found = results_.models.find(name); found != results_.models.end()) {
        const BenchModel& known = found->second;
        if (model.fingerprint.empty()) { // it can't be read any more; what was found on it stays
            model.fingerprint = known.fingerprint;
            model.vertices = known.vertices;
            model.triangles = known.triangles;
        }
        if (!known.fingerprint.empty() && known.fingerprint != model.fingerprint)
            throw InputError(
                fmt::format("{}: these results of {} belong to another mesh; name another folder, or the "
                            "model otherwise",
                            lines_.path(), name));
        if (known.fingerprint == model.fingerprint && known.error == model.error)
            return;
    }
    lines_.append(to_json(name, model));
    results_.models[name] = std::move(model);
}

void BenchLog::add(const MarkName& name, const BenchMark& mark) {
    const std::lock_guard lock(guard_);
    lines_.append(to_json(name, mark));
    results_.marks[name] = mark;
}

void BenchLog::add(const ItemName& name, const BenchItem& item) {
    const std::lock_guard lock(guard_);
    lines_.append(to_json(name, item));
    results_.items[name] = item;
}

} // namespace wm3d::study
