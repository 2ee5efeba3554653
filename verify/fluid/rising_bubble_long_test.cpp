// SPDX-License-Identifier: MIT
// Case 1 of Hysing's rising bubble to its end: the order of its errors. The gate has the figures.
#include "fluid/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace dsc::rising_bubble_long_test {
namespace {

// The maximum of a series with equal steps, by the parabola through the largest value and its
// neighbours.
double peak(const std::vector<double>& values) {
    const auto largest = std::max_element(values.begin() + 1, values.end() - 1);
    const double before = largest[-1];
    const double after = largest[1];
    const double place = (before - after) / 2 / (before - 2 * *largest + after);
    return *largest - (before - after) / 4 * place;
}

// The errors of the benchmark's three figures. The exact figures are extrapolated from runs of this
// solver with edges down to 0.01 and steps in proportion.
std::array<double, 3> errors_of(double edge_length) {
    fluid_scenes::Tank tank = fluid_scenes::rising_bubble(edge_length);
    const double dt = edge_length / 4;
    std::vector<double> flatness{0}; // one minus the circularity
    std::vector<double> rise{0};
    for (int step = 0; step < std::lround(3 / dt); ++step) {
        (void)tank.fluid.step(tank.simulation, dt);
        flatness.push_back(1 - cubic_outline(tank.complex, 1).circularity());
        rise.push_back(mean_velocity(tank.fluid.field(), 1).y());
    }
    return {std::abs(1 - peak(flatness) - 0.90125), std::abs(peak(rise) - 0.241668),
            std::abs(cubic_outline(tank.complex, 1).centroid.y() - 1.08172)};
}

// The order in edges and steps is at least 1.8 over two halvings. A single halving is too noisy,
// because single edge splits change the result.
TEST(FluidRisingBubbleLong, TheErrorsFallWithEdgesAndSteps) {
    const auto coarse = errors_of(0.08);
    const auto fine = errors_of(0.02);
    for (std::size_t i = 0; i < coarse.size(); ++i) {
        EXPECT_GT(std::log2(coarse[i] / fine[i]) / 2, 1.8) << "figure " << i;
    }
}

} // namespace
} // namespace dsc::rising_bubble_long_test
