// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/trial_log.hpp>

#include <bit>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/core/error.hpp>
#include <wm3d/core/fnv.hpp>
#include <wm3d/core/json_number.hpp>

namespace wm3d::study {

namespace {

using nlohmann::ordered_json;

constexpr const char* schema = "wm3d.trials/1";

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
    t.number = whole_number<std::size_t>(json.at("trial"));
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

TrialLog::TrialLog(const std::string& path, const std::string& fingerprint)
    : lines_(path, "trial", schema,
             [&](const ordered_json& line, std::size_t number) { read(line, number, path, fingerprint); }) {
    if (lines_.was_empty())
        lines_.append({{"schema", schema}, {"mesh", fingerprint}});
}

void TrialLog::read(const ordered_json& line, std::size_t number, const std::string& path,
                    const std::string& fingerprint) {
    if (number > 1) {
        const Trial trial = trial_of(line);
        trials_[line.at("setting").get<std::string>()][trial.number] = trial;
    } else if (line.at("schema") != schema || line.at("mesh") != fingerprint) {
        throw InputError(
            fmt::format("{}: these trials belong to another mesh or version; name a new file", path));
    }
}

void TrialLog::append(const std::string& setting, const Trial& trial) {
    lines_.append(to_json(setting, trial));
}

} // namespace wm3d::study
