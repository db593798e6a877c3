// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  From a suspect and an owner's copies to those that it was made from.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <wm3d/payload/recipients.hpp>
#include <wm3d/watermark/verify.hpp>

namespace wm3d::watermark {

/// A copy that the owner gave away.
struct IssuedCopy {
    std::uint64_t number = 0; ///< as payload::copy_number
    unsigned level = 0;       ///< of its mark's sphere
};

struct IdentifyOptions {
    VerifyOptions verify; ///< how the owner's mark is looked for; its receipt and reference are not used
    /// Of the works that the copies may be of. Where the quick look finds nothing, the suspect is registered with each
    /// in turn, before all poses are searched. All of them are paid for.
    std::span<const resync::Receipt> receipts{};
};

struct IdentifyReport {
    VerifyReport mark;                        ///< whether it is the owner's at all, and where the mark lies
    detect::LinearStatistic content{{}, 1};   ///< what the suspect says about the copies' numbers
    std::vector<payload::Accusation> accused; ///< at the P_f that was asked for, the clearest first
    std::size_t compared = 0; ///< copies whose mark may lie where one was found: those of its level
    double best_sigmas = 0;   ///< the clearest copy's score, accused or not
    std::size_t receipts_tried = 0;
    std::optional<std::size_t> receipt; ///< which of them told the pose

    bool is_owners() const { return !accused.empty() || mark.verdict == detect::Verdict::present; }
};

/// Whose copies the suspect was made from. The suspect is examined once, the owner's common part tells pose,
/// and level, and every copy is one sum of signs there, read on all vertices or as many as
/// `most_examined`. All copies are paid for, also those of other levels.
///
/// With receipts the quick look and the search have 0.999 of P_f, and the receipts share the rest: their p are
/// multiplied by 1000 and by their number.
/// \throw GeometryError, ParameterError as `verify`
IdentifyReport identify(const TriangleMesh& suspect, const key::Key& key, std::span<const IssuedCopy> copies,
                        const IdentifyOptions& options, const Progress& progress = {});

} // namespace wm3d::watermark
