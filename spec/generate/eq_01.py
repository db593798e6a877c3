#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Eq. (1): p^0 = alpha p_i + beta p_j + gamma p_k, and how alpha, beta, gamma come about in one step of MAPS.

Part one: points of triangles. Part two: a vertex is removed from a small mesh; its ring is flattened by z -> z^a and
the vertex gets its coordinates in the triangle of ring vertices in which the origin then lies. Which triangle that is
depends on the vertex it collapsed into, so all triangles that hold the origin are listed.
"""
from common import U, Numbers, Suite, exact, mp
from flattening import places, polar
from triangles import barycentric, combine, condition


def add_points(suite):
    number = Numbers(1)
    for k in range(12):
        corners = [[number(), number(), number()] for _ in range(3)]
        weights = [abs(number()) for _ in range(3)] if k else [1.0, 0.0, 0.0]
        third = 1 - weights[0] - weights[1] if k else 0.0  # may be negative: the plane, not the triangle alone
        suite.add(f"point{k}", "random triangle" if k else "a corner", {"corners": corners,
                  "barycentric": [weights[0], weights[1], third]},
                  {"base_point": combine([exact(w) for w in (weights[0], weights[1], third)],
                                         [[exact(x) for x in c] for c in corners])})
    for k in range(12):
        corners = [[number(), number(), number()] for _ in range(3)]
        if k % 3 == 2:  # slender: the third corner close to the first side
            corners[2] = [(a + b) / 2 + c / 64 for a, b, c in zip(*corners)]
        p = [number(), number(), number()]
        e = [[exact(x) for x in c] for c in corners]
        q = [exact(x) for x in p]
        suite.add(f"coordinates{k}", "a point off the plane, which stands for the nearest one of it",
                  {"corners": corners, "p": p}, {"barycentric_coordinates": barycentric(q, e)},
                  {"barycentric_coordinates": 16 * U * condition(q, e)})


def add_removals(suite):
    number = Numbers(11)
    for m, closed in ((3, True), (4, True), (5, True), (6, True), (7, True), (8, True), (3, False), (4, False), (5, False)):
        turn = 2 * mp.pi / m if closed else mp.pi / (m - 1)
        ring = [polar(1 + 0.2 * number(), turn * (k + 0.2 * number() * (closed or 0 < k < m - 1)),
                      0.1 * number()) for k in range(m)]
        apex = [0.015625, 0.03125, 0.125] if closed else [0.046875, -0.015625, 0.03125]
        positions = [apex] + ring
        triangles = [[0, k + 1, k % m + 2 if k + 1 < m else 1] for k in range(m if closed else m - 1)]
        if closed:  # a far vertex below closes the mesh and makes all other collapses dear
            positions.append([0.0, 0.0, -3.0])
            triangles += [[m + 1, b, a] for _, a, b in triangles]
        e = [[exact(x) for x in p] for p in positions]
        found = places(e[0], e[1:m + 1], closed)
        suite.add(f"removal-{'closed' if closed else 'open'}{m}", "one vertex of a small mesh is removed",
                  {"positions": positions, "triangles": triangles, "removed": 0,
                   "corners": [[k + 1 for k in corners] for corners, _ in found]},
                  {"place": [weights for _, weights in found],
                   "image": [combine(weights, [e[k + 1] for k in corners]) for corners, weights in found]})


def main():
    suite = Suite(1, {
        "base_point": {"relative": 0, "absolute": 8 * U, "why": "three products of numbers up to 2 and two sums"},
        "barycentric_coordinates": {"relative": 0, "absolute": None,
                                    "why": "16 units times the squared condition of the triangle, longest^2 / (2 area)"},
        "place": {"relative": 0, "absolute": 1e-13,
                  "why": "angles, powers, sines and cosines of at most eight neighbours, each to a few units, in "
                         "triangles whose condition is below 100"},
        "image": {"relative": 0, "absolute": 3e-13, "why": "place times coordinates up to 1.5"}})
    add_points(suite)
    add_removals(suite)
    suite.write()


main()
