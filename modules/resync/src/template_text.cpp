// SPDX-License-Identifier: GPL-3.0-or-later
#include "template_text.hpp"

#include <algorithm>
#include <cmath>

#include <sodium.h>

namespace wm3d::resync {

namespace {

constexpr std::size_t bytes_per_point = 9;
constexpr double finest = 65535;
constexpr double normal_steps = 127;
constexpr int base64 = sodium_base64_VARIANT_ORIGINAL;

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
    std::string text(sodium_base64_ENCODED_LEN(bytes.size(), base64), '\0');
    sodium_bin2base64(text.data(), text.size(), reinterpret_cast<const unsigned char*>(bytes.data()),
                      bytes.size(), base64);
    text.pop_back(); // the terminating zero
    return text;
}

std::optional<PoseTemplate> decode(std::string_view text, const Box& box) {
    std::string bytes(text.size(), '\0');
    std::size_t size = 0;
    const char* end = nullptr;
    if (sodium_base642bin(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), text.data(),
                          text.size(), nullptr, &size, &end, base64) != 0 ||
        end != text.data() + text.size() || size == 0 || size % bytes_per_point != 0)
        return std::nullopt;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    PoseTemplate result;
    for (std::size_t at = 0; at < size; at += bytes_per_point) {
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
