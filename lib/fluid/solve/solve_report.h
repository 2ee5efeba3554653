// SPDX-License-Identifier: MIT
// What the solution of a step cost, how good it is, and the error where there is none.
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
    int refinements = 0; ///< solutions for a residual, after the first solution
    double residual = 0; ///< its norm relative to that of the forces
};

} // namespace dsc
