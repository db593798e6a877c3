// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/gltf_overlap.hpp"

#include <algorithm>
#include <chrono>
#include <set>

#include <doctest/doctest.h>

using namespace wm3d::io;

namespace {

GltfAccessor accessor(std::size_t number, std::size_t buffer, std::size_t offset, std::size_t stride,
                      std::size_t count, Scalar type = Scalar::f32) {
    GltfAccessor a;
    a.number = number;
    a.buffer = buffer;
    a.offset = offset;
    a.stride = stride;
    a.count = count;
    a.type = type;
    return a;
}

/// The bytes of all elements.
std::set<std::size_t> bytes_of(const GltfAccessor& a) {
    std::set<std::size_t> bytes;
    for (std::size_t i = 0; i < a.count; ++i)
        for (std::size_t b = 0; b < 3 * size_of(a.type); ++b)
            bytes.insert(a.offset + i * a.stride + b);
    return bytes;
}

} // namespace

TEST_CASE("accessors side by side, interleaved and in different buffers don't overlap") {
    CHECK_FALSE(gltf_overlap({}));
    CHECK_FALSE(gltf_overlap({accessor(0, 0, 48, 12, 4), accessor(1, 0, 0, 12, 4)}));
    CHECK_FALSE(gltf_overlap({accessor(0, 0, 0, 24, 4), accessor(1, 0, 12, 24, 4)}));
    CHECK_FALSE(
        gltf_overlap({accessor(0, 0, 12, 36, 9), accessor(1, 0, 24, 36, 9), accessor(2, 0, 0, 36, 9)}));
    CHECK_FALSE(gltf_overlap({accessor(0, 0, 0, 12, 4), accessor(1, 1, 0, 12, 4)}));
    CHECK_FALSE(gltf_overlap({accessor(0, 0, 0, 12, 4), accessor(1, 0, 6, 12, 0)}));
}

TEST_CASE("shared bytes are found") {
    const auto pair = gltf_overlap({accessor(7, 0, 36, 12, 4), accessor(3, 0, 0, 12, 4)});
    REQUIRE(pair);
    CHECK(*pair == std::pair<std::size_t, std::size_t>(3, 7));
    CHECK(gltf_overlap({accessor(0, 0, 0, 24, 4), accessor(1, 0, 8, 24, 4)}));
    CHECK(gltf_overlap({accessor(0, 0, 16, 24, 4), accessor(1, 0, 24, 24, 4)}));
    CHECK(gltf_overlap({accessor(0, 0, 0, 24, 9), accessor(1, 0, 12, 36, 4)})); // strides differ
}

TEST_CASE("no accessor that shares a byte is missed, and none of one stride is blamed without cause") {
    std::uint64_t state = 88172645463325252u;
    const auto next = [&](std::size_t below) {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        return static_cast<std::size_t>(state % below);
    };
    int shared_rounds = 0;
    for (int round = 0; round < 4000; ++round) {
        const std::size_t stride = 12 + 4 * next(5);
        std::vector<GltfAccessor> all;
        for (std::size_t i = 0; i < 2 + next(4); ++i)
            all.push_back(
                accessor(i, 0, 4 * next(30), stride, 1 + next(4), next(2) == 0 ? Scalar::f32 : Scalar::i16));
        bool shares = false, reaches_over = false;
        for (std::size_t i = 0; i < all.size(); ++i)
            for (std::size_t j = i + 1; j < all.size(); ++j) {
                const auto a = bytes_of(all[i]), b = bytes_of(all[j]);
                shares |= std::any_of(a.begin(), a.end(), [&](std::size_t byte) { return b.contains(byte); });
                reaches_over |= all[i].offset < all[j].end() && all[j].offset < all[i].end();
            }
        const bool found = gltf_overlap(all).has_value();
        if (shares)
            CHECK(found);
        if (!reaches_over)
            CHECK_FALSE(found);
        shared_rounds += shares ? 1 : 0;
    }
    CHECK(shared_rounds > 500);
    CHECK(shared_rounds < 3500);
}

TEST_CASE("a hundred thousand interleaved accessors take no time for each pair") {
    const std::size_t count = 100000;
    std::vector<GltfAccessor> all;
    for (std::size_t i = 0; i < count; ++i)
        all.push_back(accessor(i, 0, 12 * i, 12 * count, 1000));
    const auto start = std::chrono::steady_clock::now();
    CHECK_FALSE(gltf_overlap(all));
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
    all.push_back(accessor(count, 0, 12 * count - 4, 12 * count, 1000));
    CHECK(gltf_overlap(all));
}
