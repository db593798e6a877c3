// SPDX-License-Identifier: GPL-3.0-or-later
#include "half_edges.hpp"

#include <numeric>

#include "pairing.hpp"

namespace wm3d::simplify {

namespace {

/// Keeps the partners that run in opposite directions; the ends of other pairs are locked.
void link_twins(const std::vector<Triangle>& triangles, const Pairing& pairing, HalfEdges& mesh) {
    for (Index h = 0; h < mesh.edges.size(); ++h) {
        mesh.edges[h].origin = triangles[h / 3][h % 3];
        const Index partner = pairing.partner[h];
        if (partner == no_index)
            continue;
        if (triangles[partner / 3][partner % 3] != mesh.edges[h].origin) {
            mesh.edges[h].twin = partner;
        } else { // a seam that no choice of sides closes
            mesh.locked[mesh.edges[h].origin] = true;
            mesh.locked[triangles[h / 3][next(h) % 3]] = true;
        }
    }
}

/// The half-edge from which turning counter-clockwise meets the whole fan of `h`.
Index fan_start(const HalfEdges& mesh, Index h) {
    for (Index at = h;;) {
        const Index twin = mesh.edges[at].twin;
        if (twin == no_index)
            return at;
        at = next(twin);
        if (at == h)
            return h; // closed
    }
}

/// Gives every fan of corners a vertex of its own. The first fan of a vertex keeps its number.
void split_fans(HalfEdges& mesh) {
    std::vector<bool> met(mesh.edges.size(), false);
    for (Index h = 0; h < mesh.edges.size(); ++h) {
        if (met[h])
            continue;
        const Index start = fan_start(mesh, h);
        Index v = mesh.edges[h].origin;
        if (mesh.leaving[v] != no_index) { // a further fan
            mesh.locked[v] = true;
            mesh.source.push_back(v);
            mesh.leaving.push_back(no_index);
            mesh.locked.push_back(true);
            v = static_cast<Index>(mesh.source.size() - 1);
        }
        mesh.leaving[v] = start;
        Index at = start;
        do {
            met[at] = true;
            mesh.edges[at].origin = v;
            at = mesh.turn(at);
        } while (at != no_index && at != start);
    }
}

} // namespace

HalfEdges build_half_edges(std::vector<Triangle> triangles, const std::vector<Vec3>& positions) {
    Pairing pairing = pair_half_edges(triangles, positions.size());
    if (!pairing.oriented) {
        orient(triangles, positions, pairing);
        pairing = pair_half_edges(triangles, positions.size());
    }
    HalfEdges mesh;
    mesh.edges.resize(3 * triangles.size());
    mesh.leaving.assign(positions.size(), no_index);
    mesh.locked = std::move(pairing.complex);
    mesh.source.resize(positions.size());
    std::iota(mesh.source.begin(), mesh.source.end(), Index{0});
    link_twins(triangles, pairing, mesh);
    split_fans(mesh);
    return mesh;
}

} // namespace wm3d::simplify
