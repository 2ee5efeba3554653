// SPDX-License-Identifier: MIT
// What judges a mesh and its shapes.
#pragma once

#include "python/mesh.h"

namespace dsc::python {

/// Adds functions of outlines to the module, and those of a mesh to its class.
void add_measures(py::module_& module, py::class_<Mesh, std::shared_ptr<Mesh>>& mesh);

} // namespace dsc::python
