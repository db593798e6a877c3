// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/resync/receipt.hpp>

#include <array>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sodium.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/hex.hpp>
#include <wm3d/core/json_depth.hpp>
#include <wm3d/core/json_number.hpp>

#include "template_text.hpp"

namespace wm3d::resync {

namespace {

using nlohmann::ordered_json;

constexpr std::string_view schema = "wm3d.receipt/";

constexpr std::size_t digest_digits = 64;

/// BLAKE2b-256: tells a damaged receipt, not a forged one.
std::string check_sum(std::string_view text) {
    std::array<unsigned char, digest_digits / 2> sum{};
    crypto_generichash(sum.data(), sum.size(), reinterpret_cast<const unsigned char*>(text.data()),
                       text.size(), nullptr, 0);
    return to_hex(sum);
}

/// Whether every byte of the text but the digits of its digest is as it was written.
bool is_whole(std::string_view text, const ordered_json& json, int version) {
    const auto member = json.find("digest");
    if (member == json.end() || !member->is_string())
        return false;
    const auto& digest = member->get_ref<const std::string&>();
    if (version == 1) { // of the object without its digest, printed again without blanks
        ordered_json rest = json;
        rest.erase("digest");
        return check_sum(rest.dump()) == digest;
    }
    const std::size_t at = text.rfind(digest);
    return digest.size() == digest_digits && at != std::string_view::npos &&
           check_sum(std::string(text.substr(0, at)).append(text.substr(at + digest_digits))) == digest;
}

ordered_json to_json(const Vec3& v) {
    return {v[0], v[1], v[2]};
}

ordered_json to_json(const FileDigest& file) {
    return {{"sha256", file.sha256}, {"bytes", file.bytes}};
}

Vec3 vector_from(const ordered_json& json) {
    const auto values = json.get<std::array<double, 3>>();
    return {values[0], values[1], values[2]};
}

FileDigest digest_from(const ordered_json& json) {
    return {json.at("sha256").get<std::string>(), whole_number<std::uint64_t>(json.at("bytes"))};
}

Frame frame_from(const ordered_json& json) {
    Frame frame;
    frame.centroid = vector_from(json.at("centroid"));
    for (int k = 0; k < 3; ++k)
        frame.axes.row(k) = vector_from(json.at("axes").at(static_cast<std::size_t>(k))).transpose();
    frame.scale = json.at("scale").get<double>();
    return frame;
}

bool is_frame(const Frame& frame) {
    const bool rotation = (frame.axes * frame.axes.transpose() - Mat3::Identity()).norm() < 1e-9;
    return rotation && frame.centroid.allFinite() && std::isfinite(frame.scale) && frame.scale > 0;
}

Receipt receipt_from(const ordered_json& json) {
    Receipt receipt;
    receipt.tool = json.at("tool").get<std::string>();
    receipt.key_name = json.at("key").at("fingerprint").get<std::string>();
    receipt.key_commitment = json.at("key").at("commitment").get<std::string>();
    receipt.original = digest_from(json.at("files").at("original"));
    receipt.marked = digest_from(json.at("files").at("marked"));
    const ordered_json& mark = json.at("mark");
    receipt.base_vertices = whole_number<std::uint64_t>(mark.at("base_vertices"));
    receipt.level = whole_number<unsigned>(mark.at("level"));
    receipt.gamma = mark.at("gamma").get<double>();
    receipt.rmax = mark.at("rmax").get<double>();
    receipt.rms_percent = mark.at("rms_percent").get<double>();
    receipt.frame = frame_from(json.at("frame"));
    const ordered_json& points = json.at("template");
    const Box box{vector_from(points.at("min")), vector_from(points.at("max"))};
    if (auto decoded = decode(points.at("data").get<std::string>(), box))
        receipt.pose_template = std::move(*decoded);
    return receipt;
}

/// The part of "schema" after its name; 0 if it is no receipt's.
int version_of(const ordered_json& json) {
    const auto found = json.is_object() ? json.find("schema") : json.end();
    if (!json.is_object() || found == json.end() || !found->is_string())
        return 0;
    const auto name = found->get<std::string>();
    return name.starts_with(schema) ? std::atoi(name.c_str() + schema.size()) : 0;
}

/// The JSON of the receipt after the checks that need no knowledge of its fields but the digest's.
ordered_json checked_json(std::string_view text, std::string_view file_name) {
    check_json_depth(text, file_name);
    ordered_json json = ordered_json::parse(text, nullptr, false);
    if (json.is_discarded())
        throw InputError(
            fmt::format("{}: not a complete receipt (it holds {} bytes that are no whole JSON text); give "
                        "the file that `mark --receipt` wrote, uncut",
                        file_name, text.size()));
    const int version = version_of(json);
    if (version == 0)
        throw InputError(fmt::format(
            "{}: this is no receipt of wm3d; give the file that `mark --receipt` wrote", file_name));
    if (version > Receipt::format_version)
        throw InputError(
            fmt::format("{}: the receipt has format {}, and this wm3d reads up to {}; use a newer wm3d",
                        file_name, version, Receipt::format_version),
            ErrorCode::newer_version);
    if (!is_whole(text, json, version))
        throw InputError(
            fmt::format("{}: the receipt was altered after it was written (its digest doesn't fit); give an "
                        "untouched copy",
                        file_name),
            ErrorCode::altered_input);
    return json;
}

} // namespace

FileDigest digest_of(std::string_view bytes) {
    std::array<unsigned char, crypto_hash_sha256_BYTES> sum{};
    crypto_hash_sha256(sum.data(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    return {to_hex(sum), bytes.size()};
}

std::string to_text(const Receipt& receipt) {
    const Box box = bounding_box(receipt.pose_template.points);
    ordered_json axes = ordered_json::array();
    for (int k = 0; k < 3; ++k)
        axes.push_back(to_json(Vec3(receipt.frame.axes.row(k).transpose())));
    ordered_json json{
        {"schema", fmt::format("{}{}", schema, Receipt::format_version)},
        {"tool", receipt.tool},
        {"key", {{"fingerprint", receipt.key_name}, {"commitment", receipt.key_commitment}}},
        {"files", {{"original", to_json(receipt.original)}, {"marked", to_json(receipt.marked)}}},
        {"mark",
         {{"base_vertices", receipt.base_vertices},
          {"level", receipt.level},
          {"gamma", receipt.gamma},
          {"rmax", receipt.rmax},
          {"rms_percent", receipt.rms_percent}}},
        {"frame",
         {{"centroid", to_json(receipt.frame.centroid)}, {"axes", axes}, {"scale", receipt.frame.scale}}},
        {"template",
         {{"min", to_json(box.min)},
          {"max", to_json(box.max)},
          {"data", encode(receipt.pose_template, box)}}}};
    json["digest"] = "";
    std::string text = json.dump(2) + "\n";
    const std::string digest = check_sum(text);
    return text.insert(text.rfind('"'), digest);
}

Receipt parse_receipt(std::string_view text, std::string_view file_name) {
    const ordered_json json = checked_json(text, file_name);
    try {
        Receipt receipt = receipt_from(json);
        if (is_frame(receipt.frame) && !receipt.pose_template.points.empty())
            return receipt;
    } catch (const ordered_json::exception&) {
        // told below, in the words of the receipt and not of the JSON library
    }
    throw InputError(
        fmt::format("{}: a field of the receipt is missing or out of range; give the file that `mark "
                    "--receipt` wrote",
                    file_name));
}

} // namespace wm3d::resync
