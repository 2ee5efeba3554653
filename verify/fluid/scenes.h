// SPDX-License-Identifier: MIT
// Fluids from which several tests start.
#pragma once

#include <fluid/fluid.h>

#include <cmath>
#include <numbers>

namespace dsc::fluid_scenes {

/// A regular polygon of the area of the disc, with edges of at most the given length.
inline std::vector<Point<double>> disc(const Point<double>& centre, double radius,
                                       double edge_length) {
    using std::numbers::pi;
    const int n = static_cast<int>(std::ceil(2 * pi * radius / edge_length)) + 1;
    const double reach = radius * std::sqrt(2 * pi / n / std::sin(2 * pi / n));
    std::vector<Point<double>> outline;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * pi * (i + 0.5) / n;
        outline.emplace_back(centre.x() + reach * std::cos(angle),
                             centre.y() + reach * std::sin(angle));
    }
    return outline;
}

/// A complex, a simulation of it, and the fluid that moves its interface.
struct Tank {
    Tank(const Rectangle& domain, const std::vector<Shape>& shapes, const Options<double>& options,
         const FluidOptions& fluids, const Parallel& parallel = {})
        : complex(initial_complex<double>(
              domain, shapes,
              InitialOptions{.edge_length = options.edge_length, .sizes = options.sizes})),
          simulation(complex, options, parallel), fluid(complex, fluids) {}

    Complex<double> complex;
    Simulation<double> simulation;
    Fluid fluid;
};

/// A drop of radius 0.25 at rest in the unit square.
inline Tank static_drop(double edge_length, double tension) {
    const std::vector<Shape> drop{{disc({0.5, 0.5}, 0.25, edge_length), 1}};
    Options<double> options;
    options.edge_length = edge_length;
    FluidOptions fluids;
    fluids.phases = {{.phase = 0}, {.phase = 1}};
    fluids.tensions = {{.tension = tension}};
    return {{{0, 0}, {1, 1}}, drop, options, fluids};
}

/// Case 1 of S. Hysing et al., "Quantitative benchmark computations of two-dimensional bubble
/// dynamics" (2009).
inline Tank rising_bubble(double edge_length, const Parallel& parallel = {}, double tolerance = 0) {
    const std::vector<Shape> bubble{{disc({0.5, 0.5}, 0.25, edge_length), 1}};
    Options<double> options;
    options.edge_length = edge_length;
    options.sizes.growth = 1.3;
    options.sizes.longest = 5 * edge_length;
    options.interface.longest = 1.05;
    FluidOptions fluids;
    fluids.phases = {{.phase = 0, .density = 1000, .viscosity = 10},
                     {.phase = 1, .density = 100, .viscosity = 1}};
    fluids.tensions = {{.tension = 24.5}};
    fluids.gravity = {0, -0.98};
    fluids.walls = {.left = Wall::slip, .right = Wall::slip};
    fluids.threads = parallel.threads;
    fluids.tolerance = tolerance;
    return {{{0, 0}, {1, 2}}, bubble, options, fluids, parallel};
}

} // namespace dsc::fluid_scenes
