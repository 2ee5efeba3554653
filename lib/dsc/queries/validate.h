// SPDX-License-Identifier: MIT
// Validation: whether a complex is simplicial (thesis, chapter 3) and a manifold (section 3.2).
#pragma once

#include "dsc/complex/complex.h"

#include <cstdint>
#include <string>

namespace dsc {

/// What `validate` found. The counts are of living simplices; those below `unused_vertices` are
/// filled in only if the links are consistent.
struct ValidationReport {
    std::string problem;               ///< empty if valid; else the first bad element and its fault
    std::uint64_t vertices = 0;        ///< living vertices, unused ones included
    std::uint64_t triangles = 0;       ///< living triangles
    std::uint64_t unused_vertices = 0; ///< living vertices without triangles: allowed
    std::uint64_t edges = 0;           ///< inner ones and those of the boundary
    std::uint64_t components = 0;      ///< parts connected through edges
    std::uint64_t boundary_loops = 0;  ///< one around each component, and one around each hole
    /// V - E + T of the vertices in use: 1 for each component, less 1 for each hole.
    std::int64_t euler_characteristic = 0;

    /// Whether nothing is wrong.
    [[nodiscard]] bool ok() const { return problem.empty(); }
};

/// Checks all properties of a valid complex, with exact predicates. It may be called on arbitrary
/// data: broken links cause neither a crash nor an endless loop. In this order: the border
/// triangle; the size of the attributes; the vertices (finite, corner at itself); the triangles
/// (vertices alive and distinct, phase not reserved, links symmetric and with the same vertices at
/// both sides, orientation > 0); the free ids; every vertex a disc or half disc that goes around it
/// once; the Euler characteristic; and that the boundary nowhere meets itself and no component
/// covers another. Together these say that no two simplices overlap anywhere. O(n + b log b) for b
/// boundary edges, and O(b) more for each loop where there are several components.
template <class Real>
[[nodiscard]] ValidationReport validate(const Complex<Real>& complex);

/// Throws InvariantError with the problem reported if the complex is not valid.
template <class Real>
void validate_or_throw(const Complex<Real>& complex);

} // namespace dsc
