// SPDX-License-Identifier: MIT
// Case 1 of Hysing's rising bubble, early: the acceleration, the area and the energy.
#include "fluid/scenes.h"
#include "replay/mesh_hash.h"

#include <gtest/gtest.h>

namespace dsc::rising_bubble_test {
namespace {

using fluid_scenes::rising_bubble;
using fluid_scenes::Tank;

// The rise velocity at a time.
double rise(double edge_length, double dt, double end = 0.2) {
    Tank tank = rising_bubble(edge_length);
    for (int step = 0; step < std::lround(end / dt); ++step) {
        (void)tank.fluid.step(tank.simulation, dt);
    }
    return mean_velocity(tank.fluid.field(), 1).y();
}

TEST(FluidRisingBubble, StepsConvergeToSecondOrder) {
    const double coarse = rise(0.08, 0.04);
    const double middle = rise(0.08, 0.02);
    const double fine = rise(0.08, 0.01);
    EXPECT_GT(std::log2((middle - coarse) / (fine - middle)), 1.7);
    EXPECT_NEAR(rise(0.04, 0.01), 0.09420, 1e-4) << "that of edges of 0.01 and steps of 0.005";
}

// The smaller the tolerance, the more steps and the smaller the error.
TEST(FluidRisingBubble, StepsAreAsLongAsTheToleranceLetsThem) {
    const double exact = rise(0.1, 0.0025, 0.1);
    double last_error = 1;
    int last_steps = 0;
    for (const double tolerance : {3e-4, 1e-4, 1e-5}) {
        Tank tank = rising_bubble(0.1, {}, tolerance);
        const FluidStep all = tank.fluid.advance(tank.simulation, 0.1);
        EXPECT_DOUBLE_EQ(tank.fluid.time(), 0.1);
        EXPECT_LT(all.error, 2 * tolerance);
        const double error = std::abs(mean_velocity(tank.fluid.field(), 1).y() - exact);
        EXPECT_LT(error, last_error);
        EXPECT_GT(all.steps, last_steps);
        last_error = error;
        last_steps = all.steps;
    }
    EXPECT_LT(last_error, 5e-6);
}

TEST(FluidRisingBubble, AreaIsKeptAndEnergyOnlyLost) {
    Tank tank = rising_bubble(0.08);
    const double area = phase_area(tank.complex, 1);
    double before = energy(tank.fluid.field(), tank.fluid.options()).sum();
    for (int step = 0; step < 40; ++step) {
        const FluidStep report = tank.fluid.step(tank.simulation, 0.02);
        EXPECT_EQ(report.moved.unreached, 0U);
        EXPECT_GT(report.error, 0);
        EXPECT_LT(report.solved.residual, 1e-11);
        EXPECT_TRUE(validate(tank.complex).ok());
        const double now = energy(tank.fluid.field(), tank.fluid.options()).sum();
        EXPECT_LT(now, before + 1e-3) << "of 1912, at time " << tank.fluid.time();
        before = now;
    }
    EXPECT_NEAR(phase_area(tank.complex, 1) / area, 1, 1e-12);
}

// The result does not depend on which thread interpolates a velocity, assembles a triangle or
// eliminates a part.
TEST(FluidRisingBubble, TheSameForAnyNumberOfThreads) {
    Tank alone = rising_bubble(0.05, {.threads = 1});
    for (int step = 0; step < 5; ++step) {
        (void)alone.fluid.step(alone.simulation, 0.02);
    }
    for (const std::uint32_t threads : {2U, 3U}) {
        Tank together = rising_bubble(0.05, {.threads = threads});
        for (int step = 0; step < 5; ++step) {
            (void)together.fluid.step(together.simulation, 0.02);
        }
        EXPECT_EQ(mesh_hash(alone.complex), mesh_hash(together.complex));
        EXPECT_EQ(alone.fluid.field().velocity, together.fluid.field().velocity);
    }
}

} // namespace
} // namespace dsc::rising_bubble_test
