// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  256 secret bits, and what may be told about them in public.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace wm3d::key {

/// 256 bits that only the owner knows. Copies share one place in memory that is never swapped out nor dumped
/// where the system grants that, and wiped with the last of them; compared in constant time.
class Secret {
public:
    static constexpr std::size_t size = 32;

    explicit Secret(std::span<const std::uint8_t, size> bytes);

    /// A new secret from the operating system's generator.
    static Secret random();

    std::span<const std::uint8_t, size> bytes() const {
        return std::span<const std::uint8_t, size>(bytes_.get(), size);
    }

    friend bool operator==(const Secret& a, const Secret& b);

private:
    explicit Secret(std::shared_ptr<const std::uint8_t> bytes) : bytes_(std::move(bytes)) {}
    friend Secret null_secret(std::uint64_t seed, std::uint64_t number);

    std::shared_ptr<const std::uint8_t> bytes_;
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
