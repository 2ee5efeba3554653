// SPDX-License-Identifier: MIT
// The parts of the module, in the order in which they are added.
#pragma once

#include "python/mesh.h"

namespace dsc::python {

/// Adds `Mesh`; calls the next two functions.
void add_mesh(py::module_& module);
/// Adds the functions behind `Mesh.vertex_data` and `Mesh.triangle_data`.
void add_data(MeshClass& mesh);
/// Adds measures to the class of meshes, and functions of outlines to the module.
void add_measures(py::module_& module, MeshClass& mesh);
/// Adds `Flow`, and the functions that make flows.
void add_flows(py::module_& module);
/// Adds `Simulation`.
void add_simulation(py::module_& module);
/// Adds `Fluid`.
void add_fluid(py::module_& module);

} // namespace dsc::python
