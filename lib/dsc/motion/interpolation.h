// SPDX-License-Identifier: MIT
// Interpolators [8.9]: the curve between interface vertices, and where a new one goes. Linear
// insertion is the thesis's, and the source of its jagged edges; the cubic through four neighbours
// by chord length keeps the curve.
#pragma once

#include "dsc/base/enum_table.h"
#include "dsc/base/types.h"

#include <functional>
#include <string_view>

namespace dsc {

enum class Insertion : std::uint8_t {
    linear, ///< the midpoint of the edge
    cubic,  ///< 4-point Lagrange by chord length; one-sided or linear at corners
    arc,    ///< on the circle of the mean curvature at the two ends: circles stay circles
};

inline constexpr std::array insertion_names{
    Named{Insertion::linear, "linear"},
    Named{Insertion::cubic, "cubic"},
    Named{Insertion::arc, "arc"},
};

[[nodiscard]] constexpr std::string_view to_string(Insertion insertion) {
    return name_in(insertion_names, insertion);
}

/// What the interface is between its vertices.
enum class Reading : std::uint8_t {
    chords, ///< the edges themselves: second order in their length
    cubic,  ///< the 4-point Lagrange cubic by chord length: fourth order
};

inline constexpr std::array reading_names{
    Named{Reading::chords, "chords"},
    Named{Reading::cubic, "cubic"},
};

[[nodiscard]] constexpr std::string_view to_string(Reading reading) {
    return name_in(reading_names, reading);
}

/// Four consecutive points of the interface; what is asked for lies between p1 and p2. `has_first`
/// and `has_last` are false where the curve ends, branches or has a corner.
template <class Real>
struct CurveNeighbours {
    Point<Real> p0 = Point<Real>::Zero();
    Point<Real> p1 = Point<Real>::Zero();
    Point<Real> p2 = Point<Real>::Zero();
    Point<Real> p3 = Point<Real>::Zero();
    bool has_first = false;
    bool has_last = false;
};

/// An application's own interpolator for positions (thesis 9.2: a circle that stays round).
template <class Real>
using InsertionFunction = std::function<Point<Real>(const CurveNeighbours<Real>&)>;

/// The point at `share` (0 to 1) of the chord from p1 to p2, on the Lagrange polynomial by chord
/// length through the neighbours that there are: the piecewise cubic as which the interface is
/// read. Off by O(length^4) from a smooth curve. O(1).
template <class Real>
Point<Real> curve_point(const CurveNeighbours<Real>& neighbours, Real share);

/// Where a new vertex in the middle of p1 and p2 goes. O(1).
template <class Real>
Point<Real> insertion_point(Insertion insertion, const CurveNeighbours<Real>& neighbours);

/// Curvature of the circle through three points, positive where it turns left; 0 where two of them
/// coincide. In 1 / length. O(1).
template <class Real>
Real curvature(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c);

} // namespace dsc
