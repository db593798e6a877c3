// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Trials on disk, one line of JSON each, so that long work can be stopped and resumed.
#pragma once

#include <map>
#include <string>

#include <wm3d/study/json_lines.hpp>
#include <wm3d/study/trials.hpp>

namespace wm3d::study {

/// A name of a mesh by its coordinates and triangles: 16 hexadecimal digits.
std::string mesh_fingerprint(const TriangleMesh& mesh);

/// A file of trials on one mesh. The first line names the mesh; every other holds a trial and its setting (a
/// text that says all that the trial depends on). A last line that was cut off is dropped.
class TrialLog {
public:
    /// Opens or creates the file.
    /// \throw InputError   if it is no log of trials, belongs to another mesh or is damaged
    /// \throw OutputError  if it can't be written
    TrialLog(const std::string& path, const std::string& fingerprint);

    /// Trials of a setting that are there already, by number.
    const std::map<std::size_t, Trial>& trials(const std::string& setting) { return trials_[setting]; }

    /// Writes a line and flushes it to the file.
    /// \throw OutputError
    void append(const std::string& setting, const Trial& trial);

private:
    void read(const nlohmann::ordered_json& line, std::size_t number, const std::string& path,
              const std::string& fingerprint);

    std::map<std::string, std::map<std::size_t, Trial>> trials_; // filled while `lines_` is made
    JsonLines lines_;
};

} // namespace wm3d::study
