// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Under what condition the p of a verdict is the probability of a false accusation.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include <wm3d/commitment/commitment.hpp>

namespace wm3d::cmd {

/// What a verdict rests on, and the commitment that fixed it beforehand, if one was given.
struct Condition {
    bool uses_receipt = false;
    std::string commitment_file;   ///< empty: none was given
    std::string commitment_sha256; ///< what a depository dated
    commitment::Coverage coverage;
};

/// Reads the commitment, if there is one, and compares it with the verdict's key, settings and receipt.
/// \param receipt_text  the receipt's whole file, if one is used
/// \throw InputError  if it is a commitment to something else
Condition condition_of(const std::string& commitment_file, const key::Key& key,
                       const commitment::Settings& settings, const std::optional<std::string>& receipt_text);

/// One line for people.
std::string condition_line(const Condition& condition);

nlohmann::ordered_json to_json(const Condition& condition);

} // namespace wm3d::cmd
