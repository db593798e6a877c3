// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Watching a simplification: what a parameterization that is built along with it needs to know.
#pragma once

#include <cstddef>
#include <span>

#include <wm3d/mesh/types.hpp>

namespace wm3d::simplify {

/// The surface as the simplification sees it. Its vertices are the input's along a space-filling curve,
/// without the isolated ones; a vertex where several fans meet appears once for each of its fans. Positions
/// are centred and scaled to a box of about 1, which changes no angle and no ratio.
struct WorkingSurface {
    std::span<const Vec3> positions;     ///< #W
    std::span<const Index> corners;      ///< 3 #F: working vertices; corner k of face f is number 3 f + k
    std::span<const Index> input_vertex; ///< #W: number in the input
};

/// One of the edges at a vertex: the neighbour at its other end, and the corner, at the vertex, of the
/// triangle that follows counter-clockwise, as a number 3 face + k; no_index where the boundary follows.
struct Spoke {
    Index vertex = no_index;
    Index corner = no_index;
};

/// A half-edge collapse: vertex `removed` goes to vertex `kept`, and every corner at `removed` becomes
/// `kept`. The triangles on both sides of the edge (one if it lies on the boundary) vanish.
struct Collapse {
    Index removed = no_index;
    Index kept = no_index;
    /// Edges at `removed` counter-clockwise before the collapse: the triangle of ring[i] is (removed,
    /// ring[i], ring[i + 1]). Around a boundary vertex the ring is open: its last edge has no triangle. Valid
    /// during the call.
    std::span<const Spoke> ring;
    std::size_t place = 0; ///< of `kept` in the ring; the first or the last of an open one
    /// If no triangle of the ring survives (an ear of the boundary is cut off): the corner at ring[1] of the
    /// triangle beyond the edge between ring[0] and ring[1]; the next corner of that triangle is at ring[0].
    /// Else no_index.
    Index beyond = no_index;

    bool closed() const { return ring.back().corner != no_index; }
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
