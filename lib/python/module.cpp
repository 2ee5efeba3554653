// SPDX-License-Identifier: MIT
// The compiled part of the Python package dsc, which dsc/__init__.py completes.
#include "python/flows.h"
#include "python/mesh.h"
#include "python/simulation.h"

PYBIND11_MODULE(_dsc, module) {
    namespace py = pybind11;
    py::register_exception<dsc::InputError>(module, "InputError", PyExc_ValueError);
    py::register_exception<dsc::FileError>(module, "FileError", PyExc_OSError);
    dsc::python::add_mesh(module);
    dsc::python::add_flows(module);
    dsc::python::add_simulation(module);
}
