// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/carrier.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>

namespace wm3d::payload {

namespace {

/// Which stream of the purpose a carrier takes. Frozen: marks that are out there depend on it.
std::uint64_t stream_index(unsigned level, Format format) {
    return 16 * std::uint64_t{level} + static_cast<std::uint64_t>(format);
}

std::size_t coded_bits_of(Format format) {
    return format == Format::bits128 ? 1024 : 512;
}

} // namespace

double sign_height(double rmax) {
    return rmax / std::sqrt(3.0);
}

PolarCode code_of(Format format) {
    return PolarCode(coded_bits_of(format), frame_size(format));
}

Carrier::Carrier(const key::Secret& secret, unsigned level, Format format)
    : format_(format), coded_bits_(coded_bits_of(format)) {
    if (level > key::max_level)
        throw ParameterError(
            fmt::format("level {} is too fine for a watermarking sphere; choose one from 0 to {}", level,
                        key::max_level));
    const std::size_t n = key::sequence_length(level);
    std::vector<std::uint64_t> rank(n), words(n);
    key::Stream stream(secret, key::Purpose::payload, stream_index(level, format));
    stream.fill(rank);
    stream.fill(words);
    for (const std::uint64_t word : words)
        sign_.push_back(word >> 63 ? -1 : 1);
    // In the random order of `rank` the coded bits take turns, so each has as many vertices as any other,
    // anywhere.
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order(n);
    for (std::uint32_t j = 0; j < n; ++j)
        order[j] = {rank[j], j};
    std::ranges::sort(order);
    bit_.resize(n);
    for (std::size_t k = 0; k < n; ++k)
        bit_[order[k].second] = static_cast<std::uint32_t>(k % coded_bits_);
}

std::vector<double> Carrier::modulated(std::span<const std::uint8_t> coded, double height) const {
    std::vector<double> sequence(sign_.size());
    for (std::size_t j = 0; j < sequence.size(); ++j)
        sequence[j] = (coded[bit_[j]] ? -height : height) * sign_[j];
    return sequence;
}

std::vector<double> Carrier::demodulated(std::span<const double> coefficients) const {
    std::vector<double> soft(coded_bits_, 0.0);
    for (std::size_t j = 0; j < sign_.size(); ++j)
        soft[bit_[j]] += coefficients[j] * sign_[j];
    return soft;
}

std::vector<double> payload_sequence(const key::Secret& secret, unsigned level, double rmax,
                                     const Message& message) {
    const Format format = format_of(message);
    return Carrier(secret, level, format)
        .modulated(code_of(format).encode(to_frame(message, format)), sign_height(rmax));
}

} // namespace wm3d::payload
