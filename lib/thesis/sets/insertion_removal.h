// SPDX-License-Identifier: MIT
// Insertion and removal of single simplices, in any order (thesis, section 4.1).
//
// In between, a vertex may have more than one fan of triangles: the complex is then not a manifold
// (thesis, section 3.2), `validate` reports this, and any function that rotates about that vertex
// (star, link, is_boundary...) sees only one of the fans until the gaps are filled. The operations
// of lib/dsc/operations and of this module never pass through such states.
#pragma once

#include "thesis/sets/simplex_set.h"

#include "dsc/complex/complex.h"

namespace dsc {

/// Inserts a vertex without triangles. Attributes take their initial values. O(1) amortised. Throws
/// InputError if a coordinate is not finite or no id is free.
template <class Real>
Vertex insert_vertex(Complex<Real>& complex, const Point<Real>& p);

/// Inserts a triangle between three living vertices, in either orientation, together with those of
/// its edges that do not exist yet (thesis, section 8.2), and links it with its neighbours.
/// Attributes take their initial values; an edge that exists keeps its own. O(n), because the
/// neighbours are searched for among all triangles: to build a whole mesh use `make_complex`.
/// Throws InputError if a vertex is dead or named twice, the area is zero, the phase is reserved,
/// an edge has two triangles already, the triangle would overlap the one already at its edge, or no
/// id is free; the complex is then unchanged.
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

} // namespace dsc
