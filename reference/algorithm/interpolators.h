// SPDX-License-Identifier: MIT
// The positions of new interface vertices (thesis, sections 8.9 and 9.2).
#pragma once

#include "dsc/base/types.h"

#include <functional>

namespace dsc::reference {

/// The position of a new vertex on the interface edge from p1 to p2; p0 and p3 are the vertices
/// before and after them along the interface.
using InterfacePoint =
    std::function<Point<double>(const Point<double>& p0, const Point<double>& p1,
                                const Point<double>& p2, const Point<double>& p3)>;

/// The midpoint of the edge, as algorithm 7.6 prints it.
Point<double> linear_point(const Point<double>& p0, const Point<double>& p1,
                           const Point<double>& p2, const Point<double>& p3);

/// The cubic through the four points, parametrised by chord length, half way between p1 and p2. The
/// midpoint if two points coincide, or if the curve turns by more than 40 degrees at p1 or p2: that
/// is a feature, where a cubic would overshoot.
Point<double> cubic_point(const Point<double>& p0, const Point<double>& p1, const Point<double>& p2,
                          const Point<double>& p3);

/// The same without the exception for features: the midpoint only if two points coincide.
Point<double> lagrange_point(const Point<double>& p0, const Point<double>& p1,
                             const Point<double>& p2, const Point<double>& p3);

/// A point of the same cubic: `fraction` of the chord's length after p1, 0 to 1.
Point<double> lagrange_point_at(const Point<double>& p0, const Point<double>& p1,
                                const Point<double>& p2, const Point<double>& p3, double fraction);

} // namespace dsc::reference
