// SPDX-License-Identifier: MIT
// What judges a mesh and its shapes, and outlines to begin with.
#pragma once

#include "python/mesh.h"

namespace dsc::python {

/// Adds functions of outlines to the module, those of a mesh to its class, and the module `shapes`.
void add_measures(py::module_& module, py::class_<Mesh, std::shared_ptr<Mesh>>& mesh);

} // namespace dsc::python
