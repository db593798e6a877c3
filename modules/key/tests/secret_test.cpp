// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/key/secret.hpp>

#include <set>
#include <string>

#include <doctest/doctest.h>

#include "fixed_secret.hpp"
#include "stream_vectors.hpp"

using namespace wm3d::key;

TEST_CASE("null secrets are those of the independent generator") {
    for (const NullVector& vector : null_vectors)
        CHECK(hex(null_secret(vector.seed, vector.number).bytes()) == vector.secret);
}

TEST_CASE("fingerprint and commitment are those of the independent generator") {
    CHECK(fingerprint(fixed_secret()) == fingerprint_vector);
    CHECK(commitment(fixed_secret()) == commitment_vector);
}

TEST_CASE("random secrets differ from each other") {
    std::set<std::string> seen;
    for (int i = 0; i < 100; ++i)
        seen.insert(hex(Secret::random().bytes()));
    CHECK(seen.size() == 100);
}

TEST_CASE("a secret equals its copy and no secret that differs in one bit") {
    const Secret secret = fixed_secret();
    CHECK(secret == Secret(secret));
    for (std::size_t bit = 0; bit < 256; ++bit) {
        std::array<std::uint8_t, Secret::size> bytes;
        std::copy(secret.bytes().begin(), secret.bytes().end(), bytes.begin());
        bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
        CHECK_FALSE(Secret(bytes) == secret);
    }
}
