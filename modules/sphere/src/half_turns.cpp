// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/sphere/half_turns.hpp>

#include <algorithm>

#include <wm3d/core/parallel.hpp>

#include "subdivide.hpp"

namespace wm3d::sphere {

namespace {

/// Half turn about an axis: the signs of the other two coordinates change, which is exact.
Vec3 turned(const Vec3& p, std::size_t axis) {
    Vec3 q = -p;
    q[static_cast<Eigen::Index>(axis)] = p[static_cast<Eigen::Index>(axis)];
    return q;
}

/// The face that a symmetry takes a face to: corner k comes to lie at the corner places[k].
struct FaceImage {
    Index face = no_index;
    std::array<unsigned, 3> places{};

    /// Where the child at a corner goes: to the child at that corner's place, and corner k of it as corner k of its
    /// parent.
    FaceImage at_corner(unsigned corner) const { return {4 * face + places[corner], places}; }

    /// Corner k of the middle child lies across from corner k + 2 of its parent.
    FaceImage middle() const {
        return {4 * face + 3, {(places[2] + 1) % 3, (places[0] + 1) % 3, (places[1] + 1) % 3}};
    }
};

/// The place in a face of the corner that lies at p; 3 if none does.
unsigned place_in(const Triangle& face, const std::vector<Vec3>& vertices, const Vec3& p) {
    return static_cast<unsigned>(std::ranges::find_if(face, [&](Index v) { return vertices[v] == p; }) -
                                 face.begin());
}

/// Of the icosahedron's faces, by the coordinates of their corners.
template<typename Symmetry>
std::vector<FaceImage> images_of_icosahedron(const Symmetry& moved) {
    const std::vector<Vec3> vertices = icosahedron_vertices();
    const std::vector<Triangle> faces = icosahedron_faces();
    std::vector<FaceImage> images;
    for (const Triangle& face : faces)
        for (Index to = 0; to < faces.size(); ++to) {
            FaceImage image{to, {}};
            for (std::size_t k = 0; k < 3; ++k)
                image.places[k] = place_in(faces[to], vertices, moved(vertices[face[k]]));
            if (std::ranges::all_of(image.places, [](unsigned place) { return place < 3; }))
                images.push_back(image);
        }
    return images;
}

/// The number of the vertex to which a symmetry of the icosahedron takes vertex j: it takes children to children.
template<typename Symmetry>
std::vector<Index> permutation(const Icosphere& sphere, const Symmetry& moved) {
    std::vector<FaceImage> images = images_of_icosahedron(moved);
    for (unsigned level = 0; level < sphere.level(); ++level) {
        std::vector<FaceImage> finer;
        finer.reserve(4 * images.size());
        for (const FaceImage& image : images)
            finer.insert(finer.end(),
                         {image.at_corner(0), image.at_corner(1), image.at_corner(2), image.middle()});
        images = std::move(finer);
    }
    std::vector<Index> to(sphere.vertices().size());
    for (std::size_t f = 0; f < images.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
            to[sphere.faces()[f][k]] = sphere.faces()[images[f].face][images[f].places[k]];
    return to;
}

} // namespace

std::array<std::vector<Index>, 3> half_turns(const Icosphere& sphere) {
    std::array<std::vector<Index>, 3> turns;
    parallel_blocks(3, 1, [&](std::size_t axis, std::size_t) {
        turns[axis] = permutation(sphere, [axis](const Vec3& p) { return turned(p, axis); });
    });
    return turns;
}

std::vector<Index> inversion(const Icosphere& sphere) {
    return permutation(sphere, [](const Vec3& p) -> Vec3 { return -p; });
}

std::optional<int> half_turn_axis(const Mat3& rotation) {
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 diagonal = -Vec3::Ones();
        diagonal[axis] = 1;
        if ((rotation - Mat3(diagonal.asDiagonal())).cwiseAbs().maxCoeff() < 1e-12)
            return axis;
    }
    return std::nullopt;
}

} // namespace wm3d::sphere
