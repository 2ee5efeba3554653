// SPDX-License-Identifier: MIT
// The parts of the module, in the order in which they are added.
#pragma once

#include "python/mesh.h"

namespace dsc::python {

/// Adds `Mesh`; calls `add_data` and `add_measures`.
void add_mesh(py::module_& module);
/// Adds `Mesh3`, and the distances to shapes of which it is made.
void add_mesh3(py::module_& module);
/// Adds the functions behind `vertex_data`, `triangle_data` and `tet_data` of meshes.
template <class AnyMesh>
void add_data(py::class_<AnyMesh, std::shared_ptr<AnyMesh>>& mesh);
/// Adds measures to the class of meshes, and functions of outlines to the module.
void add_measures(py::module_& module, MeshClass& mesh);
/// Adds `Flow`, and the functions that make flows.
void add_flows(py::module_& module);
/// Adds `Simulation`.
void add_simulation(py::module_& module);
/// Adds `Simulation3`, of a `Mesh3`.
void add_simulation3(py::module_& module);
/// Adds `Fluid`.
void add_fluid(py::module_& module);

} // namespace dsc::python
