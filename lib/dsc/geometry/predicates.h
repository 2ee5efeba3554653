// SPDX-License-Identifier: MIT
// Exact signs. A static filter answers nearly always; Boost.Multiprecision answers the rest.
// J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
// predicates" (1997), gives the error bounds of the filters.
#pragma once

#include "dsc/base/types.h"

#include <algorithm>
#include <cmath>

namespace dsc {

namespace exact {
/// Sign of the doubled area of (a, b, c), computed in rational arithmetic; 0 for non-finite input.
int orientation(double ax, double ay, double bx, double by, double cx, double cy);
/// Sign of the in-circle determinant in rational arithmetic; 0 for non-finite input.
int in_circle(double ax, double ay, double bx, double by, double cx, double cy, double dx,
              double dy);
} // namespace exact

/// Rounding bound of a doubled area computed from differences of coordinates, relative to the sum
/// of the magnitudes of its two products: a doubled area of a larger magnitude has the right sign.
/// (3 + 16 eps) eps with eps = 2^-53 (Shewchuk 1997), and 2^-24 for float.
template <class Real>
inline constexpr Real area_bound = Real(3.3306690738754716e-16);
/// `area_bound` for float.
template <>
inline constexpr float area_bound<float> = 1.7881411e-7F;

/// Products below this may have lost bits to underflow, which the bound does not cover.
inline constexpr double underflow_guard = 1e-280;

/// +1 if (a, b, c) turns counter-clockwise, -1 if clockwise, 0 if collinear (or not finite).
/// Exact for every finite input. Thread-safe. Thesis 4.1: `Orientation`.
inline int orientation(double ax, double ay, double bx, double by, double cx, double cy) {
    const double left = (bx - ax) * (cy - ay);
    const double right = (by - ay) * (cx - ax);
    const double det = left - right;
    const double size = std::abs(left) + std::abs(right);
    if (std::abs(det) > area_bound<double> * size && size > underflow_guard) {
        return det > 0 ? 1 : -1;
    }
    return exact::orientation(ax, ay, bx, by, cx, cy);
}

/// The same for points.
template <class Real>
int orientation(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c) {
    return orientation(static_cast<double>(a.x()), static_cast<double>(a.y()),
                       static_cast<double>(b.x()), static_cast<double>(b.y()),
                       static_cast<double>(c.x()), static_cast<double>(c.y()));
}

/// The in-circle determinant of (a, b, c) and d in doubles, positive where d lies inside, and the
/// sum of the magnitudes of its terms, to which its rounding error is relative.
struct InCircleFilter {
    double determinant; ///< positive where d lies inside
    double permanent;   ///< the sum of the magnitudes of its terms

    /// A determinant of a larger magnitude has the right sign, unless products underflowed.
    [[nodiscard]] double error_bound() const {
        // (10 + 96 eps) eps with eps = 2^-53 (Shewchuk 1997).
        return 1.1102230246251577e-15 * permanent;
    }
    /// Whether the bound holds, that is, no product has lost bits to underflow.
    [[nodiscard]] bool is_free_of_underflow() const { return permanent > underflow_guard; }
};

/// The filter for four points. O(1), no allocation.
inline InCircleFilter in_circle_filter(double ax, double ay, double bx, double by, double cx,
                                       double cy, double dx, double dy) {
    const double adx = ax - dx;
    const double ady = ay - dy;
    const double bdx = bx - dx;
    const double bdy = by - dy;
    const double cdx = cx - dx;
    const double cdy = cy - dy;
    const double a_lift = adx * adx + ady * ady;
    const double b_lift = bdx * bdx + bdy * bdy;
    const double c_lift = cdx * cdx + cdy * cdy;
    return {.determinant = a_lift * (bdx * cdy - bdy * cdx) + b_lift * (cdx * ady - cdy * adx) +
                           c_lift * (adx * bdy - ady * bdx),
            .permanent = a_lift * (std::abs(bdx * cdy) + std::abs(bdy * cdx)) +
                         b_lift * (std::abs(cdx * ady) + std::abs(cdy * adx)) +
                         c_lift * (std::abs(adx * bdy) + std::abs(ady * bdx))};
}

/// +1 if d lies inside the circle through the counter-clockwise (a, b, c), -1 outside, 0 on it.
/// Exact for every finite input. Thread-safe.
int in_circle(double ax, double ay, double bx, double by, double cx, double cy, double dx,
              double dy);

/// The same for points.
template <class Real>
int in_circle(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c,
              const Point<Real>& d) {
    return in_circle(static_cast<double>(a.x()), static_cast<double>(a.y()),
                     static_cast<double>(b.x()), static_cast<double>(b.y()),
                     static_cast<double>(c.x()), static_cast<double>(c.y()),
                     static_cast<double>(d.x()), static_cast<double>(d.y()));
}

/// Whether d certainly lies inside the circle through the counter-clockwise (a, b, c). Within the
/// rounding error of doubles, which is far below `delaunay_slack`, the answer is no: points of an
/// outline are often cocircular, and exact zeros are expensive. Thread-safe.
inline bool certainly_in_circle(const Point<double>& a, const Point<double>& b,
                                const Point<double>& c, const Point<double>& d) {
    const InCircleFilter filter =
        in_circle_filter(a.x(), a.y(), b.x(), b.y(), c.x(), c.y(), d.x(), d.y());
    if (filter.is_free_of_underflow() && std::isfinite(filter.permanent)) {
        return filter.determinant > filter.error_bound();
    }
    return in_circle<double>(a, b, c, d) > 0;
}

/// Whether p lies in the axis-aligned bounding box of a and b, its boundary included.
template <class Real>
bool box_contains(const Point<Real>& a, const Point<Real>& b, const Point<Real>& p) {
    return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) &&
           std::min(a.y(), b.y()) <= p.y() && p.y() <= std::max(a.y(), b.y());
}

/// Whether the segments from a to b and from c to d have a point in common; exact.
template <class Real>
bool segments_meet(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c,
                   const Point<Real>& d) {
    const int abc = orientation<Real>(a, b, c);
    const int abd = orientation<Real>(a, b, d);
    const int cda = orientation<Real>(c, d, a);
    const int cdb = orientation<Real>(c, d, b);
    return (abc * abd < 0 && cda * cdb < 0) || (abc == 0 && box_contains<Real>(a, b, c)) ||
           (abd == 0 && box_contains<Real>(a, b, d)) || (cda == 0 && box_contains<Real>(c, d, a)) ||
           (cdb == 0 && box_contains<Real>(c, d, b));
}

} // namespace dsc
