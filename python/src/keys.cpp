// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.hpp"

#include <fmt/format.h>
#include <pybind11/stl/filesystem.h>

namespace wm3d::python {

void bind_keys(py::module_& module) {
    py::class_<Key>(
        module, "Key",
        "An owner's key: 256 secret bits and public parameters. The secret never becomes a Python object.")
        .def_static(
            "generate", [](const std::string& name) { return Key::generate(name); },
            "A new random key; the name is for people.", py::arg("name") = "")
        .def_static(
            "load", [](const std::filesystem::path& path) { return Key::load(path); }, "Reads a key file.",
            py::arg("path"))
        .def(
            "save", [](const Key& key, const std::filesystem::path& path) { key.save(path); },
            "Writes a new file that only its owner may read; never replaces one.", py::arg("path"))
        .def_property_readonly("name", &Key::name)
        .def_property_readonly("fingerprint", &Key::fingerprint, "Public short name, 16 hexadecimal digits.")
        .def_property_readonly("commitment", &Key::commitment, "Public commitment, 64 hexadecimal digits.")
        .def("__repr__", [](const Key& key) {
            return fmt::format("<wm3d.Key {} {}>", key.fingerprint(),
                               std::string(py::repr(py::str(key.name()))));
        });
}

} // namespace wm3d::python
