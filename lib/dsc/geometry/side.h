// SPDX-License-Identifier: MIT
// The sides of the domain boundary: straight in any direction, up to rounding, or curved. Between
// its features the boundary is taken as a smooth curve through its vertices, and near each vertex
// as the circle through it and its two neighbours.
//
// Which turns are features is decided at the start (`make_complex`) and kept with the vertex
// (`Complex::is_boundary_feature`), because remeshing changes the turns of a curved side: where the
// end of a curve slides along it, edges become longer.
#pragma once

#include "dsc/geometry/points.h"
#include "dsc/geometry/predicates.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace dsc {

/// The shape of the domain boundary at a vertex.
enum class Side : std::uint8_t {
    straight, ///< it goes on straight, up to rounding
    curved,   ///< it turns, but has a tangent
    feature,  ///< it turns sharply
};

/// A sharper turn of the domain boundary at the start is marked as a feature, and stays one.
inline constexpr double side_turn_degrees = 12;
/// A sharper turn is a feature even if it is not marked: no curved side turns as much later on.
inline constexpr double side_corner_degrees = 45;
/// A vertex on a curved side may be removed if its distance from the merged edge is at most this
/// fraction of that edge.
inline constexpr double side_deviation = 0.02;

namespace detail {

/// The height of `at` over the line from `from` to `to`, positive on its right, and the length of
/// that line.
template <class Real>
struct SideHeight {
    SideHeight(const Point<Real>& from, const Point<Real>& at, const Point<Real>& to)
        : chord(distance<Real>(from, to)),
          height(cross<Real>(Point<Real>(to - from), Point<Real>(from - at)) / chord) {}
    Real chord;
    Real height;
};

/// The tolerance covers the rounding of the three points, of midpoints of rounded edges, and of
/// meshes from files with ten digits.
template <class Real>
bool is_straight(const Point<Real>& from, const Point<Real>& at, const Point<Real>& to) {
    const Real largest =
        std::max({from.cwiseAbs().maxCoeff(), to.cwiseAbs().maxCoeff(), at.cwiseAbs().maxCoeff()});
    const SideHeight<Real> over(from, at, to);
    const Real rounding = std::max(4 * std::numeric_limits<Real>::epsilon() * largest,
                                   static_cast<Real>(1e-10) * over.chord);
    return std::abs(over.height) <= rounding;
}

} // namespace detail

/// The shape of the domain boundary at `at`, between its two neighbours. `is_marked`: the vertex
/// there is a boundary feature. It need not turn, such as the end of an inlet in a wall. O(1).
template <class Real>
[[nodiscard]] Side side_at(const Point<Real>& from, const Point<Real>& at, const Point<Real>& to,
                           bool is_marked) {
    // First, since the direction of an edge that is as short as rounding says nothing: a feature
    // with such an edge is marked.
    if (orientation<Real>(from, at, to) == 0 ||
        (!is_marked && detail::is_straight<Real>(from, at, to))) {
        return Side::straight;
    }
    constexpr double cosine_of_turn = 0.97814760073380564;       // of `side_turn_degrees`
    constexpr double cosine_of_corner = std::numbers::sqrt2 / 2; // of `side_corner_degrees`
    if (!turns_less<Real>(from, at, to,
                          static_cast<Real>(is_marked ? cosine_of_turn : cosine_of_corner))) {
        return Side::feature;
    }
    return detail::is_straight<Real>(from, at, to) ? Side::straight : Side::curved;
}

/// Whether the triangle has an area only by rounding, as one of three points of a side that is
/// straight, but along no axis. O(1).
template <class Real>
[[nodiscard]] bool is_flat(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c) {
    const Real ab = squared_distance<Real>(a, b);
    const Real bc = squared_distance<Real>(b, c);
    const Real ca = squared_distance<Real>(c, a);
    return ab >= std::max(bc, ca) ? detail::is_straight<Real>(a, c, b)
           : bc >= ca             ? detail::is_straight<Real>(b, a, c)
                                  : detail::is_straight<Real>(c, b, a);
}

/// Whether the domain keeps its shape, up to rounding or `side_deviation`, if the vertex `at` of
/// its boundary, which is not marked, is removed. O(1).
template <class Real>
[[nodiscard]] bool may_leave_side(const Point<Real>& from, const Point<Real>& at,
                                  const Point<Real>& to) {
    const Side side = side_at<Real>(from, at, to, false);
    if (side != Side::curved) {
        return side == Side::straight;
    }
    const detail::SideHeight<Real> over(from, at, to);
    return std::abs(over.height) <= static_cast<Real>(side_deviation) * over.chord;
}

/// The direction of the side at `at`, which is no feature: the tangent of the circle. O(1).
template <class Real>
[[nodiscard]] Point<Real> tangent_of_side(const Point<Real>& from, const Point<Real>& at,
                                          const Point<Real>& to) {
    const Point<Real> in = at - from;
    const Point<Real> out = to - at;
    return (in / in.squaredNorm() + out / out.squaredNorm()).normalized();
}

/// The place on the circle through the three points whose projection on the line from `from` to
/// `to` lies at this distance from `from`. On a straight side it lies on that line. O(1).
template <class Real>
[[nodiscard]] Point<Real> point_of_side(const Point<Real>& from, const Point<Real>& at,
                                        const Point<Real>& to, Real along) {
    const detail::SideHeight<Real> over(from, at, to);
    const Point<Real> way = (to - from) / over.chord;
    const Real here = (at - from).dot(way);
    // With q = t (chord - t), the height y over t satisfies y = k (q - y^2) on the circle; k is the
    // same for all its points, and 0 for a line.
    const Real k = over.height / (here * (over.chord - here) - over.height * over.height);
    const Real q = along * (over.chord - along);
    const Real y = 2 * k * q / (1 + std::sqrt(std::max(Real(0), 1 + 4 * k * k * q)));
    return from + along * way + y * Point<Real>(way.y(), -way.x());
}

/// The position that an unmarked vertex of the domain boundary with this target takes: it slides
/// along a straight side, and stays at a sharp turn. On a curved side only the ends of curves
/// slide; other vertices stay, because each move changes the shape of the domain slightly. O(1).
template <class Real>
[[nodiscard]] Point<Real> slid_on_side(const Point<Real>& from, const Point<Real>& at,
                                       const Point<Real>& to, const Point<Real>& target,
                                       bool is_end_of_curve) {
    const Real tx = to.x() - from.x();
    const Real ty = to.y() - from.y();
    const Real square = tx * tx + ty * ty;
    const Real along = ((target.x() - at.x()) * tx + (target.y() - at.y()) * ty) / square;
    if (orientation<Real>(from, at, to) == 0) {
        return {at.x() + along * tx, at.y() + along * ty};
    }
    const Side side = side_at<Real>(from, at, to, false);
    if (side == Side::feature || (side == Side::curved && !is_end_of_curve)) {
        return at;
    }
    const Real here = (at - from).dot(to - from) / square;
    if (side == Side::straight) {
        return from + (here + along) * (to - from);
    }
    // The vertex stops before its neighbours; a neighbour in its way is removed before the next
    // sub-step.
    constexpr auto near = Real(0.05); // of the way from one neighbour to the other
    const Real share = std::clamp(here + along, std::min(here, near), std::max(here, 1 - near));
    return point_of_side<Real>(from, at, to, share * std::sqrt(square));
}

/// The middle of the edge from `at` to `to` of the domain boundary: on the circle through these and
/// the neighbour before, if the side is curved there. `is_marked`: the vertex at `at` is a boundary
/// feature. O(1).
template <class Real>
[[nodiscard]] Point<Real> middle_of_side(const Point<Real>& before, const Point<Real>& at,
                                         const Point<Real>& to, bool is_marked) {
    if (side_at<Real>(before, at, to, is_marked) != Side::curved) {
        return midpoint<Real>(at, to);
    }
    const Real half = distance<Real>(at, to) / 2;
    return point_of_side<Real>(at, before, to, half);
}

} // namespace dsc
