// SPDX-License-Identifier: MIT
// Point location: finds the simplex that contains a point.
#pragma once

#include "dsc/complex/complex.h"

namespace dsc {

/// The part of a complex that contains a point.
struct Location {
    /// Where a point may lie.
    enum class Kind : std::uint8_t { outside, triangle, edge, vertex };

    Kind kind = Kind::outside; ///< dimension of the simplex that has the point in its interior
    Triangle triangle; ///< a triangle with the point inside or on its boundary; invalid if outside
    Edge edge;         ///< valid where kind is `edge`
    Vertex vertex;     ///< valid where kind is `vertex`

    friend bool operator==(const Location&, const Location&) = default;
};

/// The simplex that contains the point; exact. The walk begins at `hint`, or at the first living
/// triangle if `hint` is not alive. The start affects the running time, and, for a point on an edge
/// or vertex, which of the triangles there is named. Throws InputError if a coordinate is not
/// finite.
///
/// O(triangles on the way) if the walk arrives: O(sqrt(n)) in a uniform mesh, O(1) with a hint
/// nearby. It stops at the domain boundary if the point is outside, but also where the domain is
/// not convex: then all triangles are tested, O(n). Thread-safe while nobody writes.
template <class Real>
[[nodiscard]] Location locate(const Complex<Real>& complex, const Point<Real>& point,
                              Triangle hint = {});

} // namespace dsc
