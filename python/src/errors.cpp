// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.hpp"

namespace wm3d::python {

namespace {

/// Registers a kind of error; those registered last are tried first.
template <typename Kind>
py::object bind_kind(py::module_& module, const char* name, const py::object& base, const char* code) {
    py::object kind = py::register_exception<Kind>(module, name, base);
    kind.attr("code") = code;
    return kind;
}

} // namespace

void bind_errors(py::module_& module) {
    const py::object runtime_error = py::reinterpret_borrow<py::object>(PyExc_RuntimeError);
    const py::object error = bind_kind<Error>(module, "Error", runtime_error, "error");
    bind_kind<InputError>(module, "InputError", error, "input");
    bind_kind<OutputError>(module, "OutputError", error, "output");
    bind_kind<GeometryError>(module, "GeometryError", error, "geometry");
    bind_kind<ParameterError>(module, "ParameterError", error, "parameter");
}

} // namespace wm3d::python
