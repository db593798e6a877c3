// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_text.hpp"

namespace wm3d::io {

namespace {

std::size_t skip_space(std::string_view text, std::size_t at) {
    const std::size_t next = text.find_first_not_of(" \t\r\n", at);
    return next == std::string_view::npos ? text.size() : next;
}

/// End of the string that begins with the quote at `at`.
std::size_t string_end(std::string_view text, std::size_t at) {
    for (++at; at < text.size() && text[at] != '"'; ++at)
        if (text[at] == '\\')
            ++at;
    return at < text.size() ? at + 1 : text.size();
}

/// End of the value that begins at `at`; depth is counted, not recursed into.
std::size_t value_end(std::string_view text, std::size_t at) {
    std::size_t depth = 0;
    while (at < text.size()) {
        const char c = text[at];
        if (c == '"') {
            at = string_end(text, at);
        } else if (c == '{' || c == '[') {
            ++depth;
            ++at;
        } else if (c == '}' || c == ']') {
            if (depth == 0)
                return at; // of a number or word that the bracket's owner ends with
            --depth;
            ++at;
        } else if (depth > 0) {
            ++at;
            continue;
        } else {
            at = text.find_first_of(",}] \t\r\n", at);
            return at == std::string_view::npos ? text.size() : at;
        }
        if (depth == 0)
            return at;
    }
    return text.size();
}

} // namespace

std::vector<JsonSpan> json_elements(std::string_view text, JsonSpan array) {
    std::vector<JsonSpan> elements;
    if (array.begin >= array.end || text[array.begin] != '[')
        return elements;
    std::size_t at = skip_space(text, array.begin + 1);
    while (at + 1 < array.end) {
        const std::size_t end = value_end(text, at);
        elements.push_back({at, end});
        at = skip_space(text, end);
        if (at < array.end && text[at] == ',')
            at = skip_space(text, at + 1);
    }
    return elements;
}

std::optional<JsonSpan> json_member(std::string_view text, JsonSpan object, std::string_view key) {
    std::optional<JsonSpan> found;
    if (object.begin >= object.end || text[object.begin] != '{')
        return found;
    std::size_t at = skip_space(text, object.begin + 1);
    while (at + 1 < object.end) {
        const std::size_t key_end = string_end(text, at);
        const std::string_view name = text.substr(at + 1, key_end - at - 2);
        at = skip_space(text, skip_space(text, key_end) + 1); // over the colon
        const std::size_t end = value_end(text, at);
        if (name == key)
            found = JsonSpan{at, end};
        at = skip_space(text, end);
        if (at < object.end && text[at] == ',')
            at = skip_space(text, at + 1);
    }
    return found;
}

JsonSpan json_root(std::string_view text) {
    const std::size_t begin = skip_space(text, text.starts_with("\xef\xbb\xbf") ? 3 : 0);
    return {begin, value_end(text, begin)};
}

std::string edited(std::string_view text, const JsonEdits& edits) {
    std::string out;
    std::size_t copied = 0;
    for (const auto& [begin, edit] : edits) {
        out.append(text, copied, begin - copied);
        out.append(edit.second);
        copied = edit.first.end;
    }
    out.append(text, copied);
    return out;
}

} // namespace wm3d::io
