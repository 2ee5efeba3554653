// SPDX-License-Identifier: MIT
// Solves for velocities and pressures.
#pragma once

#include "fluid/solve/solve_report.h"
#include "fluid/system/assembly.h"

namespace dsc {

/// The solution by factorisation and refinement. Throws SolveError if the residual stays above 1e-9
/// of the forces. Bitwise identical for any number of threads. About O(n^1.5).
[[nodiscard]] Eigen::VectorXd solve(const FluidSystem& system, const Dissection& dissection,
                                    const FluidNumbering& numbers, std::uint32_t threads,
                                    SolveReport& report);

/// Velocities and pressures from the unknowns.
[[nodiscard]] FluidField field_of(MeshSnapshot mesh, const FluidNumbering& numbers,
                                  const Eigen::VectorXd& unknowns, double time);

/// The force on each of the sides: the opposite of what is missing in the equations of its nodes.
/// A node where sides meet counts to the first of them. O(n).
[[nodiscard]] std::vector<Point<double>> side_forces(const FluidSystem& system,
                                                     const FluidNumbering& numbers,
                                                     const Eigen::VectorXd& unknowns,
                                                     const FluidField& field, std::size_t sides);

} // namespace dsc
