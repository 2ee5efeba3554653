// SPDX-License-Identifier: MIT
// The compiled part of the Python package dsc, which dsc/__init__.py completes.
#include "python/fluid.h"
#include "replay/sealed_file.h"

PYBIND11_MODULE(_dsc, module) {
    namespace py = pybind11;
    py::register_exception<dsc::InputError>(module, "InputError", PyExc_ValueError)
        .attr("__doc__") = "Bad input: what is wrong, where, what was given and what is allowed.";
    py::register_exception<dsc::FileError>(module, "FileError", PyExc_OSError).attr("__doc__") =
        "A file that cannot be written, or bytes that are not what was written.";
    // Bytes that a changed byte makes unreadable.
    const dsc::SealedKind kind{"dsc-py"};
    module.def("_sealed",
               [kind](const std::string& bytes) { return py::bytes(dsc::sealed(kind, bytes)); });
    module.def("_unsealed", [kind](const std::string& bytes, const std::string& name) {
        return py::bytes(dsc::unsealed(bytes, kind, name));
    });
    module.def("_write_sealed", [kind](const std::string& path, const std::string& bytes) {
        dsc::write_sealed(path, kind, bytes);
    });
    dsc::python::add_mesh(module);
    dsc::python::add_flows(module);
    dsc::python::add_simulation(module);
    dsc::python::add_fluid(module);
}
