// SPDX-License-Identifier: MIT
// A simulation as Python sees it.
#pragma once

#include <pybind11/pybind11.h>

namespace dsc::python {

/// Adds `Simulation`, `Report` and `Event` to the module.
void add_simulation(pybind11::module_& module);

} // namespace dsc::python
