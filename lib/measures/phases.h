// SPDX-License-Identifier: MIT
// The areas of the phases and the lengths of their common interfaces. Lengths and areas are those
// of the mesh, whose edges are straight, in units of the domain.
#pragma once

#include "dsc/complex/complex.h"

#include <vector>

namespace dsc::scenes {

struct PhaseFigures {
    Phase phase = exterior_phase;
    double area = 0;
    double perimeter = 0;         ///< length of the edges between it and other phases
    double boundary = 0;          ///< length of its edges on the domain boundary
    std::uint32_t components = 0; ///< triangles joined across edges
    /// Number of holes in all components. Holes that touch at a vertex count as one.
    std::uint32_t holes = 0;
};

struct PairFigures {
    Phase one = exterior_phase; ///< the smaller one
    Phase other = exterior_phase;
    double length = 0; ///< of their common interface
};

struct PhaseReport {
    std::vector<PhaseFigures> phases; ///< phases that have a triangle, ascending
    std::vector<PairFigures> pairs;   ///< pairs that meet along an edge, ascending
};

/// The figures of all phases and pairs. O(triangles + pairs log pairs).
template <class Real>
[[nodiscard]] PhaseReport measure_phases(const Complex<Real>& complex);

} // namespace dsc::scenes
