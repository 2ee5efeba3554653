// SPDX-License-Identifier: MIT
// Point location: which simplex holds a point.
#pragma once

#include "dsc/complex/complex.h"

namespace dsc {

/// What of a complex holds a point.
struct Location {
    enum class Kind : std::uint8_t { outside, triangle, edge, vertex };

    Kind kind = Kind::outside; ///< of the simplex that has the point in its interior
    Triangle triangle;         ///< the point is in it or on its boundary; invalid where outside
    Edge edge;                 ///< valid where kind is `edge`
    Vertex vertex;             ///< valid where kind is `vertex`

    friend bool operator==(const Location&, const Location&) = default;
};

/// The simplex that holds the point; exact. The walk begins at `hint`, or at the first living
/// triangle where `hint` does not live; it matters for the time, and of the triangles at an edge or
/// vertex for the one that is named. Throws InputError where a coordinate is not finite.
///
/// O(triangles on the way) where the walk arrives: O(sqrt(n)) in an even mesh, O(1) with a hint
/// near by. It may fail to arrive where the domain is not convex, or end at the domain boundary
/// because the point is outside: then all triangles are looked at, O(n). Thread-safe while nobody
/// writes.
template <class Real>
[[nodiscard]] Location locate(const Complex<Real>& complex, const Point<Real>& point,
                              Triangle hint = {});

} // namespace dsc
