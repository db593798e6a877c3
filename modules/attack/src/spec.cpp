// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/spec.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <wm3d/core/error.hpp>

#include "registry.hpp"

namespace wm3d::attack {

namespace {

std::string range_of(const Parameter& parameter) {
    if (parameter.type == Parameter::Type::choice)
        return fmt::format("one of {}", fmt::join(parameter.choices, ", "));
    return fmt::format("a {}number from {} to {}", parameter.type == Parameter::Type::whole ? "whole " : "",
                       parameter.min, parameter.max);
}

std::string value_text(const Parameter& parameter, double value) {
    if (parameter.type == Parameter::Type::choice)
        return std::string(parameter.choices[static_cast<std::size_t>(value)]);
    return fmt::format("{}", value);
}

/// Reads the value, NaN where it isn't one.
double read_value(const Parameter& parameter, std::string_view text) {
    if (parameter.type == Parameter::Type::choice) {
        const auto at = std::find(parameter.choices.begin(), parameter.choices.end(), text);
        return at == parameter.choices.end() ? NAN : static_cast<double>(at - parameter.choices.begin());
    }
    double value = NAN;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_number = error == std::errc{} && end == text.data() + text.size();
    const bool has_type = parameter.type != Parameter::Type::whole || value == std::trunc(value);
    return is_number && has_type ? value : NAN;
}

double checked_value(const AttackInfo& info, const Parameter& parameter, std::string_view text) {
    const double value = read_value(parameter, text);
    if (!(value >= parameter.min && value <= parameter.max))
        throw ParameterError(fmt::format("attack {}: {}=\"{}\" is not {}", info.name, parameter.name, text,
                                         range_of(parameter)));
    return value;
}

std::size_t parameter_number(const AttackInfo& info, std::string_view name) {
    for (std::size_t i = 0; i < info.parameters.size(); ++i)
        if (info.parameters[i].name == name)
            return i;
    std::string known;
    for (const Parameter& parameter : info.parameters)
        known += fmt::format("{}{}", known.empty() ? "" : ", ", parameter.name);
    throw ParameterError(fmt::format("attack {} has no parameter \"{}\"; it has {}", info.name, name,
                                     known.empty() ? "none" : known));
}

/// The parts of `text` between separators; of an empty text, one empty part.
std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos)
            return parts;
        text.remove_prefix(end + 1);
    }
}

void read_argument(const AttackInfo& info, std::string_view argument, std::size_t position,
                   AttackSpec& spec) {
    const std::size_t equals = argument.find('=');
    if (equals == std::string_view::npos && position >= info.parameters.size())
        throw ParameterError(fmt::format("attack {} takes at most {} values, so \"{}\" is one too many",
                                         info.name, info.parameters.size(), argument));
    const std::size_t number =
        equals == std::string_view::npos ? position : parameter_number(info, argument.substr(0, equals));
    const std::string_view text = equals == std::string_view::npos ? argument : argument.substr(equals + 1);
    spec.values[number] = checked_value(info, info.parameters[number], text);
}

} // namespace

const std::vector<AttackInfo>& known_attacks() {
    static const std::vector<AttackInfo> infos = [] {
        std::vector<AttackInfo> all;
        for (const RegistryEntry& entry : registry())
            all.push_back(entry.info);
        return all;
    }();
    return infos;
}

std::string describe_known_attacks() {
    std::string text;
    for (const AttackInfo& info : known_attacks()) {
        text += fmt::format("{}: {}{}\n", info.name, info.summary,
                            info.available ? "" : " (not in this build: it needs OpenVDB)");
        for (const Parameter& parameter : info.parameters)
            text += fmt::format("    {}: {}{}{}, by default {}\n", parameter.name, parameter.meaning,
                                parameter.meaning.empty() ? "" : "; ", range_of(parameter),
                                value_text(parameter, parameter.fallback));
    }
    return text;
}

AttackSpec parse(std::string_view text) {
    const std::size_t colon = text.find(':');
    const AttackInfo& info = find_entry(text.substr(0, colon)).info;
    AttackSpec spec{std::string(info.name), {}};
    for (const Parameter& parameter : info.parameters)
        spec.values.push_back(parameter.fallback);
    if (colon == std::string_view::npos)
        return spec;
    std::size_t position = 0;
    for (std::string_view argument : split(text.substr(colon + 1), ','))
        read_argument(info, argument, position++, spec);
    return spec;
}

std::vector<AttackSpec> parse_chain(std::string_view text) {
    std::vector<AttackSpec> chain;
    for (std::string_view part : split(text, '+'))
        chain.push_back(parse(part));
    return chain;
}

std::string to_string(const AttackSpec& spec) {
    const AttackInfo& info = find_entry(spec.name).info;
    std::string text = spec.name;
    bool in_order = true; // values may go without a name until one is left out
    char separator = ':';
    for (std::size_t i = 0; i < info.parameters.size(); ++i) {
        const Parameter& parameter = info.parameters[i];
        if (i > 0 && spec.values[i] == parameter.fallback) {
            in_order = false;
            continue;
        }
        text += fmt::format("{}{}{}", separator, in_order ? "" : fmt::format("{}=", parameter.name),
                            value_text(parameter, spec.values[i]));
        separator = ',';
    }
    return text;
}

std::string to_string(const std::vector<AttackSpec>& chain) {
    std::string text;
    for (const AttackSpec& spec : chain)
        text += fmt::format("{}{}", text.empty() ? "" : "+", to_string(spec));
    return text;
}

std::vector<AttackSpec> published_benchmark() {
    std::vector<AttackSpec> specs;
    for (std::string_view text : {"file",
                                  "similarity",
                                  "noise:0.05",
                                  "noise:0.1",
                                  "noise:0.3",
                                  "noise:0.5",
                                  "smoothing:5",
                                  "smoothing:10",
                                  "smoothing:30",
                                  "smoothing:50",
                                  "quantization:11",
                                  "quantization:10",
                                  "quantization:9",
                                  "quantization:8",
                                  "quantization:7",
                                  "subdivision:midpoint",
                                  "subdivision:sqrt3",
                                  "subdivision:loop",
                                  "simplification:10",
                                  "simplification:30",
                                  "simplification:50",
                                  "simplification:70",
                                  "simplification:90",
                                  "simplification:95",
                                  "simplification:97.5",
                                  "cropping:10",
                                  "cropping:30",
                                  "cropping:50"})
        specs.push_back(parse(text));
    return specs;
}

} // namespace wm3d::attack
