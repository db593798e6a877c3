// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.hpp"

namespace wm3d::python {

namespace {

/// The classes in Python, which live as long as the interpreter.
struct Kinds {
    py::handle error, input, output, geometry, parameter;
};

Kinds& kinds() {
    static Kinds all;
    return all;
}

py::handle add_kind(py::module_& module, const char* name, py::handle base) {
    return py::exception<Error>(module, name, base).release();
}

py::handle kind_of(const Error& error) {
    if (dynamic_cast<const InputError*>(&error) != nullptr)
        return kinds().input;
    if (dynamic_cast<const OutputError*>(&error) != nullptr)
        return kinds().output;
    if (dynamic_cast<const GeometryError*>(&error) != nullptr)
        return kinds().geometry;
    if (dynamic_cast<const ParameterError*>(&error) != nullptr)
        return kinds().parameter;
    return kinds().error;
}

/// Raises the error with its sentence, and with its code as an attribute.
void raise(const Error& error) {
    const py::handle kind = kind_of(error);
    const py::object instance = kind(error.what());
    instance.attr("code") = std::string(name(error.code()));
    PyErr_SetObject(kind.ptr(), instance.ptr());
}

} // namespace

void bind_errors(py::module_& module) {
    const py::handle error = add_kind(module, "Error", PyExc_RuntimeError);
    kinds() = {error, add_kind(module, "InputError", error), add_kind(module, "OutputError", error),
               add_kind(module, "GeometryError", error), add_kind(module, "ParameterError", error)};
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown)
                std::rethrow_exception(thrown);
        } catch (const Error& caught) {
            raise(caught);
        }
    });
}

} // namespace wm3d::python
