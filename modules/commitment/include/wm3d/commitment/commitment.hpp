// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What fixes a key, its settings and a receipt, and can be shown to anybody.
///
/// A verdict's p counts random keys. It is the probability of a false accusation only if nobody looked at the
/// suspect when the key, the settings or the frame of the receipt were chosen: a key that is ground until it
/// fits, or a frame that is fitted afterwards, passes any threshold. docs/commitment.md describes the file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <wm3d/key/key_file.hpp>
#include <wm3d/resync/receipt.hpp>

namespace wm3d::commitment {

/// Choices of `verify` that could be tried until one fits.
struct Settings {
    std::uint64_t base_vertices = 20000;

    bool operator==(const Settings&) const = default;
};

struct Commitment {
    /// Newest version of the format that this library reads and the one it writes.
    static constexpr int format_version = 1;

    std::string tool;            ///< name and version of the program that made it
    std::string key_fingerprint; ///< public short name of the key
    std::string key_commitment;  ///< 64 hexadecimal digits that bind the key
    key::PublicParameters parameters;
    Settings settings;
    std::optional<resync::FileDigest> receipt; ///< of the receipt's file
};

/// \param receipt  the whole text of a receipt's file; nothing if no receipt is to be fixed
Commitment commit_to(const key::Key& key, const Settings& settings,
                     const std::optional<std::string>& receipt = std::nullopt);

/// The commitment as a JSON text. Its bytes are what is dated.
std::string to_text(const Commitment& commitment);

/// Reads the text of a commitment; messages call it `file_name`.
/// \throw InputError  if it is none, cut, of a newer version or has a value out of range
Commitment parse_commitment(std::string_view text, std::string_view file_name);

/// What a commitment covers of a verdict, besides the key.
struct Coverage {
    bool settings = false;                      ///< the verdict used the committed ones
    std::optional<bool> receipt = std::nullopt; ///< the receipt that was used; nothing if none was
};

/// Compares a commitment with what a verdict rests on; messages call it `file_name`.
/// \param receipt  the whole text of the receipt's file, if one is used
/// \throw InputError  if it is a commitment to another key or to another receipt
Coverage check(const Commitment& commitment, const key::Key& key, const Settings& settings,
               const std::optional<std::string>& receipt, std::string_view file_name);

} // namespace wm3d::commitment
