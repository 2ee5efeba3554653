// SPDX-License-Identifier: MIT
// The exact heights of small waves, against independent computations of the same solution.
#include "scenes/catalogue/small_waves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dsc::scenes::small_waves_test {
namespace {

// Prosperetti's closed form for equal viscosities in unbounded fluids, computed to 30 digits.
TEST(SmallWaves, OnADeepLevelTheClosedForm) {
    const FluidPhase fluid{.density = 1, .viscosity = 0.0182571749236};
    const auto height = wave_on_level({fluid, fluid, 1}, 2 * std::numbers::pi, 10, 0, 0.01);
    EXPECT_EQ(height(0), 0.01);
    EXPECT_NEAR(height(0.1), 0.00526503712811, 1e-9);
    EXPECT_NEAR(height(0.5), 0.00158307657526, 1e-9);
    EXPECT_NEAR(height(1.0), -0.0025947961135, 1e-9);
    EXPECT_NEAR(height(2.2), -0.000760934667807, 1e-9);
}

// Reference values: Laplace transforms inverted by de Hoog's method in 25 digits, with a library's
// Bessel functions.
TEST(SmallWaves, OnADropAnotherInversion) {
    const auto height = wave_on_drop(
        {{.density = 1, .viscosity = 0.025}, {.density = 0.1, .viscosity = 0.0025}, 1}, 2, 1, 0.01);
    EXPECT_NEAR(height(0.25), 0.008412822604, 1e-9);
    EXPECT_NEAR(height(1), -0.005542225854, 1e-9);
    EXPECT_NEAR(height(2), -0.001666340029, 1e-9);
    EXPECT_NEAR(height(4), -0.005748450995, 1e-9);
}

TEST(SmallWaves, AlmostWithoutViscosityTheKnownFrequencies) {
    const FluidPhase heavy{.density = 3, .viscosity = 1e-7};
    const FluidPhase light{.density = 1, .viscosity = 1e-7};
    const double drop = std::sqrt(2 * 3 * 5.0 / ((3 + 1) * 8.0));
    EXPECT_NEAR(wave_on_drop({heavy, light, 5}, 2, 2, 1)(std::numbers::pi / drop), -1, 2e-3);
    const double level = std::sqrt((3 - 1) * 9.81 * 2 / 4 + 5 * 8 / 4.0);
    EXPECT_NEAR(wave_on_level({heavy, light, 5}, 2, 50, 9.81, 1)(std::numbers::pi / level), -1,
                2e-3);
}

} // namespace
} // namespace dsc::scenes::small_waves_test
