// SPDX-License-Identifier: MIT
// Constrained Delaunay by flips (C. L. Lawson, "Software for C1 surface interpolation", 1977). An
// edge is flipped only where the in-circle test is certain: each flip lowers the lifted surface, so
// the flips come to an end without a slack.
#pragma once

#include "dsc/complex/circulate.h"
#include "dsc/geometry/predicates.h"
#include "dsc/initial/zone.h"
#include "dsc/operations/edge_flip.h"

#include <cmath>
#include <vector>

namespace dsc::initial {

/// Whether d certainly lies inside the circle through the counter-clockwise (a, b, c). Within the
/// rounding error of doubles, which is far below `delaunay_slack`, the answer is no: points of an
/// outline are often cocircular, and exact zeros are dear.
inline bool certainly_in_circle(const Point<double>& a, const Point<double>& b,
                                const Point<double>& c, const Point<double>& d) {
    // (10 + 96 eps) eps with eps = 2^-53, relative to the permanent (Shewchuk 1997).
    constexpr double bound = 1.1102230246251577e-15;
    const Point<double> p = a - d;
    const Point<double> q = b - d;
    const Point<double> r = c - d;
    const double qr = q.x() * r.y();
    const double rq = q.y() * r.x();
    const double rp = r.x() * p.y();
    const double pr = r.y() * p.x();
    const double pq = p.x() * q.y();
    const double qp = p.y() * q.x();
    const double pp = p.squaredNorm();
    const double qq = q.squaredNorm();
    const double rr = r.squaredNorm();
    const double det = pp * (qr - rq) + qq * (rp - pr) + rr * (pq - qp);
    const double permanent = pp * (std::abs(qr) + std::abs(rq)) +
                             qq * (std::abs(rp) + std::abs(pr)) +
                             rr * (std::abs(pq) + std::abs(qp));
    if (permanent > underflow_guard && std::isfinite(permanent)) {
        return det > bound * permanent;
    }
    return in_circle<double>(a, b, c, d) > 0;
}

/// Whether the edge opposite to `corner` is not constrained and certainly not Delaunay.
template <class Real>
bool wants_flip(const Complex<Real>& complex, Corner corner) {
    const Corner other = complex.twin(corner);
    if (complex.phase_at(corner) != complex.phase_at(other)) {
        return false; // interface, or the domain boundary
    }
    const auto at = [&](Corner c) -> Point<double> {
        return complex.position(Vertex{complex.vertex(c)}).template cast<double>();
    };
    return certainly_in_circle(at(corner), at(next(corner)), at(prev(corner)), at(other));
}

/// Flips until all edges opposite to the corners on `stack`, and those that the flips touch, are
/// constrained Delaunay; empties the stack. Vertices whose stars change are unsettled.
template <class Real>
void legalise(Complex<Real>& complex, std::vector<Corner>& stack) {
    const Submesh whole = whole_submesh(complex);
    while (!stack.empty()) {
        const Corner corner = stack.back();
        stack.pop_back();
        if (!complex.is_alive(Triangle{triangle_of(corner)}) || !wants_flip(complex, corner)) {
            continue;
        }
        const Corner other = complex.twin(corner);
        if (edge_flip(complex, whole, corner) != Verdict::legal) {
            continue;
        }
        for (const Corner c : {corner, other}) {
            stack.push_back(c);
            stack.push_back(prev(c));
            complex.vertices[complex.vertex(c)].slot = unsettled;
            complex.vertices[complex.vertex(next(c))].slot = unsettled;
        }
    }
}

/// Restores the Delaunay property after the star of a vertex has changed.
template <class Real>
void legalise_star(Complex<Real>& complex, std::uint32_t vertex, std::vector<Corner>& stack) {
    for_each_corner(complex, Vertex{vertex}, [&](Corner c) {
        stack.push_back(c);
        stack.push_back(next(c));
        complex.vertices[complex.vertex(c)].slot = unsettled;
        complex.vertices[complex.vertex(next(c))].slot = unsettled;
        complex.vertices[complex.vertex(prev(c))].slot = unsettled;
    });
    legalise(complex, stack);
}

} // namespace dsc::initial
