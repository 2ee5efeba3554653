// SPDX-License-Identifier: MIT
// Flows: functions of Python, and the library's own.
#pragma once

#include "dsc/dsc.h"

#include <pybind11/pybind11.h>

#include <variant>

namespace dsc::python {

namespace py = pybind11;

/// A flow of the library's own.
struct BuiltIn {
    std::string name; ///< for its repr
    std::variant<Velocity<double>, InterfaceMotion<double>> flow;
};

/// A velocity that calls `function(x, t)` with the positions (n, 2) of all interface vertices and
/// takes velocities (n, 2) from it, with the GIL. What the function raises comes out of
/// `Simulation::step`; InputError if it returns anything else.
[[nodiscard]] VelocityAtOnce<double> velocity_of(const py::function& function);

/// Adds `Flow`, `swirl` and `curvature_flow` to the module.
void add_flows(py::module_& module);

} // namespace dsc::python
