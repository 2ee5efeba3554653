// SPDX-License-Identifier: MIT
// The cost and residual of the solution of a step, and the error thrown if there is none.
#pragma once

#include <stdexcept>

namespace dsc {

/// Equations that could not be solved: the velocity has grown beyond all bounds, or triangles have
/// degenerated.
class SolveError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A solution of a linear system.
struct SolveReport {
    int unknowns = 0;    ///< velocities and pressures
    int refinements = 0; ///< iterations of refinement after the first solution
    double residual = 0; ///< its norm relative to that of the forces
};

} // namespace dsc
