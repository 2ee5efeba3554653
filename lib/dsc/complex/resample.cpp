// SPDX-License-Identifier: MIT
#include "dsc/complex/circulate.h"
#include "dsc/complex/rewire.h"
#include "dsc/geometry/points.h"

#include <algorithm>
#include <limits>

namespace dsc {

template <class Real>
void resample_fields(Complex<Real>& complex, Vertex v, const Point<Real>& place,
                     bool with_interface) {
    if (!complex.attributes.has_fields()) {
        return;
    }
    const Point<Real> centre = complex.position(v);
    const Point<Real> way = place - centre;
    Vertex best_a;
    Vertex best_b;
    Real share_a = 0;
    Real share_b = 0;
    Real best = -std::numeric_limits<Real>::infinity();
    for_each_corner(complex, v, [&](Corner c) {
        const Vertex a{complex.vertex(next(c))};
        const Vertex b{complex.vertex(prev(c))};
        const Point<Real> to_a = complex.position(a) - centre;
        const Point<Real> to_b = complex.position(b) - centre;
        const Real area = cross<Real>(to_a, to_b);
        const Real of_a = cross<Real>(way, to_b) / area;
        const Real of_b = cross<Real>(to_a, way) / area;
        // Both weights are non-negative in the triangle into which the vertex moves. They may be so
        // in a neighbour too, which the rounding of a new vertex has inverted: its area is
        // negative.
        if (const Real smallest = std::min(of_a, of_b); area > 0 && smallest > best) {
            best = smallest;
            best_a = a;
            best_b = b;
            share_a = of_a;
            share_b = of_b;
        }
    });
    if (!best_a.is_valid()) {
        return; // no triangle has a positive area
    }
    share_b = std::clamp(share_b, Real(0), Real(1));
    share_a = std::clamp(share_a, Real(0), 1 - share_b);
    // Two blends combine three values: first with a, then with b; a's fraction makes up for the
    // blend with b.
    if (share_b < 1) {
        complex.attributes.move_fields(
            v.id, best_a.id, static_cast<double>(share_a / (1 - share_b)), with_interface);
    }
    complex.attributes.move_fields(v.id, best_b.id, static_cast<double>(share_b), with_interface);
}

template void resample_fields(Complex<double>&, Vertex, const Point<double>&, bool);
template void resample_fields(Complex<float>&, Vertex, const Point<float>&, bool);

} // namespace dsc
