// SPDX-License-Identifier: GPL-3.0-or-later
// The text of a key file. A line is `field: value`; lines that start with # are for people. The last line is
// a BLAKE2b checksum of all lines before it, without their line ends, so that a changed line end does no
// harm.
#include <wm3d/key/key_file.hpp>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sodium.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/hex.hpp>
#include <wm3d/core/utf8.hpp>
#include <wm3d/core/version.hpp>
#include <wm3d/key/stream.hpp>

#include "protection.hpp"
#include "sodium.hpp"

namespace wm3d::key {

namespace {

constexpr std::string_view first_line = "wm3d key, version ";
constexpr std::string_view checksum_field = "checksum: ";

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        lines.push_back(line);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    while (!lines.empty() && lines.back().empty())
        lines.pop_back();
    return lines;
}

std::string checksum(std::span<const std::string_view> lines) {
    std::string joined = fmt::format("{}\n", fmt::join(lines, "\n"));
    std::array<std::uint8_t, 16> digest;
    blake2b(digest, bytes_of(joined), {});
    wipe(joined);
    return to_hex(digest);
}

template<typename Number>
std::optional<Number> parse_number(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return number;
}

std::optional<std::vector<unsigned>> parse_levels(std::string_view text) {
    std::vector<unsigned> levels;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        const auto level = parse_number<unsigned>(text.substr(0, end));
        if (!level)
            return std::nullopt;
        levels.push_back(*level);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return levels;
}

std::optional<Secret> parse_secret(std::string_view text) {
    std::array<std::uint8_t, Secret::size> bytes;
    std::size_t length = 0;
    if (text.size() != 2 * bytes.size() ||
        sodium_hex2bin(bytes.data(), bytes.size(), text.data(), text.size(), nullptr, &length, nullptr) != 0)
        return std::nullopt;
    const std::optional<Secret> secret = length == bytes.size() ? std::optional(Secret(bytes)) : std::nullopt;
    sodium_memzero(bytes.data(), bytes.size());
    return secret;
}

/// Nothing if the name may stand in a key file, else what is wrong with it.
std::string_view fault_of_name(std::string_view name) {
    if (name.size() > 200)
        return "the name is longer than 200 bytes";
    if (!is_utf8(name))
        return "the name is not UTF-8";
    if (std::ranges::any_of(name, [](unsigned char c) { return c < 0x20 || c == 0x7f; }))
        return "the name has a line end or another control character";
    if (name.starts_with(' ') || name.ends_with(' '))
        return "the name starts or ends with a space";
    return {};
}

/// Nothing if the parameters are in range, else what is wrong with them.
std::string_view fault_of_parameters(const PublicParameters& parameters) {
    const std::vector<unsigned>& levels = parameters.levels;
    if (levels.empty() || levels.back() > max_level ||
        std::ranges::adjacent_find(levels, std::greater_equal<>{}) != levels.end())
        return "levels must be ascending numbers from 0 to 9";
    if (!(parameters.rmax > 0 && parameters.rmax < 1))
        return "rmax must lie between 0 and 1";
    if (!(parameters.reference_strength > 0 && parameters.reference_strength <= 100))
        return "reference-strength must lie between 0 and 100 %";
    return {};
}

/// The fields of a key file, each of which must be there once.
class Fields {
public:
    Fields(std::span<const std::string_view> lines, std::string_view file_name) : file_name_(file_name) {
        for (std::size_t i = 1; i < lines.size(); ++i) {
            if (lines[i].empty() || lines[i].starts_with('#'))
                continue;
            const std::size_t colon = std::min(lines[i].find(": "), lines[i].size());
            std::string_view value = lines[i].substr(colon);
            value.remove_prefix(std::min<std::size_t>(2, value.size()));
            if (!values_.try_emplace(lines[i].substr(0, colon), value).second)
                fail(fmt::format("line {} repeats a field", i + 1));
        }
    }

    /// The value of a field as `parse` reads it.
    template<typename Parse>
    auto take(std::string_view field, Parse&& parse) {
        const auto found = values_.find(field);
        if (found == values_.end())
            fail(fmt::format("the field '{}' is missing", field));
        auto value = parse(found->second);
        if (!value)
            fail(fmt::format("the value of '{}' can't be read", field));
        values_.erase(found);
        return *std::move(value);
    }

    void expect_no_more() const {
        if (!values_.empty())
            fail("it has a field that its version doesn't know");
    }

    [[noreturn]] void fail(std::string_view fault) const {
        throw InputError(
            fmt::format("{}: this key file has a fault: {}; take it from a backup", file_name_, fault));
    }

private:
    std::map<std::string_view, std::string_view> values_;
    std::string_view file_name_;
};

/// Checks first line and checksum.
/// \return  the version
unsigned check_envelope(std::span<const std::string_view> lines, std::string_view file_name) {
    const auto version = lines.empty() || !lines[0].starts_with(first_line)
                             ? std::nullopt
                             : parse_number<unsigned>(lines[0].substr(first_line.size()));
    if (!version || *version == 0)
        throw InputError(fmt::format("{}: this is not a key file of wm3d, whose first line is '{}1' or "
                                     "'{}2'; name the file that keygen wrote",
                                     file_name, first_line, first_line));
    if (*version > Key::format_version)
        throw InputError(
            fmt::format(
                "{}: this key file has version {} and this wm3d understands version {}; use a newer wm3d",
                file_name, *version, Key::format_version),
            ErrorCode::newer_version);
    const std::string_view last = lines.back();
    if (!last.starts_with(checksum_field) || last.size() != checksum_field.size() + 32)
        throw InputError(
            fmt::format("{}: this key file was cut, its last line is not the checksum; take it from a backup",
                        file_name),
            ErrorCode::altered_input);
    if (last.substr(checksum_field.size()) != checksum(lines.first(lines.size() - 1)))
        throw InputError(
            fmt::format(
                "{}: this key file was altered, its checksum doesn't fit its text; take it from a backup",
                file_name),
            ErrorCode::altered_input);
    return *version;
}

/// The secret behind a passphrase.
/// \throw InputError
Secret ask_for_secret(const ProtectedSecret& box, std::string_view file_name, const AskPassphrase& ask) {
    if (!ask)
        throw InputError(
            fmt::format("{}: a passphrase protects this key, and there is nobody to ask for it; give "
                        "it with --passphrase-fd",
                        file_name));
    std::optional<Secret> secret = opened(box, ask());
    if (!secret)
        throw InputError(
            fmt::format("{}: the passphrase doesn't open this key; type it as it was when the key "
                        "was made",
                        file_name));
    return *std::move(secret);
}

} // namespace

Key::Key(std::string name, std::string created_by, PublicParameters parameters, Secret secret)
    : name_(std::move(name)), created_by_(std::move(created_by)), parameters_(std::move(parameters)),
      secret_(std::move(secret)) {}

Key Key::generate(std::string name, PublicParameters parameters) {
    for (const std::string_view fault : {fault_of_name(name), fault_of_parameters(parameters)})
        if (!fault.empty())
            throw ParameterError(fmt::format("the key can't be made: {}", fault));
    return Key(std::move(name), fmt::format("wm3d {}", version()), std::move(parameters), Secret::random());
}

Key Key::parse(std::string_view text, std::string_view file_name, const AskPassphrase& ask) {
    const std::vector<std::string_view> lines = lines_of(text);
    const unsigned version = check_envelope(lines, file_name);
    const std::span<const std::string_view> all(lines);
    Fields fields(all.first(all.size() - 1), file_name);
    const auto as_text = [](std::string_view value) { return std::optional(std::string(value)); };
    std::string name = fields.take("name", as_text);
    std::optional<Secret> secret;
    std::optional<ProtectedSecret> box;
    if (version == 1)
        secret = fields.take("secret", parse_secret);
    else
        box = fields.take("protected-secret", parse_protected);
    PublicParameters parameters;
    parameters.levels = fields.take("levels", parse_levels);
    parameters.rmax = fields.take("rmax", parse_number<double>);
    parameters.reference_strength = fields.take("reference-strength", parse_number<double>);
    std::string created_by = fields.take("created-by", as_text);
    fields.expect_no_more();
    if (!is_utf8(created_by))
        fields.fail("created-by is not UTF-8");
    for (const std::string_view fault : {fault_of_name(name), fault_of_parameters(parameters)})
        if (!fault.empty())
            fields.fail(fault);
    if (box) // asked for last: whatever else is wrong is told before anybody types
        secret = ask_for_secret(*box, file_name, ask);
    return Key(std::move(name), std::move(created_by), std::move(parameters), *std::move(secret));
}

std::string Key::to_text(const Passphrase* passphrase, const ProtectionCost& cost) const {
    std::string secret =
        passphrase != nullptr ? key::to_text(protect(secret_, *passphrase, cost)) : to_hex(secret_.bytes());
    std::string text = fmt::format(
        "{}{}\n# Keep this file secret and keep a copy: whoever has it{} can make and prove marks.\n"
        "name: {}\n{}: {}\nlevels: {}\nrmax: {}\nreference-strength: {}\ncreated-by: {}\n",
        first_line, passphrase != nullptr ? 2 : 1, passphrase != nullptr ? " and its passphrase" : "", name_,
        passphrase != nullptr ? "protected-secret" : "secret", secret, fmt::join(parameters_.levels, " "),
        parameters_.rmax, parameters_.reference_strength, created_by_);
    wipe(secret);
    text += fmt::format("{}{}\n", checksum_field, checksum(lines_of(text)));
    return text;
}

} // namespace wm3d::key
