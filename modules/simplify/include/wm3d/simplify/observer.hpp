// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Watching a simplification: what a parameterization that is built along with it needs to know.
#pragma once

#include <span>

#include <wm3d/mesh/types.hpp>

namespace wm3d::simplify {

/// The surface as the simplification sees it. Its vertices are the input's along a space-filling curve, without
/// the isolated ones; a vertex where several fans meet appears once for each of its fans. Positions are centred
/// and scaled to a box of about 1, which changes no angle and no ratio.
struct WorkingSurface {
    std::span<const Vec3> positions;      ///< #W
    std::span<const Index> corners;       ///< 3 #F: working vertices; corner k of face f is number 3 f + k
    std::span<const Index> input_vertex;  ///< #W: number in the input
};

/// A half-edge collapse: vertex `removed` goes to vertex `kept`, and every corner at `removed` becomes `kept`.
/// The spans live until the call returns.
struct Collapse {
    Index removed = no_index;
    Index kept = no_index;
    bool closed = true; ///< the ring goes all around `removed`; if not, `removed` lies on the boundary
    /// Neighbours of `removed` counter-clockwise. If closed, the first is `kept`; if open, `kept` is the first or
    /// the last.
    std::span<const Index> ring;
    /// corners[i] is the corner at `removed` of the triangle (removed, ring[i], ring[i + 1]), as a number
    /// 3 face + k; one per ring vertex if closed, one fewer if open. The triangles on both sides of the edge
    /// (one if open) vanish, the others survive with `kept` at that corner.
    std::span<const Index> corners;
    /// If no triangle of the ring survives (an ear of the boundary is cut off): the corner at ring[1] of the triangle
    /// beyond the edge between ring[0] and ring[1]; the next corner of that triangle is at ring[0]. Else no_index.
    Index beyond = no_index;
};

/// Told of each step of a simplification, in order, from one thread.
class Observer {
public:
    virtual ~Observer() = default;
    /// Before the first collapse. The spans live until `finish` returns.
    virtual void start(const WorkingSurface& surface) = 0;
    virtual void collapse(const Collapse& step) = 0;
    /// After the last. Triangle t of the base mesh is working face faces[t], its corners in the same order.
    virtual void finish(std::span<const Index> faces) = 0;
};

} // namespace wm3d::simplify
