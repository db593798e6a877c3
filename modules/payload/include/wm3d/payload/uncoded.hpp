// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What hard decisions would get wrong without a code, to compare with marks that have none.
#pragma once

#include <cstddef>
#include <span>

#include <wm3d/key/secret.hpp>
#include <wm3d/payload/message.hpp>

namespace wm3d::payload {

/// Errors before decoding.
struct UncodedErrors {
    std::size_t bits = 0;   ///< of the payload: #capacity of the message's format
    std::size_t errors = 0; ///< of them
};

/// How many bits of the message an owner would read wrong without its code, each payload bit spread over an equal
/// part of the sphere's vertices and decided by the sign of its sum.
///
/// The mark of a coded message is that of uncoded bits too, with other keyed signs: a vertex carries height * s_j x_k,
/// and s_j' = s_j x_k b is as random a sign as s_j is, whatever the payload bit b. So the coded bits, #length / #bits
/// of them for each payload bit, are summed with their own signs; a sum that isn't positive is an error.
/// \param coefficients  what the suspect says about each number of the level, in one pose and filter
UncodedErrors uncoded_errors(const key::Secret& secret, unsigned level, const Message& message,
                             std::span<const double> coefficients);

} // namespace wm3d::payload
