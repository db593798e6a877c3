#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Eq. (2): Pi^-1(p) = alpha p_i + beta p_j + gamma p_k, where p = alpha Pi(p_i) + beta Pi(p_j) + gamma Pi(p_k)."""
from common import U, Numbers, Suite, exact
from triangles import barycentric, combine, condition


def main():
    suite = Suite(2, {"original_point": {
        "relative": 0, "absolute": None,
        "why": "32 units times the squared condition of the image triangle, for originals within [-2, 2]"}})
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
    suite.write()


main()
