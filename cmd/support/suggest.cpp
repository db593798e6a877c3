// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/suggest.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace wm3d::cmd {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    // Three rows of the table are alive: the swap looks two rows back.
    std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
        std::swap(before_last, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

std::optional<std::string_view> nearest_name(std::string_view word, std::span<const std::string_view> names) {
    std::size_t nearest = std::clamp<std::size_t>(word.size() / 3, 1, 3) + 1;
    std::optional<std::string_view> found;
    for (const std::string_view name : names)
        if (const std::size_t distance = edit_distance(word, name); distance < nearest) {
            nearest = distance;
            found = name;
        }
    return found;
}

} // namespace wm3d::cmd
