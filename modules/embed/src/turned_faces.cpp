// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/embed/turned_faces.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <wm3d/core/parallel.hpp>

namespace wm3d::embed {

namespace {

bool is_sliver(std::span<const Vec3> p, const Triangle& t, double double_area) {
    const double longest = std::max({(p[t[1]] - p[t[0]]).squaredNorm(), (p[t[2]] - p[t[1]]).squaredNorm(),
                                     (p[t[0]] - p[t[2]]).squaredNorm()});
    return !(double_area > sliver_shape * longest);
}

bool is_turned(const TriangleMesh& mesh, std::span<const Vec3> moved, const Triangle& t) {
    const auto area_vector_of = [](const Vec3& a, const Vec3& b, const Vec3& c) -> Vec3 {
        return (b - a).cross(c - a);
    };
    const std::span<const Vec3> p = mesh.positions;
    const Vec3 before = area_vector_of(p[t[0]], p[t[1]], p[t[2]]);
    const Vec3 after = area_vector_of(moved[t[0]], moved[t[1]], moved[t[2]]);
    return before.dot(after) <= 0 && !is_sliver(p, t, before.norm());
}

/// Faces that a predicate holds for, ascending.
template<typename Predicate>
std::vector<Index> faces_where(const TriangleMesh& mesh, Predicate&& holds) {
    constexpr std::size_t block = 16384;
    std::vector<std::vector<Index>> found((mesh.triangles.size() + block - 1) / block);
    parallel_blocks(mesh.triangles.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            if (holds(mesh.triangles[f]))
                found[begin / block].push_back(static_cast<Index>(f));
    });
    std::vector<Index> faces;
    for (const std::vector<Index>& some : found)
        faces.insert(faces.end(), some.begin(), some.end());
    return faces;
}

/// Ascending, each once.
std::vector<Index> corners_of(const TriangleMesh& mesh, const std::vector<Index>& faces) {
    std::vector<Index> corners;
    for (const Index f : faces)
        corners.insert(corners.end(), mesh.triangles[f].begin(), mesh.triangles[f].end());
    std::ranges::sort(corners);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

/// A vertex that has given way.
struct Halved {
    Vec3 wanted; ///< where it was to go
    int halves = 0;
};

} // namespace

std::vector<Index> turned_faces(const TriangleMesh& mesh, std::span<const Vec3> moved) {
    return faces_where(mesh, [&](const Triangle& t) { return is_turned(mesh, moved, t); });
}

std::size_t turn_back(const TriangleMesh& mesh, std::vector<Vec3>& moved) {
    constexpr int most_halves = 6; // then the vertex stays where it was
    std::unordered_map<Index, Halved> halved;
    std::vector<char> gave_way(moved.size(), 0); // in this round
    // A vertex that gives way may turn a neighbouring face. Each round brings some vertex nearer to its place,
    // where no face is turned.
    for (std::vector<Index> turned = turned_faces(mesh, moved); !turned.empty();) {
        const std::vector<Index> corners = corners_of(mesh, turned);
        for (const Index v : corners) {
            auto& [wanted, halves] = halved.try_emplace(v, Halved{moved[v]}).first->second;
            if (halves > most_halves)
                continue;
            const Vec3& place = mesh.positions[v];
            moved[v] = ++halves > most_halves ? place : place + std::ldexp(1.0, -halves) * (wanted - place);
            gave_way[v] = 1;
        }
        turned = faces_where(mesh, [&](const Triangle& t) {
            return std::ranges::any_of(t, [&](Index v) { return gave_way[v] != 0; }) &&
                   is_turned(mesh, moved, t);
        });
        for (const Index v : corners)
            gave_way[v] = 0;
    }
    return halved.size();
}

} // namespace wm3d::embed
