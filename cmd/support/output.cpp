// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/output.hpp"

#include <cstdlib>
#include <exception>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "support/streams.hpp"

namespace wm3d::cmd {

namespace {

bool dumb_terminal() {
    const char* term = std::getenv("TERM");
    return term == nullptr || std::string_view(term) == "dumb";
}

std::string_view colour_of(Tone tone) {
    switch (tone) {
    case Tone::good:
        return "\033[1;32m";
    case Tone::bad:
        return "\033[1;31m";
    case Tone::warning:
        return "\033[1;33m";
    case Tone::plain:
        break;
    }
    return "";
}

/// Whether `descriptor` is a terminal on which colours are welcome.
bool wants_colour(int descriptor) {
    const char* no_color = std::getenv("NO_COLOR");
    return ::isatty(descriptor) == 1 && !dumb_terminal() && (no_color == nullptr || *no_color == '\0');
}

std::string coloured(std::string_view text, Tone tone, int descriptor) {
    if (tone == Tone::plain || !wants_colour(descriptor))
        return std::string(text);
    return fmt::format("{}{}\033[0m", colour_of(tone), text);
}

/// A file's name may hold line ends and what else steers a terminal; a message stays one line.
std::string one_line(std::string_view sentence) {
    std::string line(sentence);
    for (char& c : line)
        if (const auto byte = static_cast<unsigned char>(c); byte < 0x20 || byte == 0x7f)
            c = '?';
    return line;
}

/// A file name in a sentence may be no UTF-8, which JSON has to be.
std::string text_of(const nlohmann::ordered_json& object) {
    return object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string error_object(std::string_view sentence, ErrorCode code) {
    return text_of({{"schema", "wm3d.error/1"}, {"error", {{"code", name(code)}, {"message", sentence}}}});
}

} // namespace

void write_error(std::string_view who, std::string_view sentence, ErrorCode code, bool json) {
    write_message(
        fmt::format("{}: {} {}\n", who, coloured("error:", Tone::bad, STDERR_FILENO), one_line(sentence)));
    if (!json)
        return;
    try {
        write_all(STDOUT_FILENO, error_object(sentence, code));
    } catch (const std::exception&) {
        // Perhaps this is the very error: standard output can't be written. It was told above.
    }
}

Output::Output(std::string command, const OutputOptions& options)
    : command_(std::move(command)), options_(options) {}

void Output::say(std::string_view sentence) {
    if (!options_.quiet)
        tell(sentence);
}

void Output::detail(std::string_view sentence) {
    if (options_.verbose && !options_.quiet)
        tell(sentence);
}

void Output::warn(std::string_view sentence) {
    tell(fmt::format("{} {}", coloured("warning:", Tone::warning, STDERR_FILENO), one_line(sentence)));
}

void Output::fail(std::string_view sentence) {
    tell(fmt::format("{} {}", coloured("failed:", Tone::bad, STDERR_FILENO), one_line(sentence)));
}

void Output::fail(std::string_view sentence, ErrorCode code) {
    fail(sentence);
    if (options_.json)
        write_bytes(error_object(sentence, code));
}

void Output::tell(std::string_view line) {
    line_.clear();
    write_message(fmt::format("{}\n", line));
}

void Output::print(std::string_view text) {
    if (!options_.json)
        write_bytes(text);
}

void Output::print_json(const nlohmann::ordered_json& result, int version) {
    if (!options_.json)
        return;
    nlohmann::ordered_json object;
    object["schema"] = fmt::format("wm3d.{}/{}", command_, version);
    object.update(result);
    write_bytes(text_of(object));
}

void Output::write_bytes(std::string_view bytes) {
    line_.clear();
    write_all(STDOUT_FILENO, bytes);
}

std::string Output::toned(std::string_view text, Tone tone) const {
    return coloured(text, tone, STDOUT_FILENO);
}

Progress Output::progress() {
    if (options_.quiet || dumb_terminal() || ::isatty(STDERR_FILENO) != 1)
        return {};
    return [this](std::string_view stage, double done) { line_.update(stage, done); };
}

} // namespace wm3d::cmd
