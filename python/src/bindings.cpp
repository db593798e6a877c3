// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.hpp"

PYBIND11_MODULE(_core, module) {
    module.doc() = "What wm3d computes; import wm3d instead.";
    module.attr("version") = std::string(wm3d::version());
    wm3d::python::bind_errors(module);
    wm3d::python::bind_keys(module);
    wm3d::python::bind_calls(module);
}
