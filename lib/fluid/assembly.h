// SPDX-License-Identifier: MIT
// The linear system of a step: quadratic velocities and linear pressures (P2-P1).
#pragma once

#include "fluid/convection.h"
#include "fluid/numbering.h"

#include <Eigen/SparseCore>

namespace dsc {

/// The symmetric matrix (A, B'; B, 0) of velocities and pressures, and the forces.
struct FluidSystem {
    /// The lower triangle. Every diagonal entry is stored, those of the pressures as 0.
    Eigen::SparseMatrix<double> matrix;
    Eigen::VectorXd forces;
    /// For each pressure about what its pivot is where the pressure varies least, over the whole
    /// domain: the area that belongs to it over viscosity and inertia. 0 for velocities.
    Eigen::VectorXd pressure_scale;
};

/// The equations at `time` in the mesh of that time. `past` may be empty for
/// `FluidEquations::stokes`. The tension of an edge pulls at its ends, along the edge; beside that
/// it resists what the velocity changes since the last step. Throws InputError if a phase or a pair
/// that meets has no properties. O(n).
[[nodiscard]] FluidSystem assemble(const FrozenMesh& mesh, const FluidNumbering& numbers,
                                   const FluidOptions& options, const FluidPast& past, double time);

} // namespace dsc
