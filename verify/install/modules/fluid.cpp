// SPDX-License-Identifier: MIT
#include <dsc/dsc.h>
#include <dsc/fluid/fluid.h>

#include <cmath>
#include <iostream>
#include <numbers>

int main() {
    std::vector<dsc::Point<double>> bubble;
    for (int i = 0; i < 40; ++i) {
        const double angle = std::numbers::pi * i / 20;
        bubble.emplace_back(0.5 + 0.25 * std::cos(angle), 0.5 + 0.25 * std::sin(angle));
    }
    dsc::Options<double> options;
    options.edge_length = 0.04;
    options.sizes = {.growth = 1.3, .longest = 0.1}; // coarser away from the interface
    auto complex = dsc::initial_complex<double>(
        {{0, 0}, {1, 2}}, std::vector<dsc::Shape>{{bubble, 1}},
        {.edge_length = options.edge_length, .sizes = options.sizes});
    dsc::Simulation<double> simulation(complex, options);

    dsc::FluidOptions fluids;
    fluids.phases = {{.phase = 0, .density = 1000, .viscosity = 10},
                     {.phase = 1, .density = 100, .viscosity = 1}};
    fluids.tensions = {{.one = 0, .other = 1, .tension = 24.5}};
    fluids.gravity = {0, -0.98};
    fluids.walls = {.left = dsc::Wall::slip, .right = dsc::Wall::slip};
    dsc::Fluid fluid(complex, fluids);
    for (int step = 0; step < 20; ++step) {
        fluid.step(simulation, 0.01);
    }
    const double rise = dsc::mean_velocity(fluid.field(), 1).y();
    std::cout << "the bubble rises at " << rise << '\n';
    return std::abs(rise - 0.0942) < 1e-3 ? 0 : 1;
}
