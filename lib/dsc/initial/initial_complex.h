// SPDX-License-Identifier: MIT
// The complex that a scene starts from (thesis, section 5.6 and chapter 9): a rectangle and any
// number of simple polygons, each with its phase, triangulated at a target edge length. A lattice
// of near-equilateral triangles is laid over the rectangle; only the part near an outline is
// searched, changed or improved.
//
// The result is a constrained Delaunay triangulation (up to `delaunay_slack`) whose interface
// consists of the outlines and nothing else.
#pragma once

#include "dsc/complex/complex.h"

#include <span>
#include <vector>

namespace dsc {

/// One simple polygon and the phase inside it.
struct Shape {
    std::vector<Point<double>> outline; ///< either orientation; the first point is not repeated
    Phase phase = 1;                    ///< differs from the phase around the shape
};

/// A rectangle with sides parallel to the axes.
struct Rectangle {
    Point<double> low{0.0, 0.0};
    Point<double> high{1.0, 1.0};
};

struct InitialOptions {
    double edge_length = 0.05; ///< the target, in units of the coordinates
    int improve_rounds = 12;   ///< at most so many rounds of improvement near the interface
    bool renumber = true;      ///< order ids along a space-filling curve
};

/// Triangulates `domain` with the outlines of `shapes` as its interface.
///
/// The innermost shape that contains a triangle gives its phase; outside of all it is
/// `exterior_phase`. A shape of that phase is a hole in the shape around it. Each outline edge
/// longer than `edge_length` is cut into ceil(length / edge_length) equal pieces; all vertices of
/// the outline stay, bit for bit (for float: as rounded).
///
/// Time and memory: O(1) per triangle, plus O(n log n) for the n vertices of the cut outlines. The
/// same input gives the same bits.
///
/// \throw InputError where a coordinate or the edge length makes no sense, an outline is degenerate
/// or crosses or touches itself, another one or the side of the domain, a shape has the phase
/// around it, or the complex would be absurdly large.
template <class Real>
Complex<Real> initial_complex(const Rectangle& domain, std::span<const Shape> shapes,
                              const InitialOptions& options = {});

extern template Complex<double> initial_complex(const Rectangle&, std::span<const Shape>,
                                                const InitialOptions&);
extern template Complex<float> initial_complex(const Rectangle&, std::span<const Shape>,
                                               const InitialOptions&);

} // namespace dsc
