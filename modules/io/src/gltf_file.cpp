// SPDX-License-Identifier: GPL-3.0-or-later
#include "gltf_file.hpp"

#include <bit>
#include <cctype>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include <wm3d/core/base64.hpp>
#include <wm3d/core/json_depth.hpp>

#include "binary.hpp"

namespace wm3d::io {

namespace {

constexpr std::size_t glb_header = 12, chunk_header = 8;

std::size_t u32_at(std::string_view bytes, std::size_t offset) {
    return static_cast<std::size_t>(load(bytes.data() + offset, Scalar::u32, swaps(std::endian::little)));
}

/// %41 becomes A.
std::string percent_decoded(std::string_view uri) {
    std::string out;
    const auto digit = [](char c) {
        return std::isdigit(static_cast<unsigned char>(c)) != 0
                   ? c - '0'
                   : std::tolower(static_cast<unsigned char>(c)) - 'a' + 10;
    };
    for (std::size_t i = 0; i < uri.size(); ++i)
        if (uri[i] == '%' && i + 2 < uri.size() &&
            std::isxdigit(static_cast<unsigned char>(uri[i + 1])) != 0 &&
            std::isxdigit(static_cast<unsigned char>(uri[i + 2])) != 0) {
            out.push_back(static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2])));
            i += 2;
        } else {
            out.push_back(uri[i]);
        }
    return out;
}

} // namespace

GltfFile GltfFile::open(const Source& source, bool binary, const Resolver& resolver, const Limits& limits) {
    GltfFile file(source, limits);
    file.resolver_ = resolver;
    file.binary_ = binary;
    file.text_ = source.bytes;
    if (binary)
        file.split_chunks();
    file.parse_json();
    file.listed_buffers_ = gltf_array(source, file.json_, "buffers").size();
    file.buffers_.resize(file.listed_buffers_ + gltf_array(source, file.json_, "bufferViews").size());
    return file;
}

void GltfFile::split_chunks() {
    const std::string_view bytes = source_.bytes;
    if (!bytes.starts_with("glTF"))
        source_.fail("the file does not begin with \"glTF\", so it is no GLB file");
    if (bytes.size() < glb_header + chunk_header)
        source_.fail("the file ends inside its header; it is cut short");
    if (u32_at(bytes, 4) != 2)
        source_.fail(fmt::format("this is version {} of GLB; wm3d reads version 2", u32_at(bytes, 4)));
    if (u32_at(bytes, 8) != bytes.size())
        source_.fail(fmt::format("its header gives {} bytes, but the file has {}; it is cut short or damaged",
                                 u32_at(bytes, 8), bytes.size()));
    for (std::size_t at = glb_header; at < bytes.size();) {
        if (bytes.size() - at < chunk_header || u32_at(bytes, at) > bytes.size() - at - chunk_header)
            source_.fail_at_byte(at, "a chunk is longer than the file; it is cut short or damaged");
        const std::size_t length = u32_at(bytes, at);
        const std::string_view type = bytes.substr(at + 4, 4), data = bytes.substr(at + chunk_header, length);
        if (at == glb_header && type != "JSON")
            source_.fail_at_byte(at, "the first chunk is not JSON, so it is no GLB file");
        if (at == glb_header)
            text_ = data;
        else if (type == std::string_view("BIN\0", 4) && chunk_offset_ == 0) {
            chunk_ = data;
            chunk_offset_ = at + chunk_header;
        }
        at += chunk_header + length;
    }
}

void GltfFile::parse_json() {
    check_json_depth(text_, source_.name);
    try {
        json_ = Json::parse(text_.begin(), text_.end());
    } catch (const Json::parse_error& error) {
        source_.fail(fmt::format("its JSON is damaged or cut short near its byte {}", error.byte));
    }
    if (!json_.is_object() || !json_.contains("asset"))
        source_.fail("its JSON has no \"asset\", so it is no glTF file");
    const Json& asset = json_["asset"];
    const std::string version =
        asset.is_object() && asset.contains("version") ? asset["version"].dump() : "unknown";
    if (!version.starts_with("\"2"))
        source_.fail(fmt::format("this is version {} of glTF; wm3d reads version 2", version));
}

std::string_view GltfFile::buffer(std::size_t number) {
    if (number >= buffers_.size() || (number >= listed_buffers_ && !buffers_[number].loaded))
        source_.fail(fmt::format("it names buffer {}, but has {}", number, listed_buffers_));
    if (!buffers_[number].loaded)
        load(number);
    return buffers_[number].bytes;
}

std::size_t GltfFile::unpacked_view(std::size_t view, std::size_t size,
                                    const std::function<std::string()>& unpack) {
    Buffer& buffer = buffers_[listed_buffers_ + view];
    if (!buffer.loaded) {
        if (static_cast<double>(unpacked_bytes_) + static_cast<double>(size) >
            limits_.unpacked_per_byte * static_cast<double>(asset_bytes_))
            source_.fail(
                fmt::format("its packed buffer views would grow beyond {:g} times the size of its files; "
                            "if you trust it, say --any-size",
                            limits_.unpacked_per_byte));
        unpacked_bytes_ += size;
        buffer.home = Home::unpacked;
        buffer.own = std::make_shared<const std::string>(unpack());
        buffer.bytes = *buffer.own;
        buffer.loaded = true;
    }
    return listed_buffers_ + view;
}

void GltfFile::load(std::size_t number) {
    Buffer& buffer = buffers_[number];
    const Json& entry = gltf_entry(source_, json_, "buffers", number);
    if (const auto uri = entry.find("uri"); uri == entry.end()) {
        if (!binary_ || number != 0 || chunk_offset_ == 0)
            source_.fail(fmt::format("buffer {} has neither a uri nor a binary chunk", number));
        buffer.home = Home::chunk;
        buffer.bytes = chunk_;
    } else if (!uri->is_string()) {
        source_.fail(fmt::format("the uri of buffer {} is no string", number));
    } else if (const auto& text = uri->get_ref<const std::string&>(); text.starts_with("data:")) {
        const std::size_t comma = text.find(',');
        auto bytes = comma == std::string::npos || !text.substr(0, comma).ends_with(";base64")
                         ? std::nullopt
                         : from_base64(std::string_view(text).substr(comma + 1));
        if (!bytes)
            source_.fail(fmt::format("the data: uri of buffer {} is no base64", number));
        buffer.home = Home::inline_uri;
        buffer.uri_prefix = text.substr(0, comma + 1);
        buffer.own = std::make_shared<const std::string>(std::move(*bytes));
        buffer.bytes = *buffer.own;
    } else {
        buffer.own = beside(number, percent_decoded(text));
        buffer.bytes = *buffer.own;
    }
    const std::size_t length = gltf_size(source_, entry, "byteLength", buffer.bytes.size());
    if (length > buffer.bytes.size())
        source_.fail(fmt::format("buffer {} should have {} bytes, but has {}; it is cut short", number,
                                 length, buffer.bytes.size()));
    buffer.bytes = buffer.bytes.substr(0, length);
    buffer.loaded = true;
}

/// The file behind a URI. Each is read once, however many buffers name it.
std::shared_ptr<const std::string> GltfFile::beside(std::size_t number, const std::string& uri) {
    if (!resolver_)
        source_.fail(fmt::format("buffer {} is in another file ({}), which is out of reach here", number,
                                 uri.substr(0, 60)));
    std::shared_ptr<const std::string>& file =
        beside_[std::filesystem::path(uri).lexically_normal().string()];
    if (!file) {
        file = std::make_shared<const std::string>(resolver_(uri));
        asset_bytes_ += file->size();
    }
    return file;
}

void GltfFile::check_shown(double count, std::string_view what) const {
    const double most =
        std::max(static_cast<double>(limits_.always), limits_.per_byte * static_cast<double>(asset_bytes_));
    if (count > most)
        source_.fail(
            fmt::format("it shows more than {:.0f} {}, out of files of {} bytes; if you trust it, say "
                        "--any-size",
                        most, what, asset_bytes_));
}

const Json& gltf_array(const Source& source, const Json& object, const char* key) {
    static const Json empty = Json::array();
    const auto found = object.find(key);
    if (found == object.end())
        return empty;
    if (!found->is_array())
        source.fail(fmt::format("\"{}\" in its JSON is no array", key));
    return *found;
}

std::size_t gltf_size(const Source& source, const Json& object, const char* key, std::size_t missing) {
    const auto found = object.find(key);
    if (found == object.end())
        return missing;
    if (!found->is_number_unsigned())
        source.fail(
            fmt::format("\"{}\" in its JSON is {}, but should be a whole number from 0", key, found->dump()));
    return found->get<std::size_t>();
}

const Json& gltf_entry(const Source& source, const Json& root, const char* key, std::size_t number) {
    const Json& array = gltf_array(source, root, key);
    if (number >= array.size())
        source.fail(
            fmt::format("its JSON names entry {} of \"{}\", but there are {}", number, key, array.size()));
    if (!array[number].is_object())
        source.fail(fmt::format("entry {} of \"{}\" in its JSON is no object", number, key));
    return array[number];
}

} // namespace wm3d::io
