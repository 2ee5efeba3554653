// SPDX-License-Identifier: MIT
// The simplex relations and operations of thesis section 3.1 (after Misztal & Baerentzen):
// boundary, full boundary, star, closure, link; skeleton and filter live with the sets. These
// functions are the readable way to query a complex; the mesh operations navigate by corners
// instead, because allocating arrays would be too slow for them.
//
// For a simplex that is not in the complex the answer is the empty set. Complexities: d is the
// degree of the vertex (or the sum of the degrees), k the number of simplices collected for a set.
#pragma once

#include "dsc/complex/circulate.h"
#include "thesis/sets/simplex_set.h"

namespace dsc {

/// The faces of one dimension less (thesis, figure 3.3): of an edge its two vertices, of a triangle
/// its three edges, of a vertex nothing. O(1).
template <class Real>
[[nodiscard]] SimplexSet boundary(const Complex<Real>& complex, Vertex v);
template <class Real>
[[nodiscard]] SimplexSet boundary(const Complex<Real>& complex, Edge e);
template <class Real>
[[nodiscard]] SimplexSet boundary(const Complex<Real>& complex, Triangle t);
/// The union of the boundaries of the members. O(k log k).
template <class Real>
[[nodiscard]] SimplexSet boundary(const Complex<Real>& complex, const SimplexSet& set);

/// All simplices of lower dimension that are faces, boundary* (thesis, figure 3.4). O(1).
template <class Real>
[[nodiscard]] SimplexSet full_boundary(const Complex<Real>& complex, Vertex v);
template <class Real>
[[nodiscard]] SimplexSet full_boundary(const Complex<Real>& complex, Edge e);
template <class Real>
[[nodiscard]] SimplexSet full_boundary(const Complex<Real>& complex, Triangle t);

/// The simplices that have this one as a face, itself included (thesis, figure 3.5). O(d log d) for
/// a vertex, O(1) for an edge and for a triangle.
template <class Real>
[[nodiscard]] SimplexSet star(const Complex<Real>& complex, Vertex v);
template <class Real>
[[nodiscard]] SimplexSet star(const Complex<Real>& complex, Edge e);
template <class Real>
[[nodiscard]] SimplexSet star(const Complex<Real>& complex, Triangle t);
/// The union of the stars of the members. O(k log k).
template <class Real>
[[nodiscard]] SimplexSet star(const Complex<Real>& complex, const SimplexSet& set);

/// The simplex and its full boundary (thesis, figure 3.6). O(1).
template <class Real>
[[nodiscard]] SimplexSet closure(const Complex<Real>& complex, Vertex v);
template <class Real>
[[nodiscard]] SimplexSet closure(const Complex<Real>& complex, Edge e);
template <class Real>
[[nodiscard]] SimplexSet closure(const Complex<Real>& complex, Triangle t);
/// The union of the closures of the members: the smallest complex that holds them. O(k log k).
template <class Real>
[[nodiscard]] SimplexSet closure(const Complex<Real>& complex, const SimplexSet& set);

/// closure(star(s)) \ star(closure(s)) (thesis, figure 3.7): around a vertex the cycle of vertices
/// and edges, of an edge the one or two vertices opposite to it, of a triangle nothing (its star is
/// itself). O(d log d) for a vertex, O(1) otherwise.
template <class Real>
[[nodiscard]] SimplexSet link(const Complex<Real>& complex, Vertex v);
template <class Real>
[[nodiscard]] SimplexSet link(const Complex<Real>& complex, Edge e);
template <class Real>
[[nodiscard]] SimplexSet link(const Complex<Real>& complex, Triangle t);
/// The union of the links of the members, as section 3.1 defines an operation on a set. It is not
/// closure(star(set)) \ star(closure(set)). O(k log k).
template <class Real>
[[nodiscard]] SimplexSet link(const Complex<Real>& complex, const SimplexSet& set);

/// All living simplices. O(n).
template <class Real>
[[nodiscard]] SimplexSet all_simplices(const Complex<Real>& complex);

} // namespace dsc
