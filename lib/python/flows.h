// SPDX-License-Identifier: MIT
// Flows: functions of Python, and the library's own.
#pragma once

#include "python/arrays.h"

#include "geometric_flows/geometric_flows.h"

#include <optional>
#include <string>
#include <variant>

namespace dsc::python {

/// A velocity in Python that is given the interface.
struct SeeingFunction {
    Shared<py::function> function;
};

/// What `dsc.Flow` is in Python.
struct OwnFlow {
    std::string name; ///< of the function of the module that makes it...
    py::tuple given;  ///< ...from these arguments: for its repr, and for pickles
    std::variant<Velocity<double>, InterfaceMotion<double>, InterfaceFlow<double>, SeeingFunction>
        flow;
    std::optional<GrowthOptions<double>> growth = {}; ///< a simulation is made for it
};

/// A velocity that calls `function(x, t)` with the positions (n, 2) of all interface vertices and
/// takes velocities (n, 2) from it, with the GIL. What the function raises comes out of
/// `Simulation::step`; InputError if it returns anything else.
[[nodiscard]] VelocityAtOnce<double> velocity_of(const py::function& function);

/// A motion that calls `function(interface, t)` in each stage of the integrator, once for the whole
/// interface. Throws InputError for `adaptive`, which motions have no estimate for.
[[nodiscard]] InterfaceMotion<double> motion_of(const SeeingFunction& seeing,
                                                Integrator integrator);

/// Adds `Flow` and the functions that make flows to the module.
void add_flows(py::module_& module);

} // namespace dsc::python
