// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The parts of the compiled module wm3d._core.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <wm3d/wm3d.hpp>

namespace wm3d::python {

namespace py = pybind11;

/// The exceptions as classes: the same sentence, and the stable name of the error as `code`.
void bind_errors(py::module_& module);
void bind_keys(py::module_& module);
void bind_calls(py::module_& module);

/// The mesh of two arrays, `V` (n, 3) of numbers and `F` (m, 3) of whole numbers.
/// \throw ParameterError  if a shape or a type is another, or a face names a vertex that isn't there
/// \throw GeometryError   if a coordinate is not finite
TriangleMesh mesh_of(const py::array& vertices, const py::array& faces);

/// (n, 3), a copy.
py::array_t<double> array_of(std::span<const Vec3> positions);
py::array_t<Index> array_of(std::span<const Triangle> triangles);

/// Results as dictionaries, out of which the package makes its dataclasses.
py::dict marked_fields(const Marked& marked);
py::dict report_fields(const VerifyReport& report);

/// Progress for work that runs without the interpreter's lock. It hears Ctrl-C (KeyboardInterrupt), and calls `callable`
/// unless that is None; whatever either raises stops the work.
Progress progress_of(const py::object& callable);

} // namespace wm3d::python
