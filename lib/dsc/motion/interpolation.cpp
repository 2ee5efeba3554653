// SPDX-License-Identifier: MIT
#include "dsc/motion/interpolation.h"

#include <array>

namespace dsc {

template <class Real>
Point<Real> insertion_point(Insertion insertion, const CurveNeighbours<Real>& neighbours) {
    const Point<Real> middle = Real(0.5) * (neighbours.p1 + neighbours.p2);
    if (insertion == Insertion::linear || (!neighbours.has_first && !neighbours.has_last)) {
        return middle;
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
    const Real at = Real(0.5) * chord;
    // Relative to the middle, so that an offset of the coordinates costs no digits.
    Point<Real> result = Point<Real>::Zero();
    for (std::size_t i = 0; i < count; ++i) {
        Real weight = 1;
        for (std::size_t j = 0; j < count; ++j) {
            if (j != i) {
                weight *= (at - knots[j]) / (knots[i] - knots[j]);
            }
        }
        result += weight * (points[i] - middle);
    }
    return middle + result;
}

template Point<double> insertion_point(Insertion, const CurveNeighbours<double>&);
template Point<float> insertion_point(Insertion, const CurveNeighbours<float>&);

} // namespace dsc
