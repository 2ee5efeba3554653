// SPDX-License-Identifier: MIT
// Phases, and the curves that are derived from them: the interface and the domain boundary (thesis,
// section 8.6). Handles must be alive.
#pragma once

#include "dsc/complex/complex.h"

#include <vector>

namespace dsc {

/// An edge is on the domain boundary if it has one triangle, a vertex if it has such an edge. The
/// form for a triangle asks whether one of its edges is. O(1); O(degree) for a vertex.
template <class Real>
[[nodiscard]] bool is_boundary(const Complex<Real>& complex, Vertex v);
template <class Real>
[[nodiscard]] bool is_boundary(const Complex<Real>& complex, Edge e);
template <class Real>
[[nodiscard]] bool is_boundary(const Complex<Real>& complex, Triangle t);

/// An edge is on the interface if its two triangles differ in phase, or if it is on the domain
/// boundary and its triangle's phase is not `exterior_phase` (figure 8.3); a vertex if it has such
/// an edge. The interface has no triangles (thesis, section 4.3): the form for a triangle asks
/// whether one of its edges is on it. O(1); O(degree) for a vertex.
template <class Real>
[[nodiscard]] bool is_interface(const Complex<Real>& complex, Vertex v);
template <class Real>
[[nodiscard]] bool is_interface(const Complex<Real>& complex, Edge e);
template <class Real>
[[nodiscard]] bool is_interface(const Complex<Real>& complex, Triangle t);

/// The phases that occur, ascending. O(n).
template <class Real>
[[nodiscard]] std::vector<Phase> phases(const Complex<Real>& complex);

/// The area of all triangles of a phase, summed with compensation in double. O(n).
template <class Real>
[[nodiscard]] double phase_area(const Complex<Real>& complex, Phase phase);

} // namespace dsc
