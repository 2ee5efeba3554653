// SPDX-License-Identifier: MIT
#include "dsc/geometry/predicates.h"

#include <boost/multiprecision/cpp_int.hpp>

namespace dsc {

namespace {

using Rational = boost::multiprecision::cpp_rational;

template <class... Values>
bool all_finite(Values... values) {
    return (std::isfinite(values) && ...);
}

int sign_of(const Rational& value) { return value.sign(); }

} // namespace

namespace exact {

int orientation(double ax, double ay, double bx, double by, double cx, double cy) {
    if (!all_finite(ax, ay, bx, by, cx, cy)) {
        return 0;
    }
    // Nearly all exactly collinear triples lie on an axis-aligned boundary, where both products are
    // 0.
    if ((bx == ax || cy == ay) && (by == ay || cx == ax)) {
        return 0;
    }
    const Rational x(ax);
    const Rational y(ay);
    const Rational left = (Rational(bx) - x) * (Rational(cy) - y);
    const Rational right = (Rational(by) - y) * (Rational(cx) - x);
    return sign_of(left - right);
}

int in_circle(double ax, double ay, double bx, double by, double cx, double cy, double dx,
              double dy) {
    if (!all_finite(ax, ay, bx, by, cx, cy, dx, dy)) {
        return 0;
    }
    const Rational x(dx);
    const Rational y(dy);
    const Rational adx = Rational(ax) - x;
    const Rational ady = Rational(ay) - y;
    const Rational bdx = Rational(bx) - x;
    const Rational bdy = Rational(by) - y;
    const Rational cdx = Rational(cx) - x;
    const Rational cdy = Rational(cy) - y;
    const Rational a_lift = adx * adx + ady * ady;
    const Rational b_lift = bdx * bdx + bdy * bdy;
    const Rational c_lift = cdx * cdx + cdy * cdy;
    return sign_of(a_lift * (bdx * cdy - bdy * cdx) + b_lift * (cdx * ady - cdy * adx) +
                   c_lift * (adx * bdy - ady * bdx));
}

} // namespace exact

int in_circle(double ax, double ay, double bx, double by, double cx, double cy, double dx,
              double dy) {
    const InCircleFilter filter = in_circle_filter(ax, ay, bx, by, cx, cy, dx, dy);
    if (std::abs(filter.determinant) > filter.error_bound() && filter.is_free_of_underflow()) {
        return filter.determinant > 0 ? 1 : -1;
    }
    return exact::in_circle(ax, ay, bx, by, cx, cy, dx, dy);
}

} // namespace dsc
