// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.hpp"

#include <optional>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace wm3d::python {

namespace {

using Path = std::filesystem::path;

key::Passphrase passphrase_of(const std::string& text) {
    return key::Passphrase(std::string(text));
}

Key load(const Path& path, const std::optional<std::string>& passphrase) {
    if (!passphrase)
        return Key::load(path);
    return Key::load(path, [&] { return passphrase_of(*passphrase); });
}

void save(const Key& key, const Path& path, const std::optional<std::string>& passphrase) {
    if (!passphrase)
        return key.save(path);
    const key::Passphrase opens = passphrase_of(*passphrase);
    key.save(path, &opens);
}

} // namespace

void bind_keys(py::module_& module) {
    py::class_<Key>(
        module, "Key",
        "An owner's key: 256 secret bits and public parameters. The secret never becomes a Python object.")
        .def_static(
            "generate", [](const std::string& name) { return Key::generate(name); },
            "A new random key; the name is for people.", py::arg("name") = "")
        .def_static("load", load, "Reads a key file, which a passphrase may protect.", py::arg("path"),
                    py::arg("passphrase") = py::none())
        .def("save", save, "Writes a new file that only its owner may read; never replaces one.",
             py::arg("path"), py::arg("passphrase") = py::none())
        .def_property_readonly("name", &Key::name)
        .def_property_readonly("fingerprint", &Key::fingerprint, "Public short name, 16 hexadecimal digits.")
        .def_property_readonly("commitment", &Key::commitment, "Public commitment, 64 hexadecimal digits.")
        .def("__repr__", [](const Key& key) {
            return fmt::format("<wm3d.Key {} {}>", key.fingerprint(),
                               std::string(py::repr(py::str(key.name()))));
        });
}

} // namespace wm3d::python
