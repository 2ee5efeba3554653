// SPDX-License-Identifier: MIT
// Attributes as arrays: numbers and points of vertices and of triangles.
#pragma once

#include "python/mesh.h"

namespace dsc::python {

/// Adds the functions behind `Mesh.vertex_data` and `Mesh.triangle_data`, which dsc/data.py makes a
/// dictionary of.
void add_data(py::class_<Mesh, std::shared_ptr<Mesh>>& mesh);

} // namespace dsc::python
