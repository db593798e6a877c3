# SPDX-License-Identifier: GPL-3.0-or-later
"""The normal tail and its inverse to full precision, however small the probability."""
from mpmath import mp, mpf


def erfc_inverse(y):
    """x with erfc(x) = y, for 0 < y < 2, by Newton's method on the logarithm."""
    if y > 1:
        return -erfc_inverse(2 - y)
    if y == 1:
        return mpf(0)
    target = mp.log(y)
    x = mp.sqrt(max(-target, mpf("0.01")))  # right of the root, since erfc(x) <= exp(-x^2)
    for _ in range(200):
        value = mp.erfc(x)
        step = (mp.log(value) - target) * value / (-2 / mp.sqrt(mp.pi) * mp.exp(-x * x))
        x -= step
        if abs(step) <= mp.eps * 4 * max(abs(x), mpf(10) ** -20):
            return x
    raise ArithmeticError(f"no convergence at {y}")


def normal_cdf(x):
    return mp.erfc(-x / mp.sqrt(2)) / 2
