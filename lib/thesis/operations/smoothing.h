// SPDX-License-Identifier: MIT
// Smoothing (thesis, section 5.5): vertices move so that the triangles around them improve; none
// are added or removed. The quality is that of equation 4 of the thesis, 2/sqrt(3) sin(smallest
// angle).
#pragma once

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/submesh.h"

namespace dsc {

/// How an interface vertex slides.
struct InterfaceSmoothingOptions {
    /// Degrees. If the interface turns by more, the vertex is a feature: it stays, and no curve is
    /// interpolated through it.
    double feature_degrees = 30;
    /// Share of the distance to the point of equal lengths, measured along the curve; 0 to 1.
    double step = 1;
};

namespace detail {
template <class Real>
Verdict laplacian_smoothing(const Submesh<Real>& submesh, Vertex vertex);
template <class Real>
Verdict interface_smoothing(const Submesh<Real>& submesh, Vertex vertex,
                            const InterfaceSmoothingOptions& options);
} // namespace detail

/// Moves the vertex to the mean of its neighbours (equation 6) if no star triangle inverts and the
/// smallest quality of the star rises. A vertex of the domain boundary or of the interface stays.
/// O(degree), no allocation. The signs are exact. Thread-safe for disjoint submeshes.
Verdict laplacian_smoothing(Editable auto&& where, Vertex vertex) {
    return detail::laplacian_smoothing(Submesh(where), vertex);
}

/// Slides a vertex with exactly two interface edges along the interface, towards the point where
/// the two are equally long. It moves on the Lagrange polynomial, parameterised by chord length,
/// through the vertex, its two interface neighbours and the one beyond the farther of them (three
/// points where the curve ends, branches, has a feature or leaves the submesh there), so that a
/// smooth shape changes by O(h^4) (O(h^3)). Accepted only if no star triangle inverts and the
/// smallest quality of the star rises. Answers on_interface at junctions, at features and away from
/// the interface. O(degree), no allocation. Thread-safe for disjoint submeshes. Throws InputError
/// if an option is out of range.
Verdict interface_smoothing(Editable auto&& where, Vertex vertex,
                            const InterfaceSmoothingOptions& options = {}) {
    return detail::interface_smoothing(Submesh(where), vertex, options);
}

} // namespace dsc
