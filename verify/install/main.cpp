// SPDX-License-Identifier: MIT
// A stranger's program: a disc in a swirl. The README shows it, and a test builds and runs it.
#include <dsc/dsc.h>

#include <cmath>
#include <iostream>
#include <numbers>

int main() {
    using std::numbers::pi;
    std::vector<dsc::Point<double>> disc;
    for (int i = 0; i < 96; ++i) {
        disc.emplace_back(0.5 + 0.15 * std::cos(2 * pi * i / 96), 0.75 + 0.15 * std::sin(2 * pi * i / 96));
    }
    const std::vector<dsc::Shape> shapes{{disc, 1}}; // phase 1 in phase 0
    auto complex = dsc::initial_complex<double>({{0, 0}, {1, 1}}, shapes, {.edge_length = 0.01});

    dsc::Options<double> options;
    options.edge_length = 0.01;
    dsc::Simulation<double> simulation(complex, options);
    const dsc::Velocity<double> swirl = [](auto positions, double, auto velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const double x = pi * positions[i].x(), y = pi * positions[i].y();
            velocities[i] = {std::pow(std::sin(x), 2) * std::sin(2 * y), -std::pow(std::sin(y), 2) * std::sin(2 * x)};
        }
    };
    std::uint64_t unreached = 0;
    for (int step = 0; step < 100; ++step) {
        unreached += simulation.step(swirl, 0.01 * step, 0.01).unreached;
    }
    dsc::write_svg(complex, "swirl.svg");
    std::cout << complex.triangle_count() << " triangles, area of the disc "
              << dsc::phase_area(complex, 1) << ", unreached " << unreached << '\n';
    return unreached == 0 && dsc::validate(complex).ok() ? 0 : 1;
}
