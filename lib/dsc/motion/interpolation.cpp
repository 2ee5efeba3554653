// SPDX-License-Identifier: MIT
#include "dsc/motion/interpolation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dsc {

template <class Real>
Point<Real> curve_point(const CurveNeighbours<Real>& neighbours, Real share) {
    const Point<Real> on_chord = neighbours.p1 + share * (neighbours.p2 - neighbours.p1);
    if (!neighbours.has_first && !neighbours.has_last) {
        return on_chord;
    }
    // Parameters: accumulated chord length, zero at p1.
    const Real chord = (neighbours.p2 - neighbours.p1).norm();
    std::array<Real, 4> knots{};
    std::array<Point<Real>, 4> points;
    std::size_t count = 0;
    if (neighbours.has_first) {
        knots[count] = -(neighbours.p1 - neighbours.p0).norm();
        points[count++] = neighbours.p0;
    }
    knots[count] = 0;
    points[count++] = neighbours.p1;
    knots[count] = chord;
    points[count++] = neighbours.p2;
    if (neighbours.has_last) {
        knots[count] = chord + (neighbours.p3 - neighbours.p2).norm();
        points[count++] = neighbours.p3;
    }
    const Real at = share * chord;
    // Relative to the chord, so that an offset of the coordinates costs no digits.
    Point<Real> result = Point<Real>::Zero();
    for (std::size_t i = 0; i < count; ++i) {
        Real weight = 1;
        for (std::size_t j = 0; j < count; ++j) {
            if (j != i) {
                weight *= (at - knots[j]) / (knots[i] - knots[j]);
            }
        }
        result += weight * (points[i] - on_chord);
    }
    return on_chord + result;
}

template <class Real>
Real curvature(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c) {
    const Point<Real> in = b - a;
    const Point<Real> out = c - b;
    const Real lengths = in.norm() * out.norm() * (c - a).norm();
    return lengths > 0 ? 2 * (in.x() * out.y() - in.y() * out.x()) / lengths : Real(0);
}

namespace {

/// In the middle of the arc of this curvature from p1 to p2.
template <class Real>
Point<Real> arc_point(const CurveNeighbours<Real>& n) {
    const Point<Real> chord = n.p2 - n.p1;
    Real bend = 0;
    int known = 0;
    if (n.has_first) {
        bend += curvature<Real>(n.p0, n.p1, n.p2);
        ++known;
    }
    if (n.has_last) {
        bend += curvature<Real>(n.p1, n.p2, n.p3);
        ++known;
    }
    const Point<Real> middle = Real(0.5) * (n.p1 + n.p2);
    if (known == 0) {
        return middle;
    }
    bend /= static_cast<Real>(known);
    // The height of the arc over half its chord. More than a half circle there cannot be.
    const Real sine = std::clamp(Real(0.5) * bend * chord.norm(), Real(-1), Real(1));
    const Real height = Real(0.5) * sine / (1 + std::sqrt(1 - sine * sine));
    return middle + height * Point<Real>(chord.y(), -chord.x());
}

} // namespace

template <class Real>
Point<Real> insertion_point(Insertion insertion, const CurveNeighbours<Real>& neighbours) {
    switch (insertion) {
    case Insertion::linear: break;
    case Insertion::cubic: return curve_point(neighbours, Real(0.5));
    case Insertion::arc: return arc_point(neighbours);
    }
    return Real(0.5) * (neighbours.p1 + neighbours.p2);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Point<Real> curve_point(const CurveNeighbours<Real>&, Real);                          \
    template Point<Real> insertion_point(Insertion, const CurveNeighbours<Real>&);                 \
    template Real curvature(const Point<Real>&, const Point<Real>&, const Point<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
