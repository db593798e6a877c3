// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What a robustness bench finds: models, marks on them, and marks after attacks.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wm3d::study {

/// How large a mark is made.
struct MarkSize {
    enum class Unit {
        strength,   ///< area-weighted RMS move along the normals, % of the box's diagonal
        mrms,       ///< largest MRMS between the mesh and the marked mesh, % of the box's diagonal
        visibility, ///< largest one-sided MSDM2 of the marked mesh against the mesh
    };
    Unit unit = Unit::strength;
    double value = 0;

    // NOLINTNEXTLINE(modernize-use-nullptr): a category is compared with 0
    auto operator<=>(const MarkSize&) const = default;
};

/// "strength", "mrms" or "visibility".
std::string_view name(MarkSize::Unit unit);

/// "strength 0.019" or "mrms 0.02".
std::string to_string(const MarkSize& size);

/// A mesh file of the bench.
struct BenchModel {
    std::string fingerprint; ///< as mesh_fingerprint; empty where the file could not be read
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::string error; ///< why it could not be read or marked; else empty
};

/// Which mark.
struct MarkName {
    std::string model; ///< name of the file
    MarkSize size;
    std::size_t key = 0; ///< number of the random key

    // NOLINTNEXTLINE(modernize-use-nullptr): a category is compared with 0
    auto operator<=>(const MarkName&) const = default;
};

/// A marked mesh before anything happened to it. Lengths in % of the box's diagonal.
struct BenchMark {
    double strength = 0; ///< asked for, or found for a limit of MRMS
    double gamma = 0;
    double normal_rms = 0;
    double mrms = 0;
    double msdm2 = 0;                 ///< one-sided, of the marked mesh against the mesh
    std::optional<double> msdm2_both; ///< mean of both sides; logs of version 0.1 lack it
    std::string error;                ///< why the mesh can't be marked; else empty
};

/// Which attack on which mark.
struct ItemName {
    MarkName mark;
    std::string attack; ///< as attack::to_string writes it

    // NOLINTNEXTLINE(modernize-use-nullptr): a category is compared with 0
    auto operator<=>(const ItemName&) const = default;
};

/// What the owner finds with the original beside the suspect.
struct AssistedResult {
    double log10_p = 0; ///< family-wise
    bool aligned = false;
    double coverage = 0; ///< part of the original that has a counterpart in the suspect
};

/// What a search in all poses took, after a quick look that found nothing.
struct SearchedResult {
    bool found = false;
    std::size_t centres = 0; ///< pairs of a centre and a sequence that were tried in all rotations
};

/// What became of the payload that a mark carries.
struct PayloadResult {
    std::size_t bits = 0;
    std::size_t raw_errors = 0; ///< as payload::uncoded_errors: of `bits`, without a code
    bool read = false;          ///< decoded without error, and believed as verify believes
    bool wrong = false;         ///< another message was believed
    double log10_p = 0;         ///< of what was decoded; 0 where nothing was
};

/// What is found in an attacked copy that was moved, turned and scaled at random.
struct BenchItem {
    double log10_p = 0; ///< family-wise, as verify's
    double sigmas = 0;  ///< of the best hypothesis
    std::size_t hypotheses = 0;
    unsigned level = 0;
    std::size_t pose = 0;
    double filter_t = 0, filter_power = 0, filter_hinges = 0; ///< of the best: detect::Filter
    std::size_t vertices = 0;                                 ///< of the attacked mesh
    std::vector<double> wrong;                                ///< log10 p of wrong keys, family-wise
    std::vector<double>
        wrong_one; ///< log10 p of the same keys in the first hypothesis alone: exact, so uniform
    std::optional<SearchedResult> searched;
    std::optional<AssistedResult> assisted;
    std::optional<PayloadResult> payload; ///< where the marks carry one
    double seconds = 0;
    std::string error; ///< why there is nothing to examine; else empty
};

struct BenchResults {
    std::vector<std::string> commands; ///< command lines that made the results, each once
    std::map<std::string, BenchModel> models;
    std::map<MarkName, BenchMark> marks;
    std::map<ItemName, BenchItem> items;
};

} // namespace wm3d::study
