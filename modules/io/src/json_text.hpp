// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Finding values in the text of a JSON document, so that they can be replaced and all other bytes
/// stay.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wm3d::io {

/// Bytes [begin, end) of a value.
struct JsonSpan {
    std::size_t begin = 0, end = 0;
};

/// Values of an array, in order; none if the value is no array.
/// \pre  the text is valid JSON
std::vector<JsonSpan> json_elements(std::string_view text, JsonSpan array);

/// Value of a member of an object; the last if there are several; nothing if the value is no object. Keys
/// that are spelt with escapes are not found.
/// \pre  the text is valid JSON
std::optional<JsonSpan> json_member(std::string_view text, JsonSpan object, std::string_view key);

/// The document's outermost value.
JsonSpan json_root(std::string_view text);

/// Replacements by where they begin; spans don't overlap.
using JsonEdits = std::map<std::size_t, std::pair<JsonSpan, std::string>>;

/// The text with every edit made.
std::string edited(std::string_view text, const JsonEdits& edits);

} // namespace wm3d::io
