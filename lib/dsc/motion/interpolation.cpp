// SPDX-License-Identifier: MIT
#include "dsc/motion/interpolation.h"

#include "dsc/geometry/points.h"

#include <algorithm>
#include <array>
#include <span>

namespace dsc {

namespace {

// The Lagrange polynomial through values at the known neighbours. Its parameter is the accumulated
// chord length, zero at p1.
template <class Real>
Point<Real> on_polynomial(const CurveNeighbours<Real>& neighbours,
                          const std::array<Point<Real>, 4>& values, Real share,
                          const Point<Real>& on_chord) {
    const Real chord = (neighbours.p2 - neighbours.p1).norm();
    std::array<Real, 4> knots{};
    std::array<Point<Real>, 4> points;
    std::size_t count = 0;
    if (neighbours.has_first) {
        knots[count] = -(neighbours.p1 - neighbours.p0).norm();
        points[count++] = values[0];
    }
    knots[count] = 0;
    points[count++] = values[1];
    knots[count] = chord;
    points[count++] = values[2];
    if (neighbours.has_last) {
        knots[count] = chord + (neighbours.p3 - neighbours.p2).norm();
        points[count++] = values[3];
    }
    return lagrange<Real>(std::span<const Point<Real>>(points.data(), count),
                          std::span<const Real>(knots.data(), count), share * chord, on_chord);
}

} // namespace

template <class Real>
Point<Real> curve_point(const CurveNeighbours<Real>& neighbours, Real share) {
    const Point<Real> on_chord = neighbours.p1 + share * (neighbours.p2 - neighbours.p1);
    if (!neighbours.has_first && !neighbours.has_last) {
        return on_chord;
    }
    return on_polynomial<Real>(
        neighbours, {neighbours.p0, neighbours.p1, neighbours.p2, neighbours.p3}, share, on_chord);
}

template <class Real>
Real curve_value(const CurveNeighbours<Real>& neighbours, const std::array<Real, 4>& values,
                 Real share) {
    std::array<Point<Real>, 4> points;
    std::ranges::transform(values, points.begin(),
                           [](Real value) { return Point<Real>(value, Real(0)); });
    const Point<Real> on_chord(values[1] + share * (values[2] - values[1]), Real(0));
    return on_polynomial<Real>(neighbours, points, share, on_chord).x();
}

template <class Real>
Point<Real> insertion_point(Insertion insertion, const CurveNeighbours<Real>& neighbours) {
    switch (insertion) {
    case Insertion::linear: break;
    case Insertion::cubic: return curve_point(neighbours, Real(0.5));
    }
    return midpoint<Real>(neighbours.p1, neighbours.p2);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Point<Real> curve_point(const CurveNeighbours<Real>&, Real);                          \
    template Real curve_value(const CurveNeighbours<Real>&, const std::array<Real, 4>&, Real);     \
    template Point<Real> insertion_point(Insertion, const CurveNeighbours<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
