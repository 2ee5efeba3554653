// SPDX-License-Identifier: MIT
// The linear system of a step: quadratic velocities and linear pressures (P2-P1).
#pragma once

#include "fluid/field/convection.h"
#include "fluid/system/numbering.h"

namespace dsc {

/// The contribution of a triangle to the equations. Unknown 2 i + k is component k of the velocity
/// at node i, unknown 12 + i the pressure at vertex i.
struct FluidElement {
    std::array<int, 15> unknowns;         ///< their numbers, or `no_unknown`
    Eigen::Matrix<double, 15, 15> matrix; ///< symmetric
    Eigen::Matrix<double, 15, 1> forces;
    /// About the triangle's contribution to the pivot of a pressure for a pressure wave as long as
    /// the domain: a third of the area over viscosity and inertia.
    double pressure_scale;
};

/// The symmetric system (A, B'; B, 0) of velocities and pressures: the sum of its elements.
struct FluidSystem {
    int size = 0;                       ///< how many unknowns there are
    std::vector<FluidElement> elements; ///< by triangle
};

/// The equations at `time` in the mesh of that time. `past` may be empty for
/// `FluidEquations::stokes`. The tension of an edge pulls at its ends along the edge, and an
/// implicit term resists the change of velocity since the last step. Throws InputError if a phase
/// or a pair that meets has no properties. Reuses the memory of `system`. Bitwise identical for any
/// number of threads. O(n).
void assemble(const MeshSnapshot& mesh, const FluidNumbering& numbers, const FluidOptions& options,
              const FluidPast& past, double time, FluidSystem& system);

} // namespace dsc
