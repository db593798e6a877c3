// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivide.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace wm3d::sphere {

namespace {

/// v over its length, summed in a written order so that the bits don't depend on how Eigen adds.
Vec3 projected(const Vec3& v) {
    const double length = std::sqrt(v.x() * v.x() + v.y() * v.y() + v.z() * v.z());
    return {v.x() / length, v.y() / length, v.z() / length};
}

/// The midpoint that each edge got, kept at the edge's smaller vertex.
class Midpoints {
public:
    explicit Midpoints(std::vector<Vec3>& vertices) : vertices_(vertices), edges_(vertices.size()) {}

    Index operator()(Index a, Index b) {
        const auto [low, high] = std::minmax(a, b);
        for (Edge& edge : edges_[low]) {
            if (edge.high == high)
                return edge.midpoint;
            if (edge.high == no_index) {
                edge = {high, static_cast<Index>(vertices_.size())};
                vertices_.push_back(projected(vertices_[a] + vertices_[b]));
                return edge.midpoint;
            }
        }
        return no_index; // a seventh neighbour: excluded by the precondition
    }

private:
    struct Edge {
        Index high = no_index, midpoint = no_index;
    };
    std::vector<Vec3>& vertices_;
    std::vector<std::array<Edge, 6>> edges_;
};

} // namespace

std::vector<Vec3> icosahedron_vertices() {
    const double phi = (1 + std::sqrt(5.0)) / 2;
    std::vector<Vec3> vertices;
    for (int shift = 0; shift < 3; ++shift)
        for (const double s : {1.0, -1.0})
            for (const double t : {phi, -phi}) {
                Vec3 v;
                v[shift] = 0;
                v[(shift + 1) % 3] = s;
                v[(shift + 2) % 3] = t;
                vertices.push_back(projected(v));
            }
    return vertices;
}

std::vector<Triangle> icosahedron_faces() {
    return {{0, 2, 4},  {0, 5, 2},  {0, 4, 8},  {0, 10, 5}, {0, 8, 10}, {1, 6, 3},  {1, 3, 7},
            {1, 8, 6},  {1, 7, 10}, {1, 10, 8}, {2, 9, 4},  {2, 5, 11}, {2, 11, 9}, {3, 6, 9},
            {3, 11, 7}, {3, 9, 11}, {4, 6, 8},  {4, 9, 6},  {5, 10, 7}, {5, 7, 11}};
}

std::vector<Triangle> subdivide(const std::vector<Triangle>& faces, std::vector<Vec3>& vertices) {
    Midpoints midpoint(vertices);
    std::vector<Triangle> finer;
    finer.reserve(4 * faces.size());
    vertices.reserve(vertices.size() + 3 * faces.size() / 2);
    for (const auto& [a, b, c] : faces) {
        const Index ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
        finer.push_back({a, ab, ca});
        finer.push_back({ab, b, bc});
        finer.push_back({ca, bc, c});
        finer.push_back({ab, bc, ca});
    }
    return finer;
}

} // namespace wm3d::sphere
