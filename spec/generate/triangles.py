# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles in space and in the plane, with exact or 60-digit coordinates."""
from mpmath import matrix, mp


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def length(a):
    return mp.sqrt(dot(a, a))


def combine(weights, points):
    return [dot(weights, column) for column in zip(*points)]


def barycentric(p, corners):
    """Coordinates of the point of the corners' plane (in any dimension) nearest to p: the normal equations."""
    e1, e2, d = minus(corners[1], corners[0]), minus(corners[2], corners[0]), minus(p, corners[0])
    b, c = mp.lu_solve(matrix([[dot(e1, e1), dot(e1, e2)], [dot(e1, e2), dot(e2, e2)]]), matrix([dot(e1, d), dot(e2, d)]))
    return [1 - b - c, b, c]


def condition(p, corners):
    """How much larger than the rounding of the corners the error of a coordinate may be."""
    longest = max([length(minus(a, b)) for a in corners for b in corners] + [length(minus(p, a)) for a in corners])
    e1, e2 = minus(corners[1], corners[0]), minus(corners[2], corners[0])
    double_area = mp.sqrt(dot(e1, e1) * dot(e2, e2) - dot(e1, e2) ** 2)
    return float(longest**2 / double_area) ** 2
