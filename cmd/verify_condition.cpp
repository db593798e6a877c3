// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify_condition.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/io/file.hpp>

namespace wm3d::cmd {

namespace {

std::string requirement(const Condition& condition) {
    return fmt::format("the key{} fixed before the suspect was seen",
                       condition.uses_receipt ? ", the settings and the receipt were"
                                              : " and the settings were");
}

/// What the commitment doesn't fix of what was used; empty if it fixes all.
std::string uncovered(const Condition& condition) {
    const bool settings = !condition.coverage.settings;
    const bool receipt = condition.uses_receipt && condition.coverage.receipt != true;
    return settings && receipt ? "not the settings or the receipt that were used here"
           : settings          ? "not the settings that were used here"
           : receipt           ? "not the receipt that was used here"
                               : "";
}

} // namespace

Condition condition_of(const std::string& commitment_file, const key::Key& key,
                       const commitment::Settings& settings, const std::optional<std::string>& receipt_text) {
    Condition condition;
    condition.uses_receipt = receipt_text.has_value();
    if (commitment_file.empty())
        return condition;
    const std::string text = io::read_file(commitment_file);
    condition.commitment_file = commitment_file;
    condition.commitment_sha256 = resync::digest_of(text).sha256;
    condition.coverage = commitment::check(commitment::parse_commitment(text, commitment_file), key, settings,
                                           receipt_text, commitment_file);
    return condition;
}

std::string condition_line(const Condition& condition) {
    std::string line =
        fmt::format("condition       p counts random keys, so it holds if {}", requirement(condition));
    if (condition.commitment_file.empty())
        return line + "; --commitment can show that\n";
    const std::string missing = uncovered(condition);
    return line +
           fmt::format(";\n                {} fixes {}: what dates its SHA-256 {}... shows since when\n",
                       condition.commitment_file, missing.empty() ? "all of it" : "the key, but " + missing,
                       condition.commitment_sha256.substr(0, 16));
}

nlohmann::ordered_json to_json(const Condition& condition) {
    nlohmann::ordered_json json{{"holds_if", requirement(condition)}};
    if (condition.commitment_file.empty())
        return json;
    json["commitment"] = {{"file", condition.commitment_file},
                          {"sha256", condition.commitment_sha256},
                          {"fixes_key", true},
                          {"fixes_settings", condition.coverage.settings}};
    if (condition.coverage.receipt)
        json["commitment"]["fixes_receipt"] = *condition.coverage.receipt;
    return json;
}

} // namespace wm3d::cmd
