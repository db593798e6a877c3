// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/trial_log.hpp"

#include <bit>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/mesh/error.hpp>

namespace wm3d::pipeline {

namespace {

using nlohmann::ordered_json;

constexpr const char* schema = "wm3d.trials/1";

/// FNV-1a over 64-bit words: told from accident, not from malice.
class Fnv {
public:
    void add(std::uint64_t word) { hash_ = (hash_ ^ word) * 0x100000001b3; }
    std::uint64_t value() const { return hash_; }

private:
    std::uint64_t hash_ = 0xcbf29ce484222325;
};

ordered_json to_json(const std::string& setting, const Trial& t) {
    return {{"setting", setting},
            {"trial", t.number},
            {"log10_p", t.log10_p},
            {"paper_nominal_p", t.paper_nominal_p},
            {"paper_log10_p", t.paper_log10_p},
            {"gamma", t.gamma},
            {"rms_percent", t.distortion.normal_rms},
            {"vertex_rms_percent", t.distortion.vertex_rms},
            {"max_percent", t.distortion.max}};
}

Trial trial_of(const ordered_json& json) {
    Trial t;
    t.number = json.at("trial").get<std::size_t>();
    t.log10_p = json.at("log10_p").get<double>();
    t.paper_nominal_p = json.at("paper_nominal_p").get<double>();
    t.paper_log10_p = json.at("paper_log10_p").get<double>();
    t.gamma = json.at("gamma").get<double>();
    t.distortion = {json.at("rms_percent").get<double>(), json.at("vertex_rms_percent").get<double>(),
                    json.at("max_percent").get<double>()};
    return t;
}

} // namespace

std::string mesh_fingerprint(const TriangleMesh& mesh) {
    Fnv hash;
    for (const Vec3& p : mesh.positions)
        for (int k = 0; k < 3; ++k)
            hash.add(std::bit_cast<std::uint64_t>(p[k]));
    for (const Triangle& t : mesh.triangles)
        for (Index v : t)
            hash.add(v);
    return fmt::format("{:016x}", hash.value());
}

TrialLog::TrialLog(const std::string& path, const std::string& fingerprint) : path_(path) {
    std::error_code ignored;
    const bool is_new =
        !std::filesystem::exists(path, ignored) || std::filesystem::file_size(path, ignored) == 0;
    if (!is_new)
        read(fingerprint);
    file_.reset(std::fopen(path.c_str(), "ab"));
    if (!file_)
        throw OutputError(fmt::format("{}: the file can't be written: {}", path, std::strerror(errno)));
    if (is_new)
        write_line(ordered_json{{"schema", schema}, {"mesh", fingerprint}}.dump());
}

void TrialLog::read(const std::string& fingerprint) {
    std::ifstream in(path_, std::ios::binary);
    std::string line;
    std::uintmax_t whole = 0; // bytes of the lines that are complete
    for (std::size_t number = 1; std::getline(in, line) && !in.eof(); ++number) {
        whole += line.size() + 1;
        const ordered_json json = ordered_json::parse(line, nullptr, false);
        try {
            if (number > 1) {
                const Trial trial = trial_of(json);
                trials_[json.at("setting").get<std::string>()][trial.number] = trial;
            } else if (json.at("schema") != schema || json.at("mesh") != fingerprint) {
                throw InputError(fmt::format(
                    "{}: these trials belong to another mesh or version; name a new file", path_));
            }
        } catch (const ordered_json::exception&) {
            throw InputError(
                fmt::format("{}: line {} is no trial; remove the line, or name a new file", path_, number));
        }
    }
    in.close();
    if (std::filesystem::file_size(path_) != whole)
        std::filesystem::resize_file(path_, whole);
}

void TrialLog::append(const std::string& setting, const Trial& trial) {
    write_line(to_json(setting, trial).dump());
}

void TrialLog::write_line(const std::string& line) {
    const std::string text = line + '\n';
    if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() || std::fflush(file_.get()) != 0)
        throw OutputError(fmt::format("{}: the file can't be written: {}", path_, std::strerror(errno)));
}

} // namespace wm3d::pipeline
