// SPDX-License-Identifier: MIT
#include "dsc3/geometry/predicates.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <cmath>

namespace dsc3 {

namespace {

using Rational = boost::multiprecision::cpp_rational;

int exact_orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
    std::array<Rational, 3> u;
    std::array<Rational, 3> v;
    std::array<Rational, 3> w;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Rational origin(a[i]);
        u[i] = Rational(b[i]) - origin;
        v[i] = Rational(c[i]) - origin;
        w[i] = Rational(d[i]) - origin;
    }
    const Rational sum = (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
                         (u[0] * v[1] - u[1] * v[0]) * w[2];
    return sum.sign();
}

} // namespace

int orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Point u = b - a;
    const Point v = c - a;
    const Point w = d - a;
    const Point left(u.y() * v.z(), u.z() * v.x(), u.x() * v.y());
    const Point right(u.z() * v.y(), u.x() * v.z(), u.y() * v.x());
    const Real value = (left - right).dot(w);
    const Real size = (left.cwiseAbs() + right.cwiseAbs()).dot(w.cwiseAbs());
    // (7 + 56 eps) eps with eps = 2^-53 (Shewchuk 1997); products below 1e-280 may have lost bits.
    if (std::abs(value) > 7.7715611723761027e-16 * size && size > 1e-280 && std::isfinite(size)) {
        return value > 0 ? 1 : -1;
    }
    const bool finite = a.allFinite() && b.allFinite() && c.allFinite() && d.allFinite();
    return finite ? exact_orientation(a, b, c, d) : 0;
}

} // namespace dsc3
