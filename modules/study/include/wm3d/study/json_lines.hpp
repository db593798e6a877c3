// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A file of JSON objects, one on each line, that long work grows and may be stopped at any time.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include <wm3d/core/descriptor.hpp>

namespace wm3d::study {

class JsonLines {
public:
    /// Called with each line that is there, numbered from 1. It may throw nlohmann's exceptions, which make
    /// an InputError of it.
    using Reader = std::function<void(const nlohmann::ordered_json& line, std::size_t number)>;

    /// Opens or creates the file. A last line that was cut off is dropped, but only if the file is one of
    /// these: the reader took its first line, or what there is of that begins as `schema` has it. Nothing is
    /// changed before that is known, and as long as the object lives no other process may open the file so.
    /// \param what    what a line is called in messages
    /// \param schema  first member of the first line, such as "wm3d.trials/1"
    /// \throw InputError   if a line can't be read, or the file is another one
    /// \throw OutputError  if the file can't be written, or another process has it open
    JsonLines(const std::string& path, const std::string& what, std::string_view schema,
              const Reader& reader);

    const std::string& path() const { return path_; }

    /// Whether the file had no line when it was opened.
    bool was_empty() const { return was_empty_; }

    /// Adds a line, whole or not at all. From one thread at a time.
    /// \throw OutputError
    void append(const nlohmann::ordered_json& line);

private:
    void open();
    std::uintmax_t read_lines(const std::string& what, std::string_view schema, const Reader& reader);
    void cut(std::uintmax_t size);
    [[noreturn]] void fail_writing(int error) const;

    std::string path_;
    Descriptor file_;
    bool was_empty_ = true;
    std::uintmax_t size_ = 0; ///< of the lines that are complete, in bytes
};

} // namespace wm3d::study
