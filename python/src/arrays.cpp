// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.hpp"

#include <fmt/format.h>

namespace wm3d::python {

namespace {

std::string shape_of(const py::array& array) {
    std::string text;
    for (py::ssize_t k = 0; k < array.ndim(); ++k)
        text += fmt::format("{}{}", k > 0 ? ", " : "", array.shape(k));
    return fmt::format("({}{})", text, array.ndim() == 1 ? "," : "");
}

void require_rows_of_three(const py::array& array, std::string_view name) {
    if (array.ndim() != 2 || array.shape(1) != 3)
        throw ParameterError(
            fmt::format("{} has the shape {}; give an array of shape (n, 3)", name, shape_of(array)));
}

void require_kind(const py::array& array, std::string_view name, std::string_view kinds,
                  std::string_view wanted) {
    if (kinds.find(array.dtype().kind()) == std::string_view::npos)
        throw ParameterError(
            fmt::format("{} holds '{}'; give {}", name, std::string(py::str(array.dtype())), wanted));
}

std::vector<Vec3> positions_of(const py::array& vertices) {
    require_rows_of_three(vertices, "V");
    require_kind(vertices, "V", "fiu", "real numbers");
    const auto values = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(vertices);
    const auto rows = values.unchecked<2>();
    std::vector<Vec3> positions(static_cast<std::size_t>(rows.shape(0)));
    for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
        Vec3& p = positions[static_cast<std::size_t>(i)];
        p = Vec3(rows(i, 0), rows(i, 1), rows(i, 2));
        if (!p.allFinite())
            throw GeometryError(fmt::format("V[{}] is not finite; remove the vertex or mend it", i));
    }
    return positions;
}

std::vector<Triangle> triangles_of(const py::array& faces, std::size_t vertices) {
    require_rows_of_three(faces, "F");
    require_kind(faces, "F", "iu", "whole numbers");
    const auto values = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>::ensure(faces);
    const auto rows = values.unchecked<2>();
    std::vector<Triangle> triangles(static_cast<std::size_t>(rows.shape(0)));
    for (py::ssize_t i = 0; i < rows.shape(0); ++i)
        for (py::ssize_t k = 0; k < 3; ++k) {
            const std::int64_t v = rows(i, k);
            if (v < 0 || static_cast<std::size_t>(v) >= vertices)
                throw ParameterError(
                    fmt::format("F[{}] names vertex {}, and V has {}; count from 0", i, v, vertices));
            triangles[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = static_cast<Index>(v);
        }
    return triangles;
}

} // namespace

TriangleMesh mesh_of(const py::array& vertices, const py::array& faces) {
    TriangleMesh mesh;
    mesh.positions = positions_of(vertices);
    mesh.triangles = triangles_of(faces, mesh.positions.size());
    return mesh;
}

py::array_t<double> array_of(std::span<const Vec3> positions) {
    py::array_t<double> array({static_cast<py::ssize_t>(positions.size()), py::ssize_t{3}});
    auto rows = array.mutable_unchecked<2>();
    for (std::size_t i = 0; i < positions.size(); ++i)
        for (int k = 0; k < 3; ++k)
            rows(static_cast<py::ssize_t>(i), k) = positions[i][k];
    return array;
}

py::array_t<Index> array_of(std::span<const Triangle> triangles) {
    py::array_t<Index> array({static_cast<py::ssize_t>(triangles.size()), py::ssize_t{3}});
    auto rows = array.mutable_unchecked<2>();
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            rows(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) = triangles[i][k];
    return array;
}

} // namespace wm3d::python
