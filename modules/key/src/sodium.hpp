// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What the module's sources share of libsodium.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace wm3d::key {

/// Starts libsodium once (it then chooses its fastest code).
/// \throw Error  if it can't start
void start_sodium();

/// BLAKE2b of `message` under `key` (none if empty) with a digest of out.size() bytes, 16 to 64.
void blake2b(std::span<std::uint8_t> out, std::span<const std::uint8_t> message,
             std::span<const std::uint8_t> key);

inline std::span<const std::uint8_t> bytes_of(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Little-endian bytes of a number.
std::array<std::uint8_t, 8> little_endian(std::uint64_t number);

/// Memory of its own pages that is not swapped out nor dumped where the system grants that, guarded against
/// overruns, and wiped when the last pointer to it goes.
/// \throw std::bad_alloc
std::shared_ptr<std::uint8_t> guarded_memory(std::size_t size);

/// Overwrites a text that held a secret.
void wipe(std::string& text);

} // namespace wm3d::key
