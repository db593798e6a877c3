#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Eq. (4): rho = (1/n) sum r_i Delta_i."""
from common import U, Numbers, Suite, exact, mpf


def main():
    suite = Suite(4, {"correlation": {
        "relative": 0, "absolute": None,
        "why": "summation in order: (n + 1) units of the mean of |r_i Delta_i|, whatever cancels"}})

    def add(name, origin, r, delta):
        terms = [exact(x) * exact(y) for x, y in zip(r, delta)]
        n = len(terms)
        suite.add(name, origin, {"r": r, "delta": delta}, {"correlation": sum(terms, mpf(0)) / n},
                  {"correlation": float((n + 1) * mpf(U) * sum(abs(t) for t in terms) / n)})

    number = Numbers(4)
    add("one", "a single vertex", [1.25], [-0.0625])
    add("third", "a mean that no double says", [1.0, 2.0, 3.0], [0.1, 0.2, 0.3])
    add("zero", "exact cancellation", [2.0, 1.0], [0.5, -1.0])
    add("cancel", "large terms that leave a small one", [2.0**30, 2.0**30, 1.0], [2.0**20, -(2.0**20), 2.0**-30])
    add("tiny", "products below the normal range of float, not of double", [1e-120, 2e-120], [3e-100, -1e-100])
    for n, rmax in ((17, 0.1), (100, 0.1), (500, 0.5)):
        add(f"random{n}", "radii about 1, bumps within rmax", [1 + 0.5 * number() for _ in range(n)],
            [rmax * number() for _ in range(n)])
    suite.write()


main()
