// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A short name for anything that can be told in words.
#pragma once

#include <cstdint>

namespace wm3d {

/// FNV-1a over words of up to 64 bits: told from accident, not from malice.
class Fnv {
public:
    void add(std::uint64_t word) { hash_ = (hash_ ^ word) * 0x100000001b3; }
    std::uint64_t value() const { return hash_; }

private:
    std::uint64_t hash_ = 0xcbf29ce484222325;
};

} // namespace wm3d
