// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A secret under a passphrase.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <wm3d/key/passphrase.hpp>
#include <wm3d/key/secret.hpp>

namespace wm3d::key {

/// A secret in XSalsa20-Poly1305 (libsodium's secretbox) under what Argon2id makes of a passphrase.
struct ProtectedSecret {
    ProtectionCost cost;
    std::string salt, nonce, box; ///< bytes
};

/// \throw Error  if there is not enough memory for the cost
ProtectedSecret protect(const Secret& secret, const Passphrase& passphrase, const ProtectionCost& cost);

/// The secret; nothing if the passphrase is another one, or the bytes were altered.
/// \throw Error  if there is not enough memory for the cost
std::optional<Secret> opened(const ProtectedSecret& secret, const Passphrase& passphrase);

/// As it stands in a key file: "argon2id PASSES MIB SALT NONCE BOX", the last three in hexadecimal digits.
std::string to_text(const ProtectedSecret& secret);
/// Nothing if the text is no protected secret, or opening it would cost more than a minute or 4 GiB.
std::optional<ProtectedSecret> parse_protected(std::string_view text);

} // namespace wm3d::key
