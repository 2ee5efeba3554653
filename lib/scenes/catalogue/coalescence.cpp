// SPDX-License-Identifier: MIT
#include "scenes/catalogue/coalescence.h"

#include <cmath>
#include <numbers>

namespace dsc::scenes {

namespace {

using std::numbers::pi;

// The complete elliptic integral of the first kind, of the complementary modulus, by the
// arithmetic-geometric mean.
double elliptic_integral(double complement) {
    double a = 1;
    double b = complement;
    while (std::abs(a - b) > 1e-15 * a) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    return pi / 2 / a;
}

// Solves for the m at which a function that decreases with m has the given value.
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

// The integral of (pi / 2) / (s sqrt(1 + s^2) K(s)) over s from m to 1. K has the modulus s, which
// follows from the conformal map: its poles move by the mean of the reciprocal slope (D. Crowdy,
// "On a class of geometry-driven free boundary problems", 2002). The integrand has an infinite
// slope at 1, which the double exponential rule can integrate (H. Takahasi and M. Mori, "Double
// exponential formulas for numerical integration", 1974). The variable is log s / log m.
double coalescing_time(double m) {
    constexpr int count = 56; // on either side
    constexpr double reach = 3.5;
    double total = 0;
    for (int i = -count; i <= count; ++i) {
        const double t = reach * i / count;
        const double share = 1 / (1 + std::exp(pi * std::sinh(t)));
        const double beyond = 1 / (1 + std::exp(-pi * std::sinh(t)));
        const double weight = pi * std::cosh(t) * share * beyond * reach / count;
        const double s = std::exp(share * std::log(m));
        const double complement = std::sqrt(-std::expm1(2 * share * std::log(m)));
        total += weight / (std::sqrt(1 + s * s) * elliptic_integral(complement));
    }
    return -pi / 2 * std::log(m) * total;
}

double coalescing_at_neck(double neck) { return where_it_is(coalescing_neck, neck); }
double coalescing_at_time(double time) { return where_it_is(coalescing_time, time); }

} // namespace dsc::scenes
