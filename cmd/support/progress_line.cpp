// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/progress_line.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "support/streams.hpp"

namespace wm3d::cmd {

namespace {

constexpr std::size_t bar_columns = 24;

std::size_t terminal_columns() {
    winsize size{};
    if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
        return size.ws_col;
    return 80;
}

} // namespace

std::string progress_text(std::string_view stage, double done, std::size_t width) {
    done = std::isfinite(done) ? std::clamp(done, 0.0, 1.0) : 0.0;
    const std::string percent = fmt::format("{:3.0f} %", std::floor(100 * done));
    if (width < percent.size())
        return {};
    const std::size_t room = width - percent.size();
    if (room < 2)
        return percent;
    const std::string name(stage.substr(0, room - 1));
    if (room < name.size() + bar_columns + 4)
        return fmt::format("{} {}", name, percent);
    const auto filled = static_cast<std::size_t>(std::floor(done * static_cast<double>(bar_columns)));
    return fmt::format("{} [{:<{}}] {}", name, std::string(filled, '#'), bar_columns, percent);
}

std::string time_left(double seconds, double done) {
    if (!(seconds >= 3 && done >= 0.02 && done < 1))
        return {};
    const double left = std::ceil(seconds / done * (1 - done));
    return left < 100 ? fmt::format(", {:.0f} s left", left)
                      : fmt::format(", {:.0f} min left", std::ceil(left / 60));
}

void ProgressLine::update(std::string_view stage, double done) {
    const auto now = std::chrono::steady_clock::now();
    if (stage != stage_) {
        stage_ = stage;
        stage_begin_ = now;
    }
    if (visible_ && now - drawn_at_ < std::chrono::milliseconds(100))
        return;
    const double seconds = std::chrono::duration<double>(now - stage_begin_).count();
    // The last column stays free: writing there makes some terminals scroll.
    write_message(fmt::format(
        "\r\033[K{}", progress_text(stage_ + time_left(seconds, done), done, terminal_columns() - 1)));
    drawn_at_ = now;
    visible_ = true;
}

void ProgressLine::clear() {
    if (visible_)
        write_message("\r\033[K");
    visible_ = false;
}

} // namespace wm3d::cmd
