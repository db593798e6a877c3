#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Eq. (3): r_w = r + gamma (R_P - R) = r + gamma Delta.

The sphere is subdivided here anew by the documented numbering, and P is found without any closed form: each flat
triangle of the bumped mesh is intersected with the ray by solving corners * m = direction.
"""
from common import U, Numbers, Suite, exact, mp, mpf
from mpmath import matrix

FACES = [(0, 2, 4), (0, 5, 2), (0, 4, 8), (0, 10, 5), (0, 8, 10), (1, 6, 3), (1, 3, 7), (1, 8, 6), (1, 7, 10),
         (1, 10, 8), (2, 9, 4), (2, 5, 11), (2, 11, 9), (3, 6, 9), (3, 11, 7), (3, 9, 11), (4, 6, 8), (4, 9, 6),
         (5, 10, 7), (5, 7, 11)]


def projected(v):
    length = mp.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def icosphere(level):
    phi = (1 + mp.sqrt(5)) / 2
    rows = [(mpf(0), s, t * phi) for s in (1, -1) for t in (1, -1)]
    vertices = [projected(r[-k:] + r[:-k] if k else r) for k in range(3) for r in rows]
    faces = FACES
    for _ in range(level):
        midpoints, finer = {}, []
        for a, b, c in faces:
            m = []
            for p, q in ((a, b), (b, c), (c, a)):
                edge = frozenset((p, q))
                if edge not in midpoints:
                    midpoints[edge] = len(vertices)
                    vertices.append(projected([x + y for x, y in zip(vertices[p], vertices[q])]))
                m.append(midpoints[edge])
            finer += [(a, m[0], m[2]), (m[0], b, m[1]), (m[2], m[1], c), tuple(m)]
        faces = finer
    return vertices, faces


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def intersection(corners, d):
    """m with corners * m = d (columns): where m >= 0 the ray d meets the triangle, at the distance 1 / sum m."""
    return list(mp.lu_solve(matrix([[corner[i] for corner in corners] for i in range(3)]), matrix(d)))


def ray_distance(vertices, faces, heights, radius, direction):
    d = projected(direction)
    for face in sorted(faces, key=lambda f: -dot(d, [sum(vertices[j][i] for j in f) for i in range(3)]))[:8]:
        m = intersection([[(radius + heights[j]) * x for x in vertices[j]] for j in face], d)
        if min(m) >= 0:
            flat = intersection([vertices[j] for j in face], d)
            linear = sum(x * heights[j] for x, j in zip(flat, face)) / sum(flat)
            return 1 / sum(m), linear
    raise ArithmeticError("the ray misses the mesh")


def main():
    suite = Suite(3, {
        "bumped_radius": {"relative": 16 * U, "absolute": 0,
                          "why": "a quotient of two sums of three positive terms; barycentric coordinates are located "
                                 "to a few units, and R_P changes by less than they do"},
        "delta": {"relative": 0, "absolute": None,
                  "why": "R_P - R cancels: what stays is the absolute error of R_P, 16 units of R + rmax"},
        "linear_delta": {"relative": 0, "absolute": None,
                         "why": "rmax times the error of the coordinates, which grows as 1 / edge: 64 units"},
        "marked_radius": {"relative": 0, "absolute": None,
                          "why": "one product and one sum: 2 units of |r| + |gamma Delta|, and gamma times delta's"}})
    number = Numbers(3)
    for level, rmax, radius in ((0, 0.1, 1.0), (1, 0.5, 1.0), (2, 0.1, 1.0), (3, 0.1, 1.0), (3, 0.9, 2.5)):
        vertices, faces = icosphere(level)
        heights = [rmax * number() for _ in vertices]
        directions = [[number(), number(), number()] for _ in range(16)] + [[1.0, 0.0, 0.0], [0.0, 0.0, -2.0]]
        radii = [1 + 0.75 * number() for _ in directions]
        gamma = 0.0625 * (1 + level)
        found = [ray_distance(vertices, faces, [exact(w) for w in heights], exact(radius), [exact(x) for x in d])
                 for d in directions]
        delta = [r_p - exact(radius) for r_p, _ in found]
        error = 16 * U * (radius + rmax)
        suite.add(f"level{level}-rmax{rmax}-radius{radius}", "random bumps and directions; two axes, which meet edges",
                  {"level": level, "radius": radius, "heights": heights, "directions": directions, "r": radii,
                   "gamma": gamma},
                  {"bumped_radius": [r_p for r_p, _ in found], "delta": delta,
                   "linear_delta": [linear for _, linear in found],
                   "marked_radius": [exact(r) + exact(gamma) * d for r, d in zip(radii, delta)]},
                  {"delta": error, "linear_delta": 64 * U * rmax,
                   "marked_radius": 2 * U * (2 + gamma * rmax) + gamma * error})
    suite.write()


main()
