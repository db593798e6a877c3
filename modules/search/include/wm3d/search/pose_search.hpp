// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The search: all rotations about many centres, then the best few refined.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <wm3d/core/progress.hpp>
#include <wm3d/detect/evidence.hpp>
#include <wm3d/search/key_function.hpp>
#include <wm3d/search/pose.hpp>

namespace wm3d::search {

struct SearchOptions {
    unsigned bandwidth = 64; ///< of the harmonics: 128^3 rotations for each centre
    std::size_t filter = detect::folds_after_simplification; ///< of the evidence, whose T is searched
    double promising = 5.4;     ///< standard deviations from which closer centres are looked at, at once
    double worth_a_climb = 6.0; ///< ... from which the best of them is refined
    std::size_t finalists = 8;  ///< less promising poses that are refined when all centres were tried
    double convincing = 8.0;    ///< standard deviations from which a refined pose is offered
    double hopeful = 6.5;       ///< ... from which deformations are tried, if they are to be tried
    double clear = 25; ///< ... above which a climb has surely reached the peak; below, it is repeated around
    double around = 0.02;                        ///< from centres so far away along each axis
    Deformation deformation = Deformation::none; ///< the largest to try
};

/// A pose with the score that it had in the search. Nothing about it is a probability.
struct Candidate {
    Pose pose;
    unsigned level = 0;
    double sigmas = 0;
};

struct SearchOutcome {
    std::size_t centres = 0; ///< pairs of a centre and a key function that were tried
    double rotations = 0;    ///< for each of them, summed
    std::size_t refined = 0; ///< poses that were
    Candidate best;          ///< of the refined ones
    bool accepted = false;   ///< the caller took `best`, so the search stopped
};

/// What is looked for: the function of a level's sequence, as it is or mirrored.
struct Target {
    unsigned level = 0;
    const KeyFunction* key = nullptr;
    bool mirrored = false;
    std::span<const Vec3> centres; ///< the likeliest first, in the suspect's units
};

/// Whether the pose is the one, by a test that is paid for. The search goes on if not.
using Accept = std::function<bool(const Candidate&)>;

/// Searches the poses of a suspect for each target in turn.
/// \param x         #base vertices, in the suspect's units: centred, mean radius about 1
/// \param evidence  of the same base
SearchOutcome search_poses(std::span<const Vec3> x, const detect::Evidence& evidence,
                           std::span<const Target> targets, const Accept& accept,
                           const SearchOptions& options = {}, const Progress& progress = {});

/// Score that a mark with these weights would have in the coarse step of the search, if the nearest centre of
/// the lattice lies `off` away from the right one and the nearest rotation half a sample.
/// \param mark  what the mark adds to the evidence's weights, #x: Evidence::mark_weights_at for the key's
/// sequence in the pose of no turn about the origin
double expected_sigmas(std::span<const Vec3> x, const detect::Evidence& evidence,
                       std::span<const double> mark, const KeyFunction& key, double off,
                       const SearchOptions& options = {});

} // namespace wm3d::search
