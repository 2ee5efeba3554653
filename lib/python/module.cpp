// SPDX-License-Identifier: MIT
// The compiled part of the Python package dsc. Its arguments have been checked by dsc/*.py, which
// defines the public interface.
#include "python/module.h"
#include "fluid/solve/solve_report.h"
#include "replay/sealed_file.h"

PYBIND11_MODULE(_dsc, module) {
    namespace py = pybind11;
    module.attr("__version__") = DSC_VERSION;
    py::register_exception<dsc::InputError>(module, "InputError", PyExc_ValueError).doc() =
        "Bad input: what is wrong, where, what was given and what is allowed.";
    py::register_exception<dsc::FileError>(module, "FileError", PyExc_OSError).doc() =
        "A file that cannot be read or written, or damaged bytes.";
    py::register_exception<dsc::SolveError>(module, "SolveError", PyExc_RuntimeError).doc() =
        "Equations of a fluid that cannot be solved: triangles have degenerated, or it is too "
        "fast.";
    // Seals bytes, so that a changed byte is detected. Raise the version with every change of what
    // pickles contain: those of an earlier one are then refused as such.
    const dsc::SealedKind kind{"dsc-py", 4};
    module.def("sealed",
               [kind](const std::string& bytes) { return py::bytes(dsc::sealed(kind, bytes)); });
    module.def("unsealed", [kind](const std::string& bytes, const std::string& name) {
        return py::bytes(dsc::unsealed(bytes, kind, name));
    });
    module.def("write_sealed", [kind](const std::string& path, const std::string& bytes) {
        dsc::write_sealed(path, kind, bytes);
    });
    dsc::python::add_mesh(module);
    dsc::python::add_mesh3(module);
    dsc::python::add_flows(module);
    dsc::python::add_simulation(module);
    dsc::python::add_simulation3(module);
    dsc::python::add_fluid(module);
}
