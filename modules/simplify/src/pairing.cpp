// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairing.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include <wm3d/core/parallel.hpp>

#include "corners.hpp"
#include "half_edges.hpp"

namespace wm3d::simplify {

namespace {

constexpr std::size_t pairing_block = 4096;

/// A half-edge between a vertex and one of a greater number.
struct LooseSpoke {
    Index other;
    Index half_edge;
    bool outward; ///< runs from the vertex to the other
};

/// The half-edges between v and vertices of greater number, sorted by the other vertex. Each edge of the
/// mesh is so met once, at its smaller end.
void collect_spokes(const std::vector<Triangle>& triangles, const Corners& by, Index v,
                    std::vector<LooseSpoke>& spokes) {
    spokes.clear();
    for (Index i = by.start[v]; i < by.start[v + 1]; ++i) {
        const Index out = by.corners[i], in = previous(out);
        const Triangle& t = triangles[out / 3];
        if (const Index head = t[next(out) % 3]; head > v)
            spokes.push_back({head, out, true});
        if (const Index tail = t[in % 3]; tail > v)
            spokes.push_back({tail, in, false});
    }
    std::sort(spokes.begin(), spokes.end(), [](const LooseSpoke& a, const LooseSpoke& b) {
        return std::pair(a.other, a.half_edge) < std::pair(b.other, b.half_edge);
    });
}

/// Partners of the edges in `spokes`; complex ends go to `complex`. False if two partners run the same way.
bool pair_spokes(const std::vector<LooseSpoke>& spokes, std::vector<Index>& partner,
                 std::vector<Index>& complex) {
    bool oriented = true;
    for (std::size_t begin = 0, end; begin < spokes.size(); begin = end) {
        for (end = begin + 1; end < spokes.size() && spokes[end].other == spokes[begin].other;)
            ++end;
        if (end - begin == 2) {
            partner[spokes[begin].half_edge] = spokes[begin + 1].half_edge;
            partner[spokes[begin + 1].half_edge] = spokes[begin].half_edge;
            oriented = oriented && spokes[begin].outward != spokes[begin + 1].outward;
        } else if (end - begin > 2) {
            complex.push_back(spokes[begin].other);
        }
    }
    return oriented;
}

bool same_direction(const std::vector<Triangle>& triangles, Index h, Index partner) {
    return triangles[h / 3][h % 3] == triangles[partner / 3][partner % 3];
}

double double_area(const Triangle& t, const std::vector<Vec3>& p) {
    return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm();
}

/// Marks in `turned` what must be turned over for the component of `seed` to agree with it.
std::vector<Index> agree_with(Index seed, const std::vector<Triangle>& triangles, const Pairing& pairing,
                              std::vector<signed char>& turned) {
    std::vector<Index> component{seed};
    turned[seed] = 0;
    for (std::size_t i = 0; i < component.size(); ++i)
        for (Index k = 0; k < 3; ++k) {
            const Index h = 3 * component[i] + k, partner = pairing.partner[h];
            if (partner == no_index || turned[partner / 3] >= 0)
                continue;
            turned[partner / 3] =
                static_cast<signed char>(turned[component[i]] ^ same_direction(triangles, h, partner));
            component.push_back(partner / 3);
        }
    return component;
}

} // namespace

Pairing pair_half_edges(const std::vector<Triangle>& triangles, std::size_t vertices) {
    const Corners by = corners_by_vertex(triangles, vertices);
    Pairing pairing;
    pairing.partner.assign(3 * triangles.size(), no_index);
    pairing.complex.assign(vertices, false);
    std::vector<std::vector<Index>> complex((vertices + pairing_block - 1) / pairing_block);
    std::atomic<bool> oriented = true;
    parallel_blocks(vertices, pairing_block, [&](std::size_t begin, std::size_t end) {
        std::vector<LooseSpoke> spokes;
        std::vector<Index>& ends = complex[begin / pairing_block];
        for (auto v = static_cast<Index>(begin); v < end; ++v) {
            collect_spokes(triangles, by, v, spokes);
            const std::size_t before = ends.size();
            if (!pair_spokes(spokes, pairing.partner, ends))
                oriented = false;
            if (ends.size() > before)
                ends.push_back(v);
        }
    });
    for (const auto& ends : complex)
        for (Index v : ends)
            pairing.complex[v] = true;
    pairing.oriented = oriented;
    return pairing;
}

void orient(std::vector<Triangle>& triangles, const std::vector<Vec3>& positions, const Pairing& pairing) {
    std::vector<signed char> turned(triangles.size(), -1); // not met yet
    for (Index seed = 0; seed < triangles.size(); ++seed) {
        if (turned[seed] >= 0)
            continue;
        const std::vector<Index> component = agree_with(seed, triangles, pairing, turned);
        double balance = 0; // area that agrees with the seed, less the area that doesn't
        for (Index f : component)
            balance += (turned[f] ? -1 : 1) * double_area(triangles[f], positions);
        for (Index f : component)
            if ((turned[f] != 0) != (balance < 0))
                std::swap(triangles[f][1], triangles[f][2]);
    }
}

} // namespace wm3d::simplify
