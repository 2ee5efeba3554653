// SPDX-License-Identifier: MIT
// The Delaunay condition of an edge of a complex; see geometry/triangle.h.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/geometry/triangle.h"

namespace dsc {

/// Whether the edge opposite to `corner`, which must have two triangles, is Delaunay.
template <class Real>
bool is_delaunay(const Complex<Real>& complex, Corner corner) {
    return is_delaunay<Real>(complex.position(Vertex{complex.vertex(corner)}),
                             complex.position(Vertex{complex.vertex(next(corner))}),
                             complex.position(Vertex{complex.vertex(complex.twin(corner))}),
                             complex.position(Vertex{complex.vertex(prev(corner))}));
}

} // namespace dsc
