// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/weld.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <optional>
#include <utility>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/core/split_mix.hpp>

namespace wm3d {

namespace {

constexpr std::size_t triangle_block = 16384;

constexpr std::uint64_t hash(const std::array<std::uint64_t, 3>& words) {
    std::uint64_t h = split_mix_step;
    for (const std::uint64_t word : words)
        h = split_mix_finalizer(h ^ word);
    return h;
}

std::array<std::uint64_t, 3> words_of(const Vec3& p) {
    std::array<std::uint64_t, 3> words{};
    for (int k = 0; k < 3; ++k)
        words[static_cast<std::size_t>(k)] = std::bit_cast<std::uint64_t>(p[k] + 0.0); // -0 becomes 0
    return words;
}

/// Number of the first point equal to each point, by open addressing; nothing where more slots are looked at
/// than happens by chance.
std::optional<std::vector<Index>> first_equal_by_hash(std::span<const Vec3> positions) {
    const std::size_t mask = std::bit_ceil(positions.size() * 2 + 1) - 1;
    std::size_t patience = 1000 + 16 * positions.size();
    std::vector<Index> table(mask + 1, no_index);
    std::vector<Index> first(positions.size());
    constexpr std::size_t ahead = 16; // points whose slots are on their way from memory
    std::array<std::size_t, ahead> slots{};
    const auto fetch = [&](std::size_t i) {
        slots[i % ahead] = hash(words_of(positions[i])) & mask;
        __builtin_prefetch(&table[slots[i % ahead]], 1);
    };
    for (std::size_t i = 0; i < std::min(ahead, positions.size()); ++i)
        fetch(i);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        std::size_t slot = slots[i % ahead];
        if (i + ahead < positions.size())
            fetch(i + ahead);
        while (table[slot] != no_index && positions[table[slot]] != positions[i]) {
            if (patience-- == 0)
                return std::nullopt;
            slot = (slot + 1) & mask;
        }
        if (table[slot] == no_index)
            table[slot] = static_cast<Index>(i);
        first[i] = table[slot];
    }
    return first;
}

/// The same by sorting, which takes the same time whatever the points are.
std::vector<Index> first_equal_by_order(std::span<const Vec3> positions) {
    std::vector<Index> order(positions.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::sort(order, {}, [&](Index i) { return std::pair(words_of(positions[i]), i); });
    std::vector<Index> first(positions.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        first[order[k]] =
            k > 0 && positions[order[k - 1]] == positions[order[k]] ? first[order[k - 1]] : order[k];
    return first;
}

std::vector<Index> first_equal(std::span<const Vec3> positions) {
    // Points that all hash alike can be made on purpose.
    const std::optional<std::vector<Index>> first = first_equal_by_hash(positions);
    return first ? *first : first_equal_by_order(positions);
}

} // namespace

Welded weld(std::span<const Vec3> positions, std::span<const Triangle> triangles) {
    return weld(std::vector(positions.begin(), positions.end()),
                std::vector(triangles.begin(), triangles.end()));
}

Welded weld(std::vector<Vec3>&& positions, std::vector<Triangle>&& triangles) {
    if (positions.size() >= no_index)
        throw GeometryError(
            "the mesh has more than 4 294 967 294 vertices, which is more than wm3d can number");
    Welded welded{{std::move(positions), std::move(triangles)}, {}};
    std::vector<Vec3>& places = welded.mesh.positions;
    welded.vertex_of = first_equal(places);
    Index count = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        Index& v = welded.vertex_of[i];
        if (v == i) {
            v = count++;
            places[v] = places[i];
        } else {
            v = welded.vertex_of[v]; // already renumbered: it comes earlier
        }
    }
    places.resize(count);
    parallel_blocks(welded.mesh.triangles.size(), triangle_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            for (Index& v : welded.mesh.triangles[f])
                v = welded.vertex_of[v];
    });
    std::erase_if(welded.mesh.triangles,
                  [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    return welded;
}

} // namespace wm3d
