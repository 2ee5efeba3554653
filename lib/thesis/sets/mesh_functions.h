// SPDX-License-Identifier: MIT
// The mesh functions of thesis section 4.1 that the core does not have; it has `is_boundary` and
// `is_interface` (dsc/queries/phases.h). Handles must be alive, except for `is_valid_simplex`.
#pragma once

#include "thesis/sets/simplex_set.h"

#include "dsc/complex/submesh.h"
#include "dsc/queries/phases.h"

namespace dsc {

/// The orientation of a triangle, exactly: +1 counter-clockwise, -1 clockwise, 0 degenerate. Every
/// triangle of a valid complex has +1.
template <class Real>
[[nodiscard]] int orientation(const Complex<Real>& complex, Triangle t);

/// True if the handle names a living simplex.
template <class Real>
[[nodiscard]] bool is_valid_simplex(const Complex<Real>& complex, Vertex v);
template <class Real>
[[nodiscard]] bool is_valid_simplex(const Complex<Real>& complex, Edge e);
template <class Real>
[[nodiscard]] bool is_valid_simplex(const Complex<Real>& complex, Triangle t);

/// The phase of a triangle. Edges and vertices have no phase of their own.
template <class Real>
[[nodiscard]] Phase phase(const Complex<Real>& complex, Triangle t);

/// A triangle is in the submesh if all its vertices are owned. A vertex is on the submesh boundary
/// if it is owned and a triangle of its star is not in the submesh; an edge if exactly one of its
/// two triangles is in the submesh: an edge of the domain boundary never is. Simplices outside the
/// submesh are not on its boundary (they are locked nevertheless). O(1); O(degree) for a vertex.
template <class Real>
[[nodiscard]] bool is_submesh_boundary(const Complex<Real>& complex, const Region& region,
                                       Vertex v);
template <class Real>
[[nodiscard]] bool is_submesh_boundary(const Complex<Real>& complex, const Region& region, Edge e);

/// All interface edges and their vertices: a curve that is never stored. O(n).
template <class Real>
[[nodiscard]] SimplexSet interface_of(const Complex<Real>& complex);

} // namespace dsc
