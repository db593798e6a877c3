// SPDX-License-Identifier: GPL-3.0-or-later
#include "openmesh_subdivision.hpp"

#include <algorithm>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>

#include <wm3d/core/error.hpp>

#include "manifold.hpp"

namespace wm3d::attack {

namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using OpenMeshSurface = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

OpenMeshSurface to_openmesh(const TriangleMesh& mesh) {
    const TriangleMesh manifold = make_manifold(mesh);
    OpenMeshSurface surface;
    std::vector<OpenMeshSurface::VertexHandle> handles;
    handles.reserve(manifold.positions.size());
    for (const Vec3& p : manifold.positions)
        handles.push_back(surface.add_vertex({p[0], p[1], p[2]}));
    for (const Triangle& t : manifold.triangles)
        if (!surface.add_face(handles[t[0]], handles[t[1]], handles[t[2]]).is_valid())
            throw GeometryError(
                "the triangles around vertex " + std::to_string(t[0]) +
                " do not form a surface even after repair; repair the model in a mesh editor");
    return surface;
}

TriangleMesh from_openmesh(OpenMeshSurface& surface) {
    surface.garbage_collection();
    TriangleMesh mesh;
    mesh.positions.reserve(surface.n_vertices());
    for (const auto v : surface.vertices()) {
        const OpenMesh::Vec3d& p = surface.point(v);
        mesh.positions.emplace_back(p[0], p[1], p[2]);
    }
    mesh.triangles.reserve(surface.n_faces());
    for (const auto f : surface.faces()) {
        Triangle t{};
        std::size_t k = 0;
        for (const auto v : surface.fv_range(f))
            t[k++] = static_cast<Index>(v.idx());
        mesh.triangles.push_back(t);
    }
    return mesh;
}

/// The most neighbours that a vertex has. Subdivision gives those it makes six, and the others no more.
std::size_t largest_valence(const OpenMeshSurface& surface) {
    std::size_t largest = 6;
    for (const auto v : surface.vertices())
        largest = std::max<std::size_t>(largest, surface.valence(v));
    return largest;
}

template<typename Subdivider>
TriangleMesh subdivide_by(const TriangleMesh& mesh, int steps) {
    OpenMeshSurface surface = to_openmesh(mesh);
    Subdivider subdivider;
    subdivider.init_weights(largest_valence(surface) + 1); // its table ends at 49, unchecked
    subdivider.attach(surface);
    subdivider(static_cast<std::size_t>(steps));
    subdivider.detach();
    return from_openmesh(surface);
}

} // namespace

TriangleMesh subdivide_loop(const TriangleMesh& mesh, int steps) {
    return subdivide_by<OpenMesh::Subdivider::Uniform::LoopT<OpenMeshSurface>>(mesh, steps);
}

TriangleMesh subdivide_sqrt3(const TriangleMesh& mesh, int steps) {
    return subdivide_by<OpenMesh::Subdivider::Uniform::Sqrt3T<OpenMeshSurface>>(mesh, steps);
}

} // namespace wm3d::attack
