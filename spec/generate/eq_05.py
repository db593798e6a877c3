#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Eq. (5): P_m = erfc((gamma sqrt(n mean(Delta^2)) - sqrt 2 erfc^-1(2 P_f) sigma_r) / (sqrt 2 sigma_r)) / 2.

Every value is checked against a second way that starts from eq. (4) and (6). Given Delta, rho has the variance
sigma_r^2 mean(Delta^2) / n under both hypotheses and under H_1 the mean mu_r mean(Delta) + gamma mean(Delta^2); P_m is
the normal probability below the threshold of eq. (6).
"""
from common import Suite, exact, mp
from normal import erfc_inverse, normal_cdf

SMALLEST = mp.mpf(2) ** -1022


def argument(gamma, n, square, sigma, pf):
    return (gamma * mp.sqrt(n * square) - mp.sqrt(2) * erfc_inverse(2 * pf) * sigma) / (mp.sqrt(2) * sigma)


def by_threshold(gamma, n, square, sigma, pf, mean=mp.mpf("0.01"), mu=mp.mpf("0.9")):
    threshold = mp.sqrt(2 * sigma**2 * square / n) * erfc_inverse(2 * pf) + mu * mean
    return normal_cdf((threshold - (mu * mean + gamma * square)) / (sigma * mp.sqrt(square / n)))


def main():
    suite = Suite(5, {
        "miss_probability": {"relative": 1e-12, "absolute": 0,
                             "why": "the condition number of erfc at x is about 2 x^2, 1400 at P_m = 1e-300; a function "
                                    "that keeps x to 1e-16 stays below 1e-12"},
        "log10_miss_probability": {"relative": 1e-12, "absolute": 1e-15,
                                   "why": "as P_m; absolute where P_m is near 1 and its logarithm near 0"}})

    def add(name, origin, gamma, n, square, sigma, pf):
        x = argument(*(exact(x) for x in (gamma, n, square, sigma, pf)))
        p = mp.erfc(x) / 2
        again = by_threshold(*(exact(x) for x in (gamma, n, square, sigma, pf)))
        assert abs(p / again - 1) < mp.mpf(10) ** -38, (name, p, again)
        # log(1 - q) of the complement where P_m is near 1
        values = {"log10_miss_probability": mp.log10(p) if x > 0 else mp.log1p(-mp.erfc(-x) / 2) / mp.log(10)}
        if p >= SMALLEST:
            values["miss_probability"] = p
        suite.add(name, origin, {"gamma": gamma, "n": n, "delta_mean_square": square, "sigma_r": sigma, "pf": pf},
                  values)

    bunny = 0.032**0.5
    figures = (1e-300, 1e-200, 1e-100, 1e-30, 1e-12, 1e-6, 1e-3, 0.05, 0.25, 0.5)
    for gamma, n in ((0.05, 2500), (0.1, 10000), (0.3, 34834), (0.05, 1000000)):
        for pf in figures:
            add(f"gamma{gamma}-n{n}-pf{pf}", "figure 8: sigma_r^2 = 0.032, Delta uniform in [-0.1, 0.1]", gamma, n,
                0.01 / 3, bunny, pf)
    for pf in (0.5, 0.75, 0.9, 0.999, 1 - 2.0**-53):
        add(f"pf{pf}", "P_f of one half and above", 0.02, 400, 0.003, 0.2, pf)
    for pf in (1e-9, 0.3, 0.5, 0.8):
        add(f"no-mark-pf{pf}", "gamma = 0: P_m = 1 - P_f", 0.0, 5000, 0.003, 0.2, pf)
    add("one-vertex", "n = 1", 1.0, 1, 0.01, 0.1, 1e-3)
    add("negative-gamma", "a mark of the other sign is missed the more", -0.1, 900, 0.003, 0.2, 1e-2)
    for target in (10, 100, 300, 307):
        # z of P_m = 10^-target at P_f = 10^-100: gamma that gives it, rounded to a double
        z = erfc_inverse(2 * mp.mpf(10) ** -target) + erfc_inverse(2 * exact(1e-100))
        gamma = float(z * mp.sqrt(2) * exact(0.2) / mp.sqrt(10000 * exact(0.003)))
        add(f"pm1e-{target}", "strength chosen for this P_m", gamma, 10000, 0.003, 0.2, 1e-100)
    for gamma, n in ((1.0, 1000000), (0.5, 300000000), (5.0, 4000000000)):
        add(f"underflow-gamma{gamma}-n{n}", "P_m below every double: only its logarithm", gamma, n, 0.003, 0.2, 1e-6)
    suite.write()


main()
