// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Attacks by name: the catalogue, and the text form `noise:0.3`, `crop:30,cap=yes`,
/// `noise:0.1+smoothing:5`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wm3d::attack {

/// One parameter of an attack: a number in [min, max], a whole number, or one of a few words.
struct Parameter {
    enum class Type { real, whole, choice };

    std::string_view name;
    std::string_view meaning; ///< with its unit
    Type type = Type::real;
    double fallback = 0; ///< value where the text names none; for a choice, a number into `choices`
    double min = 0;
    double max = 0;
    std::vector<std::string_view> choices{};
};

/// One attack of the catalogue.
struct AttackInfo {
    std::string_view name;
    std::string_view alias; ///< the verb, also understood by `parse`; may be empty
    std::string_view summary;
    std::vector<Parameter> parameters; ///< in the order in which values without a name are taken
    bool available = true;             ///< false where this build lacks the library that it needs
};

/// Every attack, those of the published benchmark first.
const std::vector<AttackInfo>& known_attacks();

/// The catalogue as lines of text for help and error messages.
std::string describe_known_attacks();

/// An attack with all its parameters.
struct AttackSpec {
    std::string name;
    std::vector<double> values; ///< one for each of AttackInfo::parameters; of a choice, its number

    bool operator==(const AttackSpec&) const = default;
};

/// Reads `NAME`, `NAME:VALUE,VALUE,...` or `NAME:PARAMETER=VALUE,...` (values without a name come first).
/// \throw ParameterError  for an unknown name or parameter (listing the known), or a value outside its range
AttackSpec parse(std::string_view text);

/// Reads attacks joined by `+`, to be applied from left to right.
/// \throw ParameterError  as `parse`
std::vector<AttackSpec> parse_chain(std::string_view text);

/// The shortest text that `parse` turns into `spec`: parameters at their fallback are left out.
std::string to_string(const AttackSpec& spec);
std::string to_string(const std::vector<AttackSpec>& chain);

/// The published benchmark: every attack at every intensity of Wang, Lavoue, Denis, Baskurt (SMI 2010).
std::vector<AttackSpec> published_benchmark();

} // namespace wm3d::attack
