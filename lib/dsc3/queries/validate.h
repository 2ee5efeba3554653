// SPDX-License-Identifier: MIT
// Checks that a complex is embedded and a manifold with boundary.
#pragma once

#include "dsc3/complex/complex.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dsc3 {

/// The surface of a phase: all faces between it and others, the domain boundary included.
struct PhaseSurface {
    Phase phase = exterior_phase;
    std::uint64_t faces = 0;
    std::int64_t euler_characteristic = 0; ///< V - E + F: 2 for each sphere, 0 for a torus
};

/// What `validate` found.
struct ValidationReport {
    std::string problem;        ///< empty if valid; else the first bad element and its error
    std::uint64_t vertices = 0; ///< living vertices
    std::uint64_t tets = 0;     ///< living tets
    std::uint64_t faces = 0;    ///< inside and on the domain boundary
    std::uint64_t edges = 0;    ///< of all tets
    std::int64_t euler_characteristic = 0; ///< V - E + F - T: 1 for a ball
    std::vector<PhaseSurface> surfaces;    ///< by ascending phase

    /// Whether nothing is wrong.
    [[nodiscard]] bool ok() const { return problem.empty(); }
};

/// Checks everything that can be wrong, with exact predicates. It may be called on arbitrary data.
/// In this order: the border; the vertices (finite, corner at itself); the tets (vertices alive and
/// distinct, phase not reserved, links symmetric and with the same vertices at both sides,
/// orientation > 0); the free ids; the flags of the vertices; the link of every vertex (one sphere
/// or disc); and the domain: a ball whose boundary lies on the sides of a box, with the volume of
/// the box. Together these imply that no two simplices overlap: positive tets around each vertex
/// cover the box equally often everywhere, and the volume shows that this is once. O(n log n).
[[nodiscard]] ValidationReport validate(const Complex& complex);

/// Throws InvariantError with the problem reported if the complex is not valid.
void validate_or_throw(const Complex& complex);

} // namespace dsc3
