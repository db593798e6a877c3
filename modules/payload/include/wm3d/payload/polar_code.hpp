// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A polar code with list decoding.
/// This work is based on E. Arikan, "Channel polarization" (IEEE Trans. Inf. Theory 55, 2009), I. Tal and A.
/// Vardy, "List decoding of polar codes" (IEEE Trans. Inf. Theory 61, 2015), and the polarization weight of
/// G. He et al., "Beta-expansion" (IEEE Globecom 2017).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace wm3d::payload {

/// `information` bits in 2^m coded ones. No channel is designed for: the positions of the information are
/// those of greatest polarization weight sum_k b_k 2^(k/4), b the binary digits of the position, which are
/// the same on every machine and good at every rate.
class PolarCode {
public:
    /// \param length       of a code word, a power of two
    /// \param information  bits in it, at most `length`
    PolarCode(std::size_t length, std::size_t information);

    std::size_t length() const { return frozen_.size(); }
    std::size_t information() const { return information_; }

    /// The code word, #length bits, of #information bits.
    std::vector<std::uint8_t> encode(std::span<const std::uint8_t> bits) const;

    /// One way to read a code word.
    struct Candidate {
        std::vector<std::uint8_t> bits; ///< #information
        double cost = 0;                ///< -log of its probability, but for a constant
    };

    /// The likeliest readings that successive cancellation with a list finds, best first.
    /// \param llr   #length: log of how much likelier a coded bit is 0 than 1
    /// \param list  number of readings that are kept while decoding
    std::vector<Candidate> decode(std::span<const double> llr, std::size_t list) const;

private:
    std::size_t information_;
    std::vector<std::uint8_t> frozen_; ///< #length: 1 where the bit is always 0
};

} // namespace wm3d::payload
