// SPDX-License-Identifier: GPL-3.0-or-later
#include "normals.hpp"

#include <numeric>

#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace wm3d::io {

namespace {

/// Below this part of its faces' area, a sum of area vectors has no direction to speak of.
constexpr double least_direction = 1e-3;

/// What the faces of one normal add up to.
struct Sums {
    Vec3 before = Vec3::Zero(), after = Vec3::Zero(); ///< twice their area vectors
    double area = 0;                                  ///< twice their area, before
    Mat3 edges = Mat3::Zero();                        ///< sum of (edge after) (edge before)^T
};

/// The rotation R with the least sum of |R (edge before) - edge after|^2 (Kabsch 1976).
Mat3 best_rotation(const Mat3& edges) {
    const Eigen::JacobiSVD<Mat3> svd(edges, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    return svd.matrixU() * Vec3(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

/// The least turn from one direction to another; half a turn about any axis across where they are opposite.
Eigen::Quaterniond least_turn(const Vec3& from, const Vec3& to) {
    constexpr double opposite = 1e-6; // less than that is left of the sum of the units
    const Vec3 a = from.normalized(), sum = a + to.normalized();
    if (sum.norm() <= opposite) {
        const Vec3 across = a.unitOrthogonal();
        return {0, across[0], across[1], across[2]};
    }
    const Vec3 halfway = sum.normalized(), axis = a.cross(halfway);
    return {a.dot(halfway), axis[0], axis[1], axis[2]};
}

/// The edges tell the twist, the area vectors then the direction.
Vec3 turned(const Vec3& normal, const Sums& sums) {
    if (sums.before == sums.after || !(sums.area > 0) || !normal.allFinite())
        return normal;
    const Mat3 rotation = best_rotation(sums.edges);
    const double least = least_direction * sums.area;
    if (sums.before.norm() <= least || sums.after.norm() <= least)
        return rotation * normal;
    return least_turn(rotation * sums.before, sums.after) * (rotation * normal);
}

/// Twice the area vector of a face.
Vec3 face_vector(const std::vector<Vec3>& points, std::span<const Index> face) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
        sum += (points[face[i]] - points[face[0]]).cross(points[face[i + 1]] - points[face[0]]);
    return sum;
}

Mat3 edge_products(const NormalUses& uses, std::span<const Index> face) {
    Mat3 sum = Mat3::Zero();
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Index a = face[i], b = face[(i + 1) % face.size()];
        sum += (uses.after[b] - uses.after[a]) * (uses.before[b] - uses.before[a]).transpose();
    }
    return sum;
}

/// The uses of a file whose faces are triangles of slots.
template<typename NormalOfSlot>
NormalUses uses_of_slots(Document patched, const Welding& welding, NormalOfSlot&& normal_of_slot) {
    NormalUses uses;
    for (Index vertex : welding.vertex_of_slot)
        uses.before.push_back(welding.mesh.positions[vertex]);
    uses.after = std::move(patched.positions);
    for (const Triangle& triangle : patched.triangles) {
        for (Index slot : triangle) {
            uses.faces.corners.push_back(slot);
            uses.normal_of_corner.push_back(normal_of_slot(slot));
        }
        uses.faces.close_face();
    }
    return uses;
}

/// Patches the normals as any other coordinates: each is a vertex of its own.
std::string patched_bytes(const NormalTable& table, std::vector<Vec3> wanted) {
    TriangleMesh points{table.values, {}};
    for (std::size_t n = 0; n < wanted.size(); ++n)
        if (!wanted[n].allFinite()) // not a number is not even itself; it stays
            wanted[n] = points.positions[n] = Vec3::Zero();
    std::vector<Index> itself(wanted.size());
    std::iota(itself.begin(), itself.end(), Index{0});
    return table.store->patch({points, itself}, wanted, {}).bytes;
}

} // namespace

std::vector<Vec3> turned(const std::vector<Vec3>& normals, const NormalUses& uses) {
    std::vector<Sums> sums(normals.size());
    std::size_t begin = 0;
    for (std::size_t end : uses.faces.ends) {
        const auto face = std::span(uses.faces.corners).subspan(begin, end - begin);
        const Vec3 before = face_vector(uses.before, face), after = face_vector(uses.after, face);
        const Mat3 edges = edge_products(uses, face);
        for (std::size_t corner = begin; corner < end; ++corner)
            if (const Index n = uses.normal_of_corner[corner]; n != no_index) {
                sums[n].before += before;
                sums[n].after += after;
                sums[n].area += before.norm();
                sums[n].edges += edges;
            }
        begin = end;
    }
    std::vector<Vec3> result;
    result.reserve(normals.size());
    for (std::size_t n = 0; n < normals.size(); ++n)
        result.push_back(turned(normals[n], sums[n]));
    return result;
}

PatchedFiles with_turned_normals(PatchedFiles files, Format format, const Source& original,
                                 const Welding& welding, const Resolver& resolver,
                                 std::string_view output_name) {
    const Source patched{original.name, files.bytes};
    const auto itself = [](Index slot) { return slot; };
    std::optional<NormalTable> table;
    NormalUses uses;
    switch (format) {
    case Format::gltf:
    case Format::glb:
        return with_turned_gltf_normals(std::move(files), format == Format::glb, original, resolver,
                                        output_name);
    case Format::ply:
        if ((table = ply_normals(patched)))
            uses = uses_of_slots(read_ply(patched), welding, itself);
        break;
    case Format::off:
        if ((table = off_normals(patched)))
            uses = uses_of_slots(read_off(patched), welding, itself);
        break;
    case Format::stl:
        table = stl_normals(patched);
        uses = uses_of_slots(read_stl(patched), welding, [](Index slot) { return slot / 3; });
        break;
    case Format::obj: {
        NormalUses of_corners;
        if ((table = obj_normals(patched, of_corners))) {
            uses = uses_of_slots(read_obj(patched), welding, itself);
            uses.faces = std::move(of_corners.faces);
            uses.normal_of_corner = std::move(of_corners.normal_of_corner);
        }
        break;
    }
    }
    for (Index point : uses.faces.corners)
        if (point >= uses.after.size())
            patched.fail("its faces can't be told apart, so its normals can't be recomputed; keep them");
    if (table)
        files.bytes = patched_bytes(*table, turned(table->values, uses));
    return files;
}

} // namespace wm3d::io
