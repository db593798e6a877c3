// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Reading a payload from what a suspect says about each number of the key.
#pragma once

#include <optional>
#include <span>

#include <wm3d/detect/linear_statistic.hpp>
#include <wm3d/key/secret.hpp>
#include <wm3d/payload/message.hpp>

namespace wm3d::payload {

struct ReadOptions {
    std::size_t list = 32; ///< readings that the decoder keeps
};

/// A payload that was read.
struct Reading {
    Message message;
    Format format = Format::bits64;
    double sigmas = 0; ///< T of its sequence in standard deviations over random keys
    /// log10 of the probability, at most, that a random key would have shown any valid payload as clearly on
    /// this mesh: the exact tail of T times the messages of the format times the formats.
    double log10_p = 0;
    std::size_t coded_bits = 0;
    std::size_t coded_errors = 0; ///< coded bits whose soft value has the wrong sign: errors before decoding
};

/// The payload that shows most clearly, of every format; none if no reading of the decoder is a whole frame.
/// \param statistic  what the suspect says in one pose and filter, which may have been chosen by anything but
/// the
///                   payload streams; its law doesn't matter here
std::optional<Reading> read_payload(const key::Secret& secret, unsigned level,
                                    const detect::LinearStatistic& statistic,
                                    const ReadOptions& options = {});

/// The soft values of a format's coded bits, in standard deviations over random keys.
std::vector<double> soft_values(const key::Secret& secret, unsigned level, Format format,
                                std::span<const double> coefficients);

} // namespace wm3d::payload
