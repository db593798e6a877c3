// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/embed/turned_faces.hpp>

#include <algorithm>
#include <cmath>

#include <wm3d/core/parallel.hpp>

namespace wm3d::embed {

namespace {

Vec3 area_vector_of(std::span<const Vec3> p, const Triangle& t) {
    return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
}

bool is_sliver(std::span<const Vec3> p, const Triangle& t, double double_area) {
    const double longest = std::max({(p[t[1]] - p[t[0]]).squaredNorm(), (p[t[2]] - p[t[1]]).squaredNorm(),
                                     (p[t[0]] - p[t[2]]).squaredNorm()});
    return !(double_area > sliver_shape * longest);
}

bool is_turned(const TriangleMesh& mesh, std::span<const Vec3> moved, const Triangle& t) {
    const Vec3 before = area_vector_of(mesh.positions, t);
    return before.dot(area_vector_of(moved, t)) <= 0 && !is_sliver(mesh.positions, t, before.norm());
}

} // namespace

std::vector<Index> turned_faces(const TriangleMesh& mesh, std::span<const Vec3> moved) {
    constexpr std::size_t block = 16384;
    std::vector<std::vector<Index>> found((mesh.triangles.size() + block - 1) / block);
    parallel_blocks(mesh.triangles.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            if (is_turned(mesh, moved, mesh.triangles[f]))
                found[begin / block].push_back(static_cast<Index>(f));
    });
    std::vector<Index> turned;
    for (const std::vector<Index>& some : found)
        turned.insert(turned.end(), some.begin(), some.end());
    return turned;
}

std::size_t turn_back(const TriangleMesh& mesh, std::vector<Vec3>& moved) {
    constexpr int most_halves = 6; // then the vertex stays where it was
    std::vector<Index> turned = turned_faces(mesh, moved);
    if (turned.empty())
        return 0;
    const std::vector<Vec3> wanted = moved;
    std::vector<int> halves(moved.size(), 0);
    // A vertex that gives way may turn a neighbouring face. Each round brings some vertex nearer to its place,
    // where no face is turned.
    for (; !turned.empty(); turned = turned_faces(mesh, moved)) {
        std::vector<char> gives_way(moved.size(), 0);
        for (const Index f : turned)
            for (const Index v : mesh.triangles[f])
                gives_way[v] = 1;
        for (std::size_t v = 0; v < moved.size(); ++v) {
            if (!gives_way[v] || halves[v] > most_halves)
                continue;
            const Vec3& place = mesh.positions[v];
            moved[v] =
                ++halves[v] > most_halves ? place : place + std::ldexp(1.0, -halves[v]) * (wanted[v] - place);
        }
    }
    return static_cast<std::size_t>(std::ranges::count_if(halves, [](int n) { return n > 0; }));
}

} // namespace wm3d::embed
