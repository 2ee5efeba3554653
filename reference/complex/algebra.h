// SPDX-License-Identifier: MIT
// The simplex relations and operations of the thesis, section 3.1: boundary, boundary*, star,
// closure, link, skeleton and filter. The faces of a simplex of K are in K, so only `star` needs K
// itself.
#pragma once

#include "reference/complex/complex.h"
#include "reference/complex/simplex.h"

namespace dsc::reference {

/// The faces of exactly one dimension less (figure 3.3). A vertex has none.
SimplexSet boundary(Vertex v);
SimplexSet boundary(const EdgeKey& e);
SimplexSet boundary(const TriangleKey& t);

/// boundary*: the faces of any lower dimension (figure 3.4).
SimplexSet full_boundary(Vertex v);
SimplexSet full_boundary(const EdgeKey& e);
SimplexSet full_boundary(const TriangleKey& t);

/// The simplex and its full boundary (figure 3.6).
SimplexSet closure(Vertex v);
SimplexSet closure(const EdgeKey& e);
SimplexSet closure(const TriangleKey& t);
SimplexSet closure(const SimplexSet& set);

/// The simplices of K that have this one as a face, including itself (figure 3.5). O(their number).
SimplexSet star(const Complex& K, Vertex v);
SimplexSet star(const Complex& K, const EdgeKey& e);
SimplexSet star(const Complex& K, const TriangleKey& t);
SimplexSet star(const Complex& K, const SimplexSet& set);

/// closure(star(s)) \ star(closure(s)) (figure 3.7).
SimplexSet link(const Complex& K, Vertex v);
SimplexSet link(const Complex& K, const EdgeKey& e);
SimplexSet link(const Complex& K, const TriangleKey& t);
/// The union of the links: op(Sigma) of section 3.1.
SimplexSet link(const Complex& K, const SimplexSet& set);

/// The simplices of dimension k or lower (figure 3.8).
SimplexSet skeleton(int k, const SimplexSet& set);

/// The simplices of dimension k exactly (figure 3.9).
SimplexSet filter(int k, const SimplexSet& set);

} // namespace dsc::reference
