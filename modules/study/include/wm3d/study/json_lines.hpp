// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A file of JSON objects, one on each line, that long work grows and may be stopped at any time.
#pragma once

#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace wm3d::study {

class JsonLines {
public:
    /// Called with each line that is there, numbered from 1. It may throw nlohmann's exceptions, which make
    /// an InputError of it.
    using Reader = std::function<void(const nlohmann::ordered_json& line, std::size_t number)>;

    /// Opens or creates the file. A last line that was cut off is dropped. `what` is what a line is called in
    /// messages.
    /// \throw InputError   if a line can't be read
    /// \throw OutputError  if the file can't be written
    JsonLines(const std::string& path, const std::string& what, const Reader& reader);

    const std::string& path() const { return path_; }

    /// Whether the file had no line when it was opened.
    bool was_empty() const { return was_empty_; }

    /// Writes a line and flushes it to the file. From one thread at a time. \throw OutputError
    void append(const nlohmann::ordered_json& line);

private:
    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::string path_;
    bool was_empty_ = true;
    std::unique_ptr<std::FILE, Closer> file_;
};

} // namespace wm3d::study
