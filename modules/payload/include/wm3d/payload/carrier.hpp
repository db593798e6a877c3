// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  How bits ride on the numbers of a watermarking sphere.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <wm3d/key/stream.hpp>
#include <wm3d/payload/message.hpp>
#include <wm3d/payload/polar_code.hpp>

namespace wm3d::payload {

/// Height of a sign that has the root mean square of a number that is uniform in (-rmax, rmax).
double sign_height(double rmax);

/// The code of a format: 512 coded bits, 1024 for the longest. Longer ones gain less than 0.2 dB.
PolarCode code_of(Format format);

/// A format's keyed signs on a level's sphere, and which coded bit rides on which vertex. Streams of their
/// own: the watermark sequence of the same key is independent of them.
class Carrier {
public:
    /// \throw ParameterError  if level > key::max_level
    Carrier(const key::Secret& secret, unsigned level, Format format);

    Format format() const { return format_; }

    /// #sequence_length numbers of -height and height: a vertex carries its sign, turned if its coded bit
    /// is 1.
    std::vector<double> modulated(std::span<const std::uint8_t> coded, double height) const;

    /// For each coded bit the sum of the coefficients it rides on, each times its sign: positive speaks for
    /// 0.
    std::vector<double> demodulated(std::span<const double> coefficients) const;

private:
    Format format_;
    std::size_t coded_bits_;
    std::vector<std::int8_t> sign_;  ///< #sequence_length
    std::vector<std::uint32_t> bit_; ///< #sequence_length
};

/// The sequence of a message.
std::vector<double> payload_sequence(const key::Secret& secret, unsigned level, double rmax,
                                     const Message& message);

} // namespace wm3d::payload
