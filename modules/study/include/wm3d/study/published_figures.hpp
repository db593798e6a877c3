// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Published figures of earlier methods under the attacks of the public benchmark.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace wm3d::study {

/// The two protocols of the benchmark, by the distortion that they allow.
enum class Protocol {
    perceptual, ///< MRMS up to 0.08 % of the box's diagonal
    geometric,  ///< MRMS up to 0.02 %
};

/// Bit error rates, in [0, 1], of 64 bits hidden in the model Venus.
struct PublishedRates {
    double cho =
        0; ///< J.-W. Cho, R. Prost, H.-Y. Jung, "An oblivious watermarking for 3-D polygonal meshes", 2007
    double wang = 0; ///< K. Wang, G. Lavoue, F. Denis, A. Baskurt, "Robust and blind mesh watermarking based
                     ///< on volume moments", 2011
};

/// The better of the two. Both were printed with two decimals.
double best_published(const PublishedRates& rates);

/// What K. Wang, G. Lavoue, F. Denis, A. Baskurt, "A benchmark for 3D mesh watermarking" (2010) and the
/// method of 2011 report of an attack, if they do.
std::optional<PublishedRates> published_rates(std::string_view attack, Protocol protocol);

/// log10 of the probability that 64 random bits agree with 64 others in all but `rate` of them, or more.
double log10_false_positive(double rate);

} // namespace wm3d::study
