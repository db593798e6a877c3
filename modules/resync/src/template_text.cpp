// SPDX-License-Identifier: GPL-3.0-or-later
#include "template_text.hpp"

#include <algorithm>
#include <cmath>

#include <wm3d/core/base64.hpp>

namespace wm3d::resync {

namespace {

constexpr std::size_t bytes_per_point = 9;
constexpr double finest = 65535;
constexpr double normal_steps = 127;

} // namespace

std::string encode(const PoseTemplate& pose_template, const Box& box) {
    std::string bytes;
    for (std::size_t i = 0; i < pose_template.points.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            const double range = box.max[k] - box.min[k];
            const double part = range > 0 ? (pose_template.points[i][k] - box.min[k]) / range : 0;
            const auto step = static_cast<unsigned>(std::lround(std::clamp(part, 0.0, 1.0) * finest));
            bytes += static_cast<char>(step & 0xff);
            bytes += static_cast<char>(step >> 8);
        }
        for (int k = 0; k < 3; ++k)
            bytes += static_cast<char>(std::lround(pose_template.normals[i][k] * normal_steps));
    }
    return to_base64(bytes);
}

std::optional<PoseTemplate> decode(std::string_view text, const Box& box) {
    const std::optional<std::string> decoded = from_base64(text);
    if (!decoded || decoded->empty() || decoded->size() % bytes_per_point != 0)
        return std::nullopt;
    const std::string& bytes = *decoded;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    PoseTemplate result;
    for (std::size_t at = 0; at < bytes.size(); at += bytes_per_point) {
        Vec3 point, normal;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            const double part = (byte(at + 2 * k) + 256.0 * byte(at + 2 * k + 1)) / finest;
            point[axis] = box.min[axis] + part * (box.max[axis] - box.min[axis]);
            normal[axis] = static_cast<signed char>(bytes[at + 6 + k]) / normal_steps;
        }
        if (!(normal.norm() > 0.5))
            return std::nullopt;
        result.points.push_back(point);
        result.normals.push_back(normal.normalized());
    }
    return result;
}

} // namespace wm3d::resync
