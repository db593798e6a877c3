// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  One line on the terminal that says how far the work has come.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

#include <wm3d/core/progress.hpp>

namespace wm3d::cmd {

/// The line's text in at most `width` columns: stage, bar, percentage; what doesn't fit is left out,
/// the bar first.
std::string progress_text(std::string_view stage, double done, std::size_t width);

/// ", 40 s left" if a stage goes on as it did for these seconds; empty while that says little.
std::string time_left(double seconds, double done);

/// Draws over its own line on standard error, ten times a second at most, and leaves nothing behind.
class ProgressLine {
public:
    ProgressLine() = default;
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void update(std::string_view stage, double done);

    /// Erases the line; other text may be written then.
    void clear();

private:
    std::chrono::steady_clock::time_point drawn_at_{}, stage_begin_{};
    std::string stage_;
    bool visible_ = false;
};

} // namespace wm3d::cmd
