#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes frozen sphere vertices, ../vertex_vectors.hpp: the numbering and the bits that marks rest on.

An implementation of its own from the documented rules (edges in a dictionary, Python's floats); nothing of wm3d
takes part. Run it without arguments; the output is committed.
"""
import math
import pathlib

FACES = [(0, 2, 4), (0, 5, 2), (0, 4, 8), (0, 10, 5), (0, 8, 10), (1, 6, 3), (1, 3, 7), (1, 8, 6), (1, 7, 10),
         (1, 10, 8), (2, 9, 4), (2, 5, 11), (2, 11, 9), (3, 6, 9), (3, 11, 7), (3, 9, 11), (4, 6, 8), (4, 9, 6),
         (5, 10, 7), (5, 7, 11)]


def projected(v):
    length = math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
    return tuple(x / length for x in v)


def icosahedron():
    phi = (1 + math.sqrt(5)) / 2
    rows = [(0.0, s, t * phi) for s in (1, -1) for t in (1, -1)]
    return [projected(r[-k:] + r[:-k] if k else r) for k in range(3) for r in rows]


def subdivided(vertices, faces):
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
    return finer


def main():
    vertices, faces = icosahedron(), FACES
    lines = ["// SPDX-License-Identifier: GPL-3.0-or-later", "// Written by generate/vertices.py.", "#pragma once", "",
             "#include <wm3d/mesh/types.hpp>", "", "struct VertexVector {", "    wm3d::Index vertex;",
             "    double x, y, z;", "};", "", "inline constexpr VertexVector vertex_vectors[] = {"]
    corners = []
    for level in range(7):
        first = 0 if level == 0 else 10 * 4 ** (level - 1) + 2
        last = len(vertices) - 1
        for v in sorted(set(range(first, last + 1) if level < 2 else
                            [first + (last - first) * k // 11 for k in range(12)])):
            lines.append(f"    {{{v}, {', '.join(x.hex() for x in vertices[v])}}},")
        for f in sorted({len(faces) * k // 9 for k in range(9)} | {len(faces) - 1}):
            corners.append(f"    {{{level}, {f}, {{{', '.join(map(str, faces[f]))}}}}},")
        faces = subdivided(vertices, faces)
    lines += ["};", "", "struct FaceVector {", "    unsigned level;", "    wm3d::Index face;",
              "    wm3d::Triangle corners;", "};", "", "inline constexpr FaceVector face_vectors[] = {"]
    target = pathlib.Path(__file__).resolve().parent.parent / "vertex_vectors.hpp"
    target.write_text("\n".join(lines + corners + ["};", ""]), encoding="ascii")


main()
