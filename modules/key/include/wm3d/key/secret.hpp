// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  256 secret bits, and what may be told about them in public.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace wm3d::key {

/// 256 bits that only the owner knows. Wiped from memory when destroyed; compared in constant time.
class Secret {
public:
    static constexpr std::size_t size = 32;

    explicit Secret(std::span<const std::uint8_t, size> bytes);
    ~Secret();
    Secret(const Secret&) = default;
    Secret& operator=(const Secret&) = default;

    /// A new secret from the operating system's generator.
    static Secret random();

    std::span<const std::uint8_t, size> bytes() const { return bytes_; }

    friend bool operator==(const Secret& a, const Secret& b);

private:
    std::array<std::uint8_t, size> bytes_;
};

/// Random secret number `number` of the family `seed`: reproducible by anyone, so good for calibration (null
/// keys) and experiments, never as an owner's key.
Secret null_secret(std::uint64_t seed, std::uint64_t number);

/// Public short name of a secret: 64 bits as 16 hexadecimal digits. Tells nothing about the secret.
std::string fingerprint(const Secret& secret);

/// Public commitment to a secret: 256 bits as 64 hexadecimal digits. Its owner can later show the secret, and
/// nobody can show another secret with the same commitment.
std::string commitment(const Secret& secret);

} // namespace wm3d::key
