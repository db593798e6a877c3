#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Eq. (2): Pi^-1(p) = alpha p_i + beta p_j + gamma p_k, where p = alpha Pi(p_i) + beta Pi(p_j) + gamma Pi(p_k).

Part one: points and triangles. Part two: a vertex with three neighbours is removed from a double pyramid, so that all
images lie on one base triangle; points of that triangle go back to the surface.
"""
from common import U, Numbers, Suite, exact, mpf
from flattening import places
from triangles import barycentric, combine, condition


def add_way_back(suite, number):
    ring = [[1.0, 0.125, 0.0625], [-0.5, 0.75, -0.0625], [-0.375, -0.875, 0.03125]]
    positions = [[0.0625, 0.03125, 0.125]] + ring + [[0.0, 0.0, -3.0]]
    e = [[exact(x) for x in p] for p in positions]
    (_, image), = places(e[0], e[1:4], True)  # Pi of the removed vertex, in coordinates of the ring
    places_of = [image] + [[mpf(int(k == j)) for k in range(3)] for j in range(3)]
    queries, found = [], []
    while len(queries) < 12:
        query = [0.375 + 0.375 * number(), 0.3125 + 0.25 * number()]
        query.append(1 - sum(query))
        for pair in ((1, 2), (2, 3), (3, 1)):  # the original triangle whose image holds the query by a margin
            weights = barycentric([exact(x) for x in query], [places_of[j] for j in (0, *pair)])
            if min(query) > 0 and min(weights) > 0.01:
                queries.append(query)
                found.append(combine(weights, [e[j] for j in (0, *pair)]))
    suite.add("way-back", "one vertex of a double pyramid is removed",
              {"positions": positions, "triangles": [[0, 1, 2], [0, 2, 3], [0, 3, 1], [4, 2, 1], [4, 3, 2], [4, 1, 3]],
               "corners": [1, 2, 3], "queries": queries}, {"surface_point": found})


def main():
    suite = Suite(2, {"original_point": {
        "relative": 0, "absolute": None,
        "why": "32 units times the squared condition of the image triangle, for originals within [-2, 2]"},
        "surface_point": {"relative": 0, "absolute": 1e-13,
                          "why": "as eq. (1)'s image: a flattening of three neighbours, in triangles whose condition is "
                                 "below 100"}})
    number = Numbers(2)

    def add(name, origin, p, images, originals):
        q, e, o = [exact(x) for x in p], [[exact(x) for x in c] for c in images], [[exact(x) for x in c] for c in originals]
        suite.add(name, origin, {"p": p, "images": images, "originals": originals},
                  {"original_point": combine(barycentric(q, e), o)}, {"original_point": 32 * U * condition(q, e)})

    def corners(scale=1.0):
        return [[scale * number() for _ in range(3)] for _ in range(3)]

    for k in range(8):
        images = corners()
        weights = [1.0, 0.0, 0.0] if k == 0 else [0.25 + 0.125 * number(), 0.25 + 0.125 * number()]
        weights = weights if k == 0 else weights + [1 - sum(weights)]
        p = [sum(w * c[i] for w, c in zip(weights, images)) for i in range(3)]
        add(f"inside{k}", "a corner's image" if k == 0 else "a point of the triangle, rounded to double", p, images,
            corners(2.0))
    for k in range(4):
        images = corners()
        images[2] = [(a + b) / 2 + c / 32 for a, b, c in zip(*images)]
        p = [(a + b + c) / 3 for a, b, c in zip(*images)]
        add(f"slender{k}", "the image of a triangle is slender", p, images, corners(2.0))
    images = corners()
    add("identity", "originals equal images: p itself", [sum(c[i] for c in images) / 4 + images[0][i] / 4 for i in range(3)],
        images, images)
    add_way_back(suite, number)
    suite.write()


main()
