// SPDX-License-Identifier: MIT
// The mesh functions of thesis section 4.1: insertion, removal, orientation, and what is derived
// from the phases: interface, domain boundary, submesh boundary (thesis, section 8.6). Handles must
// be alive, except for `is_valid_simplex` and `remove`.
//
// Insertion and removal take simplices in any order. In between, a vertex may have more than one
// fan of triangles: the complex is then not a manifold (thesis, section 3.2), `validate` reports
// this, and any function that rotates about that vertex (star, link, is_boundary...) sees only one
// of the fans until the gaps are filled. The mesh operations in lib/dsc/operations never pass
// through such states.
#pragma once

#include "dsc/algebra/simplex_set.h"
#include "dsc/complex/complex.h"
#include "dsc/complex/submesh.h"

#include <vector>

namespace dsc {

/// Inserts a vertex without triangles. Attributes take their initial values. O(1) amortised. Throws
/// InputError if a coordinate is not finite or no id is left.
template <class Real>
Vertex insert_vertex(Complex<Real>& complex, const Point<Real>& p);

/// Inserts a triangle between three living vertices, in either orientation, together with those of
/// its edges that do not exist yet (thesis, section 8.2), and links it with its neighbours.
/// Attributes take their initial values; an edge that exists keeps its own. O(n), because the
/// neighbours are searched for among all triangles: to build a whole mesh use `make_complex`.
/// Throws InputError if a vertex is dead or named twice, the area is zero, the phase is reserved,
/// an edge has two triangles already, the triangle would overlap the one already at its edge, or no
/// id is left; the complex is then unchanged.
template <class Real>
Triangle insert_triangle(Complex<Real>& complex, Vertex a, Vertex b, Vertex c, Phase phase);

/// Removes all simplices of the set, and their superfaces, which could not exist without them: a
/// triangle leaves its edges and vertices behind, an edge takes its triangles with it, a vertex its
/// whole star. An edge is removed with its last triangle: edges do not exist without triangles
/// (thesis, section 8.2); a vertex may exist without any. Simplices that are not alive are skipped.
/// O(k log k) for k simplices; O(n) if vertices are among them or a vertex loses its last triangle.
/// Returns the number of triangles removed.
template <class Real>
std::size_t remove(Complex<Real>& complex, const SimplexSet& set);

/// +1 counter-clockwise, -1 clockwise, 0 degenerate; exact. Every triangle of a valid complex has
/// +1.
template <class Real>
[[nodiscard]] int orientation(const Complex<Real>& complex, Triangle t);

/// True if the handle names a living simplex.
template <class Real>
[[nodiscard]] bool is_valid_simplex(const Complex<Real>& complex, Vertex v);
template <class Real>
[[nodiscard]] bool is_valid_simplex(const Complex<Real>& complex, Edge e);
template <class Real>
[[nodiscard]] bool is_valid_simplex(const Complex<Real>& complex, Triangle t);

/// The phase of a triangle. Edges and vertices have none of their own.
template <class Real>
[[nodiscard]] Phase phase(const Complex<Real>& complex, Triangle t);

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

/// The phases that occur, ascending. O(n).
template <class Real>
[[nodiscard]] std::vector<Phase> phases(const Complex<Real>& complex);

/// The area of all triangles of a phase, summed with compensation in double. O(n).
template <class Real>
[[nodiscard]] double phase_area(const Complex<Real>& complex, Phase phase);

} // namespace dsc
