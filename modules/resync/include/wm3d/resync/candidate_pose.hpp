// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  One guess of where the watermarking sphere lies on a suspect.
#pragma once

#include <string>

#include <wm3d/mesh/frame.hpp>

namespace wm3d::resync {

/// A frame in which a suspect is examined, and where it comes from. Each one is a hypothesis that the verdict
/// pays for, so a list of them must not depend on any key.
struct CandidatePose {
    Frame frame;
    std::string origin; ///< for people: "principal axes", "receipt", ...
    bool likely = true; ///< else a second guess: a coarser mesh's axes, a turn, the axes before a smoothing
};

} // namespace wm3d::resync
