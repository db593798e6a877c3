// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/sequence.hpp>

#include <cmath>

#include <wm3d/key/stream.hpp>
#include <wm3d/payload/carrier.hpp>
#include <wm3d/payload/recipients.hpp>

namespace wm3d::payload {

std::vector<double> mark_sequence(const key::Secret& secret, unsigned level, double rmax,
                                  const Content& content, const Shares& shares) {
    std::vector<double> sequence = key::watermark_sequence(secret, level, rmax);
    if (content.empty())
        return sequence;
    const double parts =
        static_cast<double>(content.message.has_value()) + static_cast<double>(content.copy.has_value());
    const double common = std::sqrt(shares.common), other = std::sqrt((1 - shares.common) / parts);
    for (double& w : sequence)
        w *= common;
    const auto add = [&](const std::vector<double>& part) {
        for (std::size_t j = 0; j < sequence.size(); ++j)
            sequence[j] += other * part[j];
    };
    if (content.message)
        add(payload_sequence(secret, level, rmax, *content.message));
    if (content.copy)
        add(copy_sequence(secret, level, rmax,
                          copy_number(content.copy->work, content.copy->recipient, level)));
    return sequence;
}

} // namespace wm3d::payload
