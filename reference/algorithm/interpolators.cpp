// SPDX-License-Identifier: MIT
#include "reference/algorithm/interpolators.h"

#include <array>
#include <cstddef>

namespace dsc::reference {

namespace {

constexpr double cos_feature = 0.766044443118978; // 40 degrees

bool is_feature(const Point<double>& a, const Point<double>& b, const Point<double>& c) {
    return (b - a).dot(c - b) < cos_feature * (b - a).norm() * (c - b).norm();
}

} // namespace

Point<double> linear_point(const Point<double>&, const Point<double>& p1, const Point<double>& p2,
                           const Point<double>&) {
    return 0.5 * (p1 + p2);
}

Point<double> lagrange_point_at(const Point<double>& p0, const Point<double>& p1,
                                const Point<double>& p2, const Point<double>& p3, double fraction) {
    const std::array<Point<double>, 4> p{p0, p1, p2, p3};
    std::array<double, 4> t{};
    for (std::size_t i = 1; i < 4; ++i) {
        t[i] = t[i - 1] + (p[i] - p[i - 1]).norm();
        if (!(t[i] > t[i - 1])) {
            return (1 - fraction) * p1 + fraction * p2;
        }
    }
    const double s = (1 - fraction) * t[1] + fraction * t[2];
    Point<double> sum = Point<double>::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
        double weight = 1;
        for (std::size_t j = 0; j < 4; ++j) {
            if (j != i)
                weight *= (s - t[j]) / (t[i] - t[j]);
        }
        sum += weight * p[i];
    }
    return sum;
}

Point<double> lagrange_point(const Point<double>& p0, const Point<double>& p1,
                             const Point<double>& p2, const Point<double>& p3) {
    return lagrange_point_at(p0, p1, p2, p3, 0.5);
}

Point<double> cubic_point(const Point<double>& p0, const Point<double>& p1, const Point<double>& p2,
                          const Point<double>& p3) {
    if (is_feature(p0, p1, p2) || is_feature(p1, p2, p3)) {
        return 0.5 * (p1 + p2);
    }
    return lagrange_point(p0, p1, p2, p3);
}

} // namespace dsc::reference
