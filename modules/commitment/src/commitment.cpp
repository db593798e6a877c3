// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/commitment/commitment.hpp>

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/core/error.hpp>
#include <wm3d/core/json_depth.hpp>
#include <wm3d/core/json_number.hpp>
#include <wm3d/core/version.hpp>

namespace wm3d::commitment {

namespace {

using nlohmann::ordered_json;

constexpr std::string_view schema = "wm3d.commitment/";

/// Version of the format; 0 if the text is no commitment.
int version_of(const ordered_json& json) {
    const auto found = json.is_object() ? json.find("schema") : json.end();
    if (!json.is_object() || found == json.end() || !found->is_string())
        return 0;
    const auto name = found->get<std::string>();
    return name.starts_with(schema) ? std::atoi(name.c_str() + schema.size()) : 0;
}

bool is_hex(std::string_view text, std::size_t digits) {
    return text.size() == digits && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

Commitment commitment_from(const ordered_json& json) {
    Commitment c;
    c.tool = json.at("tool").get<std::string>();
    const ordered_json& key = json.at("key");
    c.key_fingerprint = key.at("fingerprint").get<std::string>();
    c.key_commitment = key.at("commitment").get<std::string>();
    c.parameters.levels.clear();
    for (const ordered_json& level : key.at("levels"))
        c.parameters.levels.push_back(whole_number<unsigned>(level));
    c.parameters.rmax = key.at("rmax").get<double>();
    c.parameters.reference_strength = key.at("reference_strength").get<double>();
    c.settings.base_vertices = whole_number<std::uint64_t>(json.at("settings").at("base_vertices"));
    if (const auto receipt = json.find("receipt"); receipt != json.end())
        c.receipt = {receipt->at("sha256").get<std::string>(),
                     whole_number<std::uint64_t>(receipt->at("bytes"))};
    return c;
}

bool is_sound(const Commitment& c) {
    return is_hex(c.key_fingerprint, 16) && is_hex(c.key_commitment, 64) &&
           (!c.receipt || is_hex(c.receipt->sha256, 64));
}

} // namespace

Commitment commit_to(const key::Key& key, const Settings& settings,
                     const std::optional<std::string>& receipt) {
    Commitment c;
    c.tool = fmt::format("wm3d {}", version());
    c.key_fingerprint = key.fingerprint();
    c.key_commitment = key.commitment();
    c.parameters = key.parameters();
    c.settings = settings;
    if (receipt)
        c.receipt = resync::digest_of(*receipt);
    return c;
}

std::string to_text(const Commitment& c) {
    ordered_json json{{"schema", fmt::format("{}{}", schema, Commitment::format_version)},
                      {"tool", c.tool},
                      {"key",
                       {{"fingerprint", c.key_fingerprint},
                        {"commitment", c.key_commitment},
                        {"levels", c.parameters.levels},
                        {"rmax", c.parameters.rmax},
                        {"reference_strength", c.parameters.reference_strength}}},
                      {"settings", {{"base_vertices", c.settings.base_vertices}}}};
    if (c.receipt)
        json["receipt"] = {{"sha256", c.receipt->sha256}, {"bytes", c.receipt->bytes}};
    return json.dump(2) + "\n";
}

Commitment parse_commitment(std::string_view text, std::string_view file_name) {
    check_json_depth(text, file_name);
    const ordered_json json = ordered_json::parse(text, nullptr, false);
    const int version = json.is_discarded() ? 0 : version_of(json);
    if (version <= 0)
        throw InputError(fmt::format("{}: this is no commitment of wm3d, or a part of one; give the file "
                                     "that --commitment wrote, uncut",
                                     file_name));
    if (version > Commitment::format_version)
        throw InputError(
            fmt::format("{}: the commitment has format {}, and this wm3d reads up to {}; use a newer wm3d",
                        file_name, version, Commitment::format_version));
    try {
        Commitment c = commitment_from(json);
        if (is_sound(c))
            return c;
    } catch (const ordered_json::exception&) {
        // told below, in the words of the commitment and not of the JSON library
    }
    throw InputError(
        fmt::format("{}: a field of the commitment is missing or out of range; give the file that "
                    "--commitment wrote",
                    file_name));
}

Coverage check(const Commitment& c, const key::Key& key, const Settings& settings,
               const std::optional<std::string>& receipt, std::string_view file_name) {
    if (c.key_commitment != key.commitment() || c.key_fingerprint != key.fingerprint())
        throw InputError(fmt::format("{}: this is a commitment to key {}, not to key {}; give the key's own",
                                     file_name, c.key_fingerprint, key.fingerprint()));
    if (c.parameters != key.parameters())
        throw InputError(
            fmt::format("{}: the key's public parameters are not the ones that were committed to; "
                        "give the key as it was then",
                        file_name));
    Coverage coverage;
    coverage.settings = c.settings == settings;
    if (receipt && c.receipt && *c.receipt != resync::digest_of(*receipt))
        throw InputError(fmt::format(
            "{}: the receipt is not the one that was committed to; give that, or none", file_name));
    if (receipt)
        coverage.receipt = c.receipt.has_value();
    return coverage;
}

} // namespace wm3d::commitment
