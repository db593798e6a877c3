// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What a mark says, as one sequence of numbers on the sphere.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <wm3d/key/secret.hpp>
#include <wm3d/payload/message.hpp>

namespace wm3d::payload {

/// Whose copy it is.
struct CopyLabel {
    std::string work; ///< digest of what was marked
    std::string recipient;
};

/// What a mark says besides whose it is.
struct Content {
    std::optional<Message> message;
    std::optional<CopyLabel> copy;

    bool empty() const { return !message && !copy; }
};

/// Parts of a mark's energy (its mean square). The common part says whose the mark is and finds the pose;
/// what it says besides takes far more to be read than that takes to be found. docs/recipients.md has the
/// measurements.
struct Shares {
    double common = 0.2; ///< of a mark with content; the rest is divided evenly between message and copy
};

/// Where a mesh bears little, a copy of its own is limited by the common part, which takes a score of about 6 to be
/// found where the copy's takes 7: nearly even parts bring both through on the least mark.
inline constexpr Shares shares_of_weak_copies{0.4};

/// The watermark sequence of the key, and mixed into it the sequences of the content, in such parts that the
/// mean square stays that of the key's: #sequence_length(level).
/// \throw ParameterError as key::watermark_sequence
std::vector<double> mark_sequence(const key::Secret& secret, unsigned level, double rmax,
                                  const Content& content, const Shares& shares = {});

} // namespace wm3d::payload
