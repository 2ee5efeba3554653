// SPDX-License-Identifier: MIT
// Measures of triangles given by their corners (thesis, section 4.3), after J. R. Shewchuk, "What
// is a good linear finite element?" (2002), scaled to 1 for the equilateral triangle and signed: an
// inverted triangle has a negative value, a degenerate one 0. None of them needs trigonometry,
// except the angle itself. Measures of quality multiply at most two lengths, so that they neither
// under- nor overflow where the area does not; `sine_squared_of_lanes` is the exception.
#pragma once

#include "dsc/geometry/points.h"

#include <algorithm>
#include <cmath>

namespace dsc {

/// The signed area (thesis, equation 3): positive for a counter-clockwise triangle. Its sign may be
/// wrong where rounding decides: use `orientation` for the sign.
template <class Real>
[[nodiscard]] Real area(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c) {
    return ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x())) / 2;
}

// --- the quality of equation 4, 2 / sqrt 3 sin(smallest angle), in three roundings ---------------
// The smallest angle lies between the two longest edges: doubled area = longest * middle * sine.

/// The smallest target edge length of a simulation.
///
/// The squared quality divides products of six lengths. They keep full precision for triangles of
/// a quality above 1e-4 while h^6 is at least 1e8 times the smallest normal number, and edges of up
/// to 16 h do not overflow while h^6 is at most 1e-8 times the largest. A scene of another size is
/// run in the coordinates of a `Frame`.
template <class Real>
inline constexpr double min_edge_length = 1e-50;
/// `min_edge_length` for float.
template <>
inline constexpr double min_edge_length<float> = 1e-5;
/// The largest target edge length of a simulation; the reasons are those above.
template <class Real>
inline constexpr double max_edge_length = 1e50;
/// `max_edge_length` for float.
template <>
inline constexpr double max_edge_length<float> = 1e5;

/// The squared sine of the smallest angle, with the sign of the area: one quotient of products of
/// six lengths, for loops over all lanes of a star; lengths must lie between `min_edge_length` and
/// `max_edge_length`. The quality squared is 4/3 of it. (ax, ay) and (bx, by) lead from one corner
/// to the two others.
template <class Real>
[[nodiscard, gnu::always_inline]] inline Real sine_squared_of_lanes(Real ax, Real ay, Real bx,
                                                                    Real by) {
    const Real cx = bx - ax;
    const Real cy = by - ay;
    const Real doubled_area = ax * by - ay * bx;
    const Real aa = ax * ax + ay * ay;
    const Real bb = bx * bx + by * by;
    const Real cc = cx * cx + cy * cy;
    const Real shortest = std::min(aa, std::min(bb, cc));
    return (doubled_area * std::abs(doubled_area)) * shortest / (aa * bb * cc);
}

/// The same for lengths of any size: two quotients, each of two lengths by two. Not a number for
/// three equal points.
template <class Real>
[[nodiscard]] Real sine_squared(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c) {
    const Point<Real> ab = b - a;
    const Point<Real> ac = c - a;
    const Real bc = (c - b).squaredNorm();
    const Real longest = std::max({bc, ab.squaredNorm(), ac.squaredNorm()});
    const Real middle = std::max(std::min(ab.squaredNorm(), ac.squaredNorm()),
                                 std::min(std::max(ab.squaredNorm(), ac.squaredNorm()), bc));
    const Real doubled_area = ab.x() * ac.y() - ab.y() * ac.x();
    return (doubled_area / longest) * (std::abs(doubled_area) / middle);
}

/// Equation 4 itself, from 0 (degenerate) to 1 (equilateral).
template <class Real>
[[nodiscard]] Real quality(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c) {
    const Real signed_area = area(a, b, c);
    const Real aa = squared_distance(b, c);
    const Real bb = squared_distance(c, a);
    const Real cc = squared_distance(a, b);
    const Real longest = std::max({aa, bb, cc});
    const Real middle = std::max(std::min(aa, bb), std::min(std::max(aa, bb), cc));
    if (!(middle > 0)) {
        return 0;
    }
    constexpr Real four_over_sqrt3 = static_cast<Real>(2.3094010767585030580);
    return four_over_sqrt3 * (signed_area / longest) * std::sqrt(longest / middle);
}

/// The square of equation 4 for a triangle with a base of 1 and two equal legs of at least 1, whose
/// squared length is given: the smallest angle lies at the apex, so that its half has the sine
/// 1 / (2 legs).
template <class Real>
[[nodiscard]] Real squared_quality_of_needle(Real squared_legs) {
    return (4 - 1 / squared_legs) / (3 * squared_legs);
}

// --- other measures ------------------------------------------------------------------------------

/// The smallest angle in degrees, from 0 to 60. Not signed.
template <class Real>
[[nodiscard]] Real min_angle_deg(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c) {
    const Real aa = squared_distance(b, c);
    const Real bb = squared_distance(c, a);
    const Real cc = squared_distance(a, b);
    // The smallest angle lies opposite to the shortest edge; its cosine by the law of cosines.
    const Real shortest = std::min({aa, bb, cc});
    const Real dot = ((aa - shortest) + (bb - shortest) + (cc - shortest) + shortest) / 2;
    const Real cross = 2 * std::abs(area(a, b, c));
    if (!(cross > 0)) {
        return 0;
    }
    constexpr Real degrees = static_cast<Real>(57.295779513082320877);
    return degrees * std::atan2(cross, dot);
}

/// The centre of the circle through the corners; not finite for a degenerate triangle.
template <class Real>
[[nodiscard]] Point<Real> circumcentre(const Point<Real>& a, const Point<Real>& b,
                                       const Point<Real>& c) {
    const Point<Real> ab = b - a;
    const Point<Real> ac = c - a;
    const Real bb = ab.squaredNorm();
    const Real cc = ac.squaredNorm();
    const Real d = 2 * (ab.x() * ac.y() - ab.y() * ac.x());
    return a + Point<Real>(ac.y() * bb - ab.y() * cc, ab.x() * cc - ac.x() * bb) / d;
}

// --- the edge between two triangles --------------------------------------------------------------
// The Delaunay condition (thesis, section 4.2) without square roots: the angles opposite to the
// edge add up to at most pi, up to a slack that keeps cocircular points from flipping back and
// forth. `in_circle` and `certainly_in_circle` of predicates.h test the same condition without
// slack.

/// Relative slack of the Delaunay test: an edge is flipped only where the sine of the sum of its
/// opposite angles is below -slack times the size of its two terms, so that cocircular points do
/// not flip back and forth. Rounding is some 1e-15 (float: 1e-6) of that size.
template <class Real>
inline constexpr Real delaunay_slack = Real(1e-7);
/// `delaunay_slack` for float.
template <>
inline constexpr float delaunay_slack<float> = 1e-4F;

/// The sine of the sum of the two angles opposite to an edge, plus the slack: the edge is Delaunay
/// where it is not negative. The angles are given by multiples of their sine and cosine (a cross
/// and a dot product of the edges there).
template <class Real>
[[nodiscard]] Real delaunay_margin(Real sine_a, Real cosine_a, Real sine_d, Real cosine_d) {
    const Real one = sine_a * cosine_d;
    const Real two = cosine_a * sine_d;
    return one + two + delaunay_slack<Real> * (std::abs(one) + std::abs(two));
}

/// Whether the edge (b, w) of the triangles (a, b, w) and (d, w, b) is Delaunay.
template <class Real>
[[nodiscard]] bool is_delaunay(const Point<Real>& a, const Point<Real>& b, const Point<Real>& d,
                               const Point<Real>& w) {
    const Real abx = b.x() - a.x();
    const Real aby = b.y() - a.y();
    const Real awx = w.x() - a.x();
    const Real awy = w.y() - a.y();
    const Real dbx = b.x() - d.x();
    const Real dby = b.y() - d.y();
    const Real dwx = w.x() - d.x();
    const Real dwy = w.y() - d.y();
    return delaunay_margin<Real>(abx * awy - aby * awx, abx * awx + aby * awy,
                                 dwx * dby - dwy * dbx, dbx * dwx + dby * dwy) >= 0;
}

} // namespace dsc
