// SPDX-License-Identifier: MIT
// Interpolators [8.9]: where a new interface vertex goes. Linear insertion is the thesis's, and the
// source of its jagged edges; the cubic through four neighbours by chord length keeps the curve.
#pragma once

#include "dsc/base/types.h"

#include <functional>
#include <string_view>

namespace dsc {

enum class Insertion : std::uint8_t {
    linear, ///< the midpoint of the edge
    cubic,  ///< 4-point Lagrange by chord length; one-sided or linear at corners
};

[[nodiscard]] constexpr std::string_view to_string(Insertion insertion) {
    return insertion == Insertion::linear ? "linear" : "cubic";
}

/// Four consecutive points of the interface; the new vertex goes between p1 and p2. `has_first` and
/// `has_last` are false where the curve ends, branches or has a corner.
template <class Real>
struct CurveNeighbours {
    Point<Real> p0, p1, p2, p3;
    bool has_first = false;
    bool has_last = false;
};

/// An application's own interpolator for positions (thesis 9.2: a circle that stays round).
template <class Real>
using InsertionFunction = std::function<Point<Real>(const CurveNeighbours<Real>&)>;

/// The point in the middle (by chord length) of p1 and p2 on the Lagrange polynomial through the
/// neighbours that there are. O(1).
template <class Real>
Point<Real> insertion_point(Insertion insertion, const CurveNeighbours<Real>& neighbours);

} // namespace dsc
