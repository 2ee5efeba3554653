// SPDX-License-Identifier: MIT
// Quality measures [thesis 4.3], on points and on simplices. Those of triangles are after
// J. R. Shewchuk, "What is a good linear finite element?" (2002), scaled to 1 for the equilateral
// triangle and signed: an inverted triangle has a negative value, a degenerate one 0. None of them
// needs trigonometry, but for the angle itself, and none multiplies more than two lengths, so that
// they neither under- nor overflow where the area does not.
#pragma once

#include "dsc/complex/complex.h"

#include <algorithm>
#include <cmath>

namespace dsc {

// --- on points
// ------------------------------------------------------------------------------------

/// The distance between two points; eq. 1 for a vertex and its destination, eq. 2 for an edge.
template <class Real>
[[nodiscard]] Real distance(const Point<Real>& a, const Point<Real>& b) {
    const Real x = b.x() - a.x();
    const Real y = b.y() - a.y();
    return std::sqrt(x * x + y * y);
}

/// The square of it.
template <class Real>
[[nodiscard]] Real squared_distance(const Point<Real>& a, const Point<Real>& b) {
    const Real x = b.x() - a.x();
    const Real y = b.y() - a.y();
    return x * x + y * y;
}

/// The signed area, eq. 3: positive for a counter-clockwise triangle. Its sign may be wrong where
/// rounding decides: ask `orientation` for that.
template <class Real>
[[nodiscard]] Real area(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c) {
    return ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x())) / 2;
}

/// Eq. 4 from the signed area and the squared edge lengths: 2 / sqrt 3 sin(smallest angle). The
/// smallest angle lies between the two longest edges, so that 2 area = longest * middle * sine.
template <class Real>
[[nodiscard]] Real quality_from_squares(Real signed_area, Real aa, Real bb, Real cc) {
    const Real longest = std::max({aa, bb, cc});
    const Real middle = std::max(std::min(aa, bb), std::min(std::max(aa, bb), cc));
    if (!(middle > 0)) {
        return 0;
    }
    constexpr Real four_over_sqrt3 = static_cast<Real>(2.3094010767585030580);
    return four_over_sqrt3 * (signed_area / longest) * std::sqrt(longest / middle);
}

/// Eq. 4: 2 / sqrt 3 sin(smallest angle), from 0 (degenerate) to 1 (equilateral).
template <class Real>
[[nodiscard]] Real quality(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c) {
    return quality_from_squares(area(a, b, c), squared_distance(b, c), squared_distance(c, a),
                                squared_distance(a, b));
}

/// The smallest angle in degrees, from 0 to 60. Not signed.
template <class Real>
[[nodiscard]] Real min_angle_deg(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c) {
    const Real aa = squared_distance(b, c);
    const Real bb = squared_distance(c, a);
    const Real cc = squared_distance(a, b);
    // It lies opposite to the shortest edge; the law of cosines for the corner there.
    const Real shortest = std::min({aa, bb, cc});
    const Real dot = ((aa - shortest) + (bb - shortest) + (cc - shortest) + shortest) / 2;
    const Real cross = 2 * std::abs(area(a, b, c));
    if (!(cross > 0)) {
        return 0;
    }
    constexpr Real degrees = static_cast<Real>(57.295779513082320877);
    return degrees * std::atan2(cross, dot);
}

/// The mean ratio, 4 sqrt 3 area / (sum of the squared edge lengths): smooth, from 0 to 1.
template <class Real>
[[nodiscard]] Real mean_ratio(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c) {
    const Real sum = squared_distance(b, c) + squared_distance(c, a) + squared_distance(a, b);
    constexpr Real four_sqrt3 = static_cast<Real>(6.9282032302755091741);
    return sum > 0 ? four_sqrt3 * (area(a, b, c) / sum) : Real{0};
}

/// The aspect ratio: shortest altitude over longest edge, times 2 / sqrt 3; from 0 to 1.
template <class Real>
[[nodiscard]] Real aspect_ratio(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c) {
    const Real longest =
        std::max({squared_distance(b, c), squared_distance(c, a), squared_distance(a, b)});
    constexpr Real four_over_sqrt3 = static_cast<Real>(2.3094010767585030580);
    return longest > 0 ? four_over_sqrt3 * (area(a, b, c) / longest) : Real{0};
}

/// The radius ratio: twice the inscribed over the circumscribed circle's radius; from 0 to 1.
template <class Real>
[[nodiscard]] Real radius_ratio(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c) {
    const Real la = distance(b, c);
    const Real lb = distance(c, a);
    const Real lc = distance(a, b);
    const Real signed_area = area(a, b, c);
    if (!(std::min({la, lb, lc}) > 0)) {
        return 0;
    }
    // 16 area^2 / (la lb lc (la + lb + lc)), two lengths to each area.
    return 16 * (signed_area / (la * lb)) * (std::abs(signed_area) / (lc * (la + lb + lc)));
}

// --- on simplices
// ---------------------------------------------------------------------------------

/// Eq. 1: how far a vertex is from where it shall be.
template <class Real>
[[nodiscard]] Real vertex_distance(const Complex<Real>& complex, Vertex v,
                                   const Point<Real>& destination);
/// Eq. 2.
template <class Real>
[[nodiscard]] Real length(const Complex<Real>& complex, Edge e);
template <class Real>
[[nodiscard]] Real squared_length(const Complex<Real>& complex, Edge e);
/// Eq. 3.
template <class Real>
[[nodiscard]] Real area(const Complex<Real>& complex, Triangle t);
/// Eq. 4.
template <class Real>
[[nodiscard]] Real quality(const Complex<Real>& complex, Triangle t);
template <class Real>
[[nodiscard]] Real min_angle_deg(const Complex<Real>& complex, Triangle t);
template <class Real>
[[nodiscard]] Real mean_ratio(const Complex<Real>& complex, Triangle t);
template <class Real>
[[nodiscard]] Real aspect_ratio(const Complex<Real>& complex, Triangle t);
template <class Real>
[[nodiscard]] Real radius_ratio(const Complex<Real>& complex, Triangle t);

} // namespace dsc
