// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A passphrase that protects a key file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace wm3d::key {

/// What a person types to open a key. Kept as a Secret is.
class Passphrase {
public:
    static constexpr std::size_t size_limit = 1024; ///< bytes

    /// Takes the text over and wipes it there.
    /// \throw ParameterError  if it is empty or too long
    explicit Passphrase(std::string&& text);

    std::string_view text() const { return {reinterpret_cast<const char*>(bytes_.get()), size_}; }

private:
    std::shared_ptr<const std::uint8_t> bytes_;
    std::size_t size_;
};

/// Asks for the passphrase of a key that has one; may throw.
using AskPassphrase = std::function<Passphrase()>;

/// What opening a protected key costs its owner, and each guess a thief: of Argon2id.
struct ProtectionCost {
    unsigned passes = 3;
    unsigned memory_mib = 256;
};

} // namespace wm3d::key
