// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/json_lines.hpp>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/core/error.hpp>

namespace wm3d::study {

using nlohmann::ordered_json;

namespace {

/// \return  how many bytes the lines that are complete have
std::uintmax_t read_lines(const std::string& path, const std::string& what, const JsonLines::Reader& reader) {
    std::ifstream in(path, std::ios::binary);
    std::string line;
    std::uintmax_t whole = 0;
    for (std::size_t number = 1; std::getline(in, line) && !in.eof(); ++number) {
        whole += line.size() + 1;
        try {
            reader(ordered_json::parse(line), number);
        } catch (const ordered_json::exception&) {
            throw InputError(
                fmt::format("{}: line {} is no {}; remove the line, or name a new file", path, number, what));
        }
    }
    return whole;
}

} // namespace

JsonLines::JsonLines(const std::string& path, const std::string& what, const Reader& reader) : path_(path) {
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored)) {
        const std::uintmax_t whole = read_lines(path, what, reader);
        was_empty_ = whole == 0;
        if (std::filesystem::file_size(path, ignored) != whole)
            std::filesystem::resize_file(path, whole, ignored);
    }
    file_.reset(std::fopen(path.c_str(), "ab"));
    if (!file_)
        throw OutputError(fmt::format("{}: the file can't be written: {}", path, std::strerror(errno)));
}

void JsonLines::append(const ordered_json& line) {
    const std::string text = line.dump() + '\n';
    if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() || std::fflush(file_.get()) != 0)
        throw OutputError(fmt::format("{}: the file can't be written: {}", path_, std::strerror(errno)));
}

} // namespace wm3d::study
