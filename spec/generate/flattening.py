# SPDX-License-Identifier: GPL-3.0-or-later
"""The conformal flattening of a ring, z -> z^a, and where it puts the vertex in the ring's middle."""
import itertools

from mpmath import mp, mpf

from triangles import barycentric, dot, length, minus


def flatten(centre, ring, closed):
    """Ring vertices in the plane about the centre, which goes to the origin."""
    spokes = [minus(p, centre) for p in ring]
    pairs = list(zip(spokes, spokes[1:] + spokes[:1])) if closed else list(zip(spokes, spokes[1:]))
    angles = [mp.acos(dot(a, b) / (length(a) * length(b))) for a, b in pairs]
    power = (2 if closed else 1) * mp.pi / sum(angles)
    plane, angle = [], mpf(0)
    for spoke, step in zip(spokes, angles + [mpf(0)]):
        r = length(spoke) ** power
        plane.append([r * mp.cos(power * angle), r * mp.sin(power * angle)])
        angle += step
    return plane


def places(centre, ring, closed):
    """(ring numbers, weights) of every triangle, or of the one edge of an open ring, that holds the origin."""
    plane = flatten(centre, ring, closed)
    if not closed:
        first, last = length(plane[0]), length(plane[-1])
        return [((0, len(ring) - 1), [last / (first + last), first / (first + last)])]
    found = []
    for triple in itertools.combinations(range(len(ring)), 3):
        weights = barycentric([mpf(0), mpf(0)], [plane[k] for k in triple])
        if min(weights) > 0:
            found.append((triple, weights))
    return found


def polar(radius, angle, height):
    """A point with coordinates of few bits near the given cylindrical ones."""
    return [round(64 * x) / 64 for x in (float(radius * mp.cos(angle)), float(radius * mp.sin(angle)), height)]
