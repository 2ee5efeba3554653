// SPDX-License-Identifier: MIT
// The project's computation: a droplet is advected by a shear flow that reverses.
#include <dsc/dsc.h>

#include <cmath>
#include <iostream>
#include <numbers>

int main() {
    constexpr double period = 1, dt = 0.025;
    constexpr int steps = 40, corners = 64;
    std::vector<dsc::Point<double>> droplet;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        droplet.emplace_back(0.5 + 0.2 * std::cos(angle), 0.5 + 0.2 * std::sin(angle));
    }
    const std::vector<dsc::Shape> shapes{{droplet, 1}};
    auto complex = dsc::initial_complex<double>({{0, 0}, {1, 1}}, shapes, {.edge_length = 0.02});
    const double first = dsc::phase_area(complex, 1);

    dsc::Options<double> options;
    options.edge_length = 0.02;
    dsc::Simulation<double> simulation(complex, options);
    const dsc::Velocity<double> shear = [](auto positions, double time, auto velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const double speed = 0.8 * std::cos(std::numbers::pi * time / period);
            velocities[i] = {speed * (positions[i].y() - 0.5), 0};
        }
    };
    std::uint64_t unreached = 0;
    for (int step = 0; step < steps; ++step) {
        unreached += simulation.step(shear, dt * step, dt).unreached;
    }
    const double ratio = dsc::phase_area(complex, 1) / first;
    std::cout << "area ratio " << ratio << ", unreached " << unreached << '\n';
    return unreached == 0 && std::abs(ratio - 1) < 1e-3 && dsc::validate(complex).ok() ? 0 : 1;
}
