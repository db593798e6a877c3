#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Eq. (6): T_rho = sqrt(2 sigma_r^2 mean(Delta^2) / n) erfc^-1(2 P_f) + mu_r mean(Delta).

The paper prints the bar over Delta alone. The variance of rho under H_0 is sigma_r^2 mean(Delta^2) / n, so the bar
belongs over the square, as in eq. (5): every value is checked to give P_f back as a normal tail of that variance.
"""
from common import U, Suite, exact, mp
from normal import erfc_inverse, normal_cdf


def main():
    suite = Suite(6, {"threshold": {
        "relative": 0, "absolute": None,
        "why": "two terms that may cancel, each good to a few units: 8 units of the sum of their sizes"}})

    def add(name, origin, pf, n, variance, square, mean, mu):
        p, count, s2, d2, d, m = (exact(x) for x in (pf, n, variance, square, mean, mu))
        deviation = mp.sqrt(s2 * d2 / count)
        spread = mp.sqrt(2) * deviation * erfc_inverse(2 * p)
        if deviation > 0:
            assert abs(normal_cdf(-spread / deviation) / p - 1) < mp.mpf(10) ** -38, name
        suite.add(name, origin, {"pf": pf, "n": n, "sigma_r2": variance, "delta_mean_square": square,
                                 "delta_mean": mean, "mu_r": mu}, {"threshold": spread + m * d},
                  {"threshold": float(8 * U * (abs(spread) + abs(m * d)))})

    for pf in (1e-300, 1e-150, 1e-50, 1e-12, 1e-6, 1e-3, 0.05, 0.3, 0.5, 0.5 + 2.0**-53, 0.7, 0.99, 1 - 2.0**-53):
        add(f"pf{pf}", "figure 8's variance, Delta uniform in [-0.1, 0.1] with a small mean", pf, 10000, 0.032,
            0.01 / 3, -0.0017, 0.95)
    for n in (1, 10, 2500, 34834, 300000000):
        add(f"n{n}", "number of base vertices", 1e-6, n, 0.032, 0.0033, 0.0004, 1.0)
    add("no-mean", "Delta of mean 0", 1e-6, 2500, 0.032, 0.0033, 0.0, 1.0)
    add("equal-radii", "sigma_r = 0: the threshold is the mean", 1e-6, 2500, 0.0, 0.0033, 0.02, 1.0)
    add("cancel", "the mean cancels the spread but for one part in 10^6", 1e-6, 2500, 0.032, 0.0033, -0.000976737,
        1.0)
    suite.write()


main()
