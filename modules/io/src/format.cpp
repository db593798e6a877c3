// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/io/format.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace wm3d::io {

namespace {

constexpr std::array<std::string_view, 6> names{"obj", "ply", "stl", "off", "gltf", "glb"};

bool starts_with_word(std::string_view text, std::string_view word) {
    return text.starts_with(word) &&
           (text.size() == word.size() || std::isspace(static_cast<unsigned char>(text[word.size()])) != 0);
}

} // namespace

std::string_view name_of(Format format) {
    return names[static_cast<std::size_t>(format)];
}

std::optional<Format> format_of_name(std::string_view name) {
    std::string ending(name.substr(name.rfind('.') + 1)); // npos + 1 is 0: a bare name
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto found = std::find(names.begin(), names.end(), ending);
    if (found == names.end())
        return std::nullopt;
    return static_cast<Format>(found - names.begin());
}

std::optional<Format> format_of_content(std::string_view bytes) {
    if (bytes.starts_with("glTF"))
        return Format::glb;
    if (starts_with_word(bytes, "ply"))
        return Format::ply;
    for (std::string_view word : {"OFF", "COFF", "NOFF", "CNOFF", "STOFF"})
        if (starts_with_word(bytes, word))
            return Format::off;
    if (starts_with_word(bytes, "solid") && bytes.substr(0, 1000).find("facet") != std::string_view::npos)
        return Format::stl;
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    if (first != std::string_view::npos && bytes[first] == '{' &&
        bytes.find("\"asset\"") != std::string_view::npos)
        return Format::gltf;
    return std::nullopt;
}

} // namespace wm3d::io
