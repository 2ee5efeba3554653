// SPDX-License-Identifier: MIT
// Incompressible flow as a class of Python.
#pragma once

#include "python/simulation.h"

namespace dsc::python {

/// Adds `Fluid` to the module.
void add_fluid(py::module_& module);

} // namespace dsc::python
