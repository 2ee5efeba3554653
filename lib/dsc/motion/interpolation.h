// SPDX-License-Identifier: MIT
// Interpolators (thesis, section 8.9): the curve between interface vertices, and the position of a
// new vertex. The thesis inserts linearly, which makes interfaces jagged; the cubic through four
// neighbours by chord length preserves the curve.
#pragma once

#include "dsc/base/names.h"
#include "dsc/base/types.h"

#include <array>
#include <functional>
#include <string_view>

namespace dsc {

/// The position of a new vertex on an interface edge.
enum class Insertion : std::uint8_t {
    linear, ///< the midpoint of the edge
    cubic,  ///< 4-point Lagrange by chord length; one-sided or linear at features
};

inline constexpr std::array insertion_names{
    Named{Insertion::linear, "linear"},
    Named{Insertion::cubic, "cubic"},
};

[[nodiscard]] constexpr std::string_view to_string(Insertion insertion) {
    return name_in(insertion_names, insertion);
}

/// The shape of the interface between its vertices.
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

/// Four consecutive points of the interface, for a point between p1 and p2. `has_first` and
/// `has_last` are false where the curve ends, branches or has a feature.
template <class Real>
struct CurveNeighbours {
    Point<Real> p0 = Point<Real>::Zero(); ///< before p1
    Point<Real> p1 = Point<Real>::Zero(); ///< one end of the edge
    Point<Real> p2 = Point<Real>::Zero(); ///< the other end
    Point<Real> p3 = Point<Real>::Zero(); ///< after p2
    bool has_first = false;               ///< whether p0 is known
    bool has_last = false;                ///< whether p3 is known
};

/// An application's own interpolator for positions (thesis, section 9.2: a circle that stays
/// round).
template <class Real>
using InsertionFunction = std::function<Point<Real>(const CurveNeighbours<Real>&)>;

/// The point at `share` (0 to 1, or a little beyond) of the chord from p1 to p2, on the Lagrange
/// polynomial by chord length through the known neighbours. This piecewise cubic differs from a
/// smooth curve by O(length^4). O(1).
template <class Real>
Point<Real> curve_point(const CurveNeighbours<Real>& neighbours, Real share);

/// A value of the same point, from those at p0 to p3 and by the same weights. O(1).
template <class Real>
Real curve_value(const CurveNeighbours<Real>& neighbours, const std::array<Real, 4>& values,
                 Real share);

/// The position of a new vertex between p1 and p2. O(1).
template <class Real>
Point<Real> insertion_point(Insertion insertion, const CurveNeighbours<Real>& neighbours);

} // namespace dsc
