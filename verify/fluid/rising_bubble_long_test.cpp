// SPDX-License-Identifier: MIT
// Case 1 of Hysing's rising bubble to its end: the order of its errors. The gate has the figures.
#include "fluid/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace dsc::rising_bubble_long_test {
namespace {

// The largest value of a series with equal steps, on the parabola through three.
double peak(const std::vector<double>& values) {
    const auto largest = std::max_element(values.begin() + 1, values.end() - 1);
    const double before = largest[-1];
    const double after = largest[1];
    const double place = (before - after) / 2 / (before - 2 * *largest + after);
    return *largest - (before - after) / 4 * place;
}

// How far the three figures of the benchmark are from those that a series of ever finer runs of
// this solver goes to: edges down to 0.01, steps in proportion.
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

// Of order 1.8 and more in edges and steps, over two halvings: in a single one chance has its part,
// since an edge is split here or there.
TEST(FluidRisingBubbleLong, TheErrorsFallWithEdgesAndSteps) {
    const auto coarse = errors_of(0.08);
    const auto fine = errors_of(0.02);
    for (std::size_t i = 0; i < coarse.size(); ++i) {
        EXPECT_GT(std::log2(coarse[i] / fine[i]) / 2, 1.8) << "figure " << i;
    }
}

} // namespace
} // namespace dsc::rising_bubble_long_test
