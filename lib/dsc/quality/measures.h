// SPDX-License-Identifier: MIT
// Quality measures (thesis, section 4.3) of the simplices of a complex. geometry/triangle.h has
// them for points, with their ranges.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/geometry/distance.h"
#include "dsc/geometry/triangle.h"

namespace dsc {

/// Equation 2: the length of an edge.
template <class Real>
[[nodiscard]] Real length(const Complex<Real>& complex, Edge e);
/// The square of equation 2, without a square root.
template <class Real>
[[nodiscard]] Real squared_length(const Complex<Real>& complex, Edge e);
/// Equation 3: the signed area of a triangle.
template <class Real>
[[nodiscard]] Real area(const Complex<Real>& complex, Triangle t);
/// Equation 4: the quality of a triangle.
template <class Real>
[[nodiscard]] Real quality(const Complex<Real>& complex, Triangle t);
/// The smallest angle, in degrees, 0 to 60.
template <class Real>
[[nodiscard]] Real min_angle_deg(const Complex<Real>& complex, Triangle t);

/// Whether the edge opposite to `corner`, which must have two triangles, is Delaunay.
template <class Real>
bool is_delaunay(const Complex<Real>& complex, Corner corner) {
    return is_delaunay<Real>(complex.position(Vertex{complex.vertex(corner)}),
                             complex.position(Vertex{complex.vertex(next(corner))}),
                             complex.position(Vertex{complex.vertex(complex.twin(corner))}),
                             complex.position(Vertex{complex.vertex(prev(corner))}));
}

} // namespace dsc
