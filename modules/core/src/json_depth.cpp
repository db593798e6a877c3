// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/json_depth.hpp>

#include <algorithm>
#include <string>

#include <wm3d/core/error.hpp>

namespace wm3d {

std::size_t json_depth(std::string_view text) {
    std::size_t depth = 0, deepest = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string && c == '\\')
            ++i;
        else if (c == '"')
            in_string = !in_string;
        else if (!in_string && (c == '[' || c == '{'))
            deepest = std::max(deepest, ++depth);
        else if (!in_string && (c == ']' || c == '}') && depth > 0)
            --depth;
    }
    return deepest;
}

void check_json_depth(std::string_view text, std::string_view name) {
    const std::size_t depth = json_depth(text);
    if (depth > max_json_depth)
        throw InputError(std::string(name) + ": brackets nest " + std::to_string(depth) +
                         " deep in its JSON, and wm3d reads no more than " + std::to_string(max_json_depth) +
                         "; the file is damaged, or made to do harm");
}

} // namespace wm3d
