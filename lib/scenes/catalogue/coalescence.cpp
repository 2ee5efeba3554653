// SPDX-License-Identifier: MIT
#include "scenes/catalogue/coalescence.h"

#include <cmath>
#include <numbers>

namespace dsc::scenes {

namespace {

using std::numbers::pi;

// The complete elliptic integral of the first kind, of the modulus, by the arithmetic-geometric
// mean.
double elliptic_integral(double modulus) {
    double a = 1;
    double b = std::sqrt(1 - modulus * modulus);
    while (std::abs(a - b) > 1e-15 * a) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    return pi / 2 / a;
}

// The m at which a function that falls with m has a value.
template <class Function>
double where_it_is(Function function, double value) {
    double low = 0;
    double high = 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (function(middle) > value ? low : high) = middle;
    }
    return (low + high) / 2;
}

} // namespace

Point<double> coalescing_outline(double m, double angle) {
    const double scale =
        (1 - m * m) / std::sqrt(1 + m * m) / (1 + 2 * m * std::cos(2 * angle) + m * m);
    return {scale * (1 + m) * std::cos(angle), scale * (1 - m) * std::sin(angle)};
}

double coalescing_neck(double m) { return (1 - m) / std::sqrt(1 + m * m); }

// The integral of (pi / 2) / (s sqrt(1 + s^2) K(s)) over s from m to 1, by the midpoint rule in
// log s and with one step of Richardson's. K has the modulus s, as the conformal map says: its
// poles move by the mean of the reciprocal slope (D. Crowdy, "On a class of geometry-driven free
// boundary problems", 2002).
double coalescing_time(double m) {
    const auto sum = [&](int n) {
        const double width = -std::log(m) / n;
        double total = 0;
        for (int i = 0; i < n; ++i) {
            const double s = std::exp(-width * (i + 0.5));
            total += width / (std::sqrt(1 + s * s) * elliptic_integral(s));
        }
        return pi / 2 * total;
    };
    return (4 * sum(400) - sum(200)) / 3;
}

double coalescing_at_neck(double neck) { return where_it_is(coalescing_neck, neck); }
double coalescing_at_time(double time) { return where_it_is(coalescing_time, time); }

} // namespace dsc::scenes
