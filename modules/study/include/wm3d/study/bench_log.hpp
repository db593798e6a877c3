// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Results of a bench on disk, so that it can be stopped and resumed.
#pragma once

#include <mutex>
#include <string>

#include <nlohmann/json.hpp>

#include <wm3d/study/bench_results.hpp>
#include <wm3d/study/json_lines.hpp>

namespace wm3d::study {

/// A file of lines: the first holds the settings that all results depend on, every other a command line, a
/// model, a mark or an item. Of several lines about the same thing the last counts.
class BenchLog {
public:
    /// Opens or creates the file.
    /// \throw InputError   if it is damaged, no log of a bench, or holds results of other settings
    /// \throw OutputError  if it can't be written
    BenchLog(const std::string& path, const nlohmann::ordered_json& settings);

    /// What is there. Not to be read while other threads add to it.
    const BenchResults& results() const { return results_; }

    /// A command line that adds to the results. One that is there is not written again.
    /// \throw OutputError
    void add_command(const std::string& command);

    /// A model that is there as it is now is not written again.
    /// \throw InputError   if the file holds results of another mesh under this name
    /// \throw OutputError  if the file can't be written
    void add(const std::string& name, BenchModel model);

    /// From any thread.
    /// \throw OutputError
    void add(const MarkName& name, const BenchMark& mark);
    void add(const ItemName& name, const BenchItem& item);

private:
    void read(const nlohmann::ordered_json& line, std::size_t number, const nlohmann::ordered_json& header,
              const std::string& path);

    BenchResults results_; // filled while `lines_` is made
    std::mutex guard_;
    JsonLines lines_;
};

} // namespace wm3d::study
