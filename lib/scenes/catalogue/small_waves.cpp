// SPDX-License-Identifier: MIT
// The Laplace transform in time turns the linearised equations into ordinary differential equations
// with two solutions in each fluid: one without vorticity, and one without pressure. Five
// conditions at the interface determine their coefficients and the height.
#include "scenes/catalogue/small_waves.h"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace dsc::scenes {

namespace {

using Amount = std::complex<double>;

/// A solution in one fluid at the interface, without its factor of a sine or cosine along the
/// interface.
struct Trace {
    Amount normal_velocity;
    Amount tangential_velocity;
    Amount tangential_stress;
    Amount pressure; ///< minus the viscous normal stress
};

/// Both solutions in a fluid.
struct Traces {
    Trace without_vorticity;
    Trace without_pressure;
};

/// Five equations: coefficients, then the right-hand side.
using Equations = std::array<std::array<Amount, 6>, 5>;

// The last unknown, by Gaussian elimination with partial pivoting.
Amount last_unknown(Equations rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::size_t pivot = i;
        for (std::size_t k = i + 1; k < rows.size(); ++k) {
            pivot = std::abs(rows[k][i]) > std::abs(rows[pivot][i]) ? k : pivot;
        }
        std::swap(rows[i], rows[pivot]);
        for (std::size_t k = i + 1; k < rows.size(); ++k) {
            const Amount factor = rows[k][i] / rows[i][i];
            for (std::size_t j = i; j < rows[k].size(); ++j) {
                rows[k][j] -= factor * rows[i][j];
            }
        }
    }
    return rows[4][5] / rows[4][4];
}

// The transform of the height, which causes a pressure of `stiffness` times the height.
Amount height(const Traces& inside, const Traces& outside, Amount s, double stiffness,
              double first) {
    Equations rows{};
    const auto fill = [&](std::size_t column, const Trace& t, double sign) {
        rows[0][column] = sign * t.normal_velocity;
        rows[1][column] = sign * t.tangential_velocity;
        rows[2][column] = sign * t.tangential_stress;
        rows[3][column] = sign * t.pressure;
    };
    fill(0, inside.without_vorticity, 1);
    fill(1, inside.without_pressure, 1);
    fill(2, outside.without_vorticity, -1);
    fill(3, outside.without_pressure, -1);
    rows[3][4] = -stiffness;
    rows[4] = {-inside.without_vorticity.normal_velocity,
               -inside.without_pressure.normal_velocity,
               0,
               0,
               s,
               first};
    return last_unknown(rows);
}

// The inverse of a transform at a time above 0, by Talbot's contour with the parameters of
// L. N. Trefethen, J. A. C. Weideman and T. Schmelzer, "Talbot quadratures and rational
// approximations" (2006).
template <class Transform>
double inverse(const Transform& transform, double time) {
    // The contour encloses poles up to about 0.4 * points / time; rounding errors grow by exp(0.17
    // * points).
    constexpr int points = 96;
    double sum = 0;
    for (int i = 0; i < points / 2; ++i) { // the other half is the complex conjugate
        const double angle = (2 * i + 1) * std::numbers::pi / points;
        const double turn = 0.6407 * angle;
        const double slope = 0.5017 / std::tan(turn) - 0.5017 * turn / std::pow(std::sin(turn), 2);
        const Amount s =
            points / time * Amount(0.5017 * angle / std::tan(turn) - 0.6122, 0.2645 * angle);
        const Amount way = points / time * Amount(slope, 0.2645);
        sum += (std::exp(s * time) * transform(s) * way).imag() * 2 / points;
    }
    return sum;
}

// --- on a level ----------------------------------------------------------------------------------

// The stream function is f(y) sin(k x), with f = 1 at the interface; `side` is 1 below, -1 above.
Trace trace_on_level(const FluidPhase& fluid, double k, Amount rate, double depth, double side,
                     Amount pressure_rate) {
    const Amount slope = side * rate / std::tanh(rate * depth);
    const Amount pressure = pressure_rate * slope / k;
    return {-k, slope, fluid.viscosity * (rate * rate + k * k),
            pressure + 2 * fluid.viscosity * k * slope};
}

Traces traces_on_level(const FluidPhase& fluid, double k, double depth, double side, Amount s) {
    const Amount rate = std::sqrt(k * k + s * fluid.density / fluid.viscosity);
    return {trace_on_level(fluid, k, k, depth, side, fluid.density * s),
            trace_on_level(fluid, k, rate, depth, side, 0)};
}

// --- on a drop -----------------------------------------------------------------------------------

// z I_n'(z) / I_n(z), by the continued fraction of I_(n+1) / I_n.
Amount growth_of_bessel_i(int n, Amount z) {
    Amount ratio = 0;
    const int last = n + 60 + static_cast<int>(2 * std::abs(z));
    for (int i = last; i > n; --i) {
        ratio = 1.0 / (2.0 * i / z + ratio);
    }
    return static_cast<double>(n) + z * ratio;
}

// z K_n'(z) / K_n(z), from the integral of exp(-z cosh x) cosh(n x) over x > 0, for which the
// trapezium rule converges faster than any power of its step.
Amount growth_of_bessel_k(int n, Amount z) {
    constexpr double step = 0.05;
    constexpr double negligible = 40;
    constexpr int max_terms = 1000; // enough at all points with a significant weight in the inverse
    Amount value = 0.5;
    Amount slope = 0.5;
    for (int i = 1; i < max_terms; ++i) {
        const double x = i * step;
        const Amount decay = z * (std::cosh(x) - 1);
        if (decay.real() > negligible + n * x) {
            break;
        }
        const Amount term = std::exp(-decay) * std::cosh(n * x);
        value += term;
        slope += term * std::cosh(x);
    }
    return -z * slope / value;
}

// The stream function is f(r) sin(n angle), with f = 1 at the interface, where r f' is `growth`
// and L f is `curl`, L being the Laplacian.
Trace trace_on_drop(const FluidPhase& fluid, int n, double radius, Amount growth, Amount curl,
                    Amount pressure_rate) {
    const double square = radius * radius;
    const Amount slope = growth / radius;
    const Amount second = curl - growth / square + n * n / square;
    const Amount stretch = 2.0 * fluid.viscosity * n * (growth - 1.0) / square;
    return {n / radius, -slope, fluid.viscosity * (growth / square - second - n * n / square),
            -pressure_rate * growth / static_cast<double>(n) - stretch};
}

Traces traces_on_drop(const FluidPhase& fluid, int n, double radius, bool is_inside, Amount s) {
    const Amount rate = std::sqrt(s * fluid.density / fluid.viscosity);
    const Amount growth =
        is_inside ? growth_of_bessel_i(n, rate * radius) : growth_of_bessel_k(n, rate * radius);
    return {trace_on_drop(fluid, n, radius, is_inside ? n : -n, 0, fluid.density * s),
            trace_on_drop(fluid, n, radius, growth, rate * rate, 0)};
}

} // namespace

std::function<double(double time)> wave_on_level(const TwoFluids& fluids, double k, double depth,
                                                 double gravity, double first) {
    const double stiffness =
        (fluids.inside.density - fluids.outside.density) * gravity + fluids.tension * k * k;
    return [=](double time) {
        const auto transform = [&](Amount s) {
            return height(traces_on_level(fluids.inside, k, depth, 1, s),
                          traces_on_level(fluids.outside, k, depth, -1, s), s, stiffness, first);
        };
        return time > 0 ? inverse(transform, time) : first;
    };
}

std::function<double(double time)> wave_on_drop(const TwoFluids& fluids, int n, double radius,
                                                double first) {
    const double stiffness = fluids.tension * (n * n - 1) / (radius * radius);
    return [=](double time) {
        const auto transform = [&](Amount s) {
            return height(traces_on_drop(fluids.inside, n, radius, true, s),
                          traces_on_drop(fluids.outside, n, radius, false, s), s, stiffness, first);
        };
        return time > 0 ? inverse(transform, time) : first;
    };
}

} // namespace dsc::scenes
