// SPDX-License-Identifier: MIT
// Motions of the whole interface in steps: how often they are called, with which dt, and what
// becomes of what they write.
#include "support/interface_view_testing.h"
#include "support/simulation_testing.h"

#include "dsc/base/error.h"
#include "dsc/queries/validate.h"
#include "scenes/integrator_choice.h"

#include <gtest/gtest.h>

#include <limits>

namespace dsc::interface_motion_test {
namespace {

using test::coarse;
using test::disc_complex;
using test::expect_sound;
using test::options_for;

InterfaceMotion<double> translation(double x, double y) {
    return [=](const auto& view, double, double dt, auto displacements) {
        EXPECT_EQ(test::view_fault(view), "");
        for (auto& way : displacements) {
            way = dt * Point<double>(x, y);
        }
    };
}

// Once for each sub-step, and once more where the driver finds that the step must be divided.
TEST(InterfaceMotion, IsCalledAgainWhenTheStepIsDivided) {
    auto complex = disc_complex<double>(coarse);
    const auto options = options_for<double>(coarse);
    Simulation<double> simulation(complex, options);
    std::vector<std::pair<double, double>> calls;
    const InterfaceMotion<double> motion = [&](const auto&, double time, double dt,
                                               auto displacements) {
        calls.emplace_back(time, dt);
        for (auto& way : displacements) {
            way = Point<double>(dt, 0);
        }
    };
    EXPECT_EQ(simulation.step(motion, 1, 0.02).sub_steps, 1U);
    EXPECT_EQ(calls, (std::vector<std::pair<double, double>>{{1, 0.02}}));
    calls.clear();
    // 0.05 at a speed that is known to be 1, with sub-steps of at most 0.03.
    EXPECT_EQ(simulation.step(motion, 2, 0.05).sub_steps, 2U);
    EXPECT_EQ(calls, (std::vector<std::pair<double, double>>{{2, 0.025}, {2.025, 0.025}}));
    calls.clear();
    auto other = disc_complex<double>(coarse);
    Simulation<double> another(other, options);
    EXPECT_EQ(another.step(motion, 0, 0.05).sub_steps, 2U);
    ASSERT_EQ(calls.size(), 3U);
    EXPECT_EQ(calls[0], std::pair(0.0, 0.05));
    EXPECT_EQ(calls[1], std::pair(0.0, 0.025));
}

TEST(InterfaceMotion, HoldsWhatIsNotFiniteAndLocked) {
    auto complex = disc_complex<double>(coarse);
    const auto options = options_for<double>(coarse);
    Simulation<double> simulation(complex, options);
    const auto list = simulation.interface();
    complex.set_locked(Vertex{list[9]}, true);
    std::vector<Point<double>> before;
    for (const std::uint32_t v : list) {
        before.push_back(complex.position(Vertex{v}));
    }
    const InterfaceMotion<double> motion = [](const auto&, double, double dt, auto displacements) {
        for (auto& way : displacements) {
            way = Point<double>(0, 0.1 * dt);
        }
        displacements[4].x() = std::numeric_limits<double>::quiet_NaN();
    };
    const StepReport report = simulation.step(motion, 0, 0.01);
    EXPECT_EQ(report.held, 1U);
    EXPECT_EQ(report.unreached, 1U);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const double way = i == 4 || i == 9 ? 0 : 0.001;
        EXPECT_LT((complex.position(Vertex{list[i]}) - before[i] - Point<double>(0, way)).norm(),
                  1e-15);
    }
    expect_sound(complex, simulation);
}

TEST(InterfaceMotion, TellsOfTheFastestVertexWhenItGivesUp) {
    auto complex = disc_complex<double>(coarse);
    auto options = options_for<double>(coarse);
    options.max_sub_steps = 3;
    Simulation<double> simulation(complex, options);
    const StepReport report = simulation.step(translation(30, 40), 0, 0.1);
    EXPECT_EQ(report.gave_up, GiveUp::too_many_sub_steps);
    EXPECT_NEAR(report.speed, 50, 1e-12);
    EXPECT_TRUE(complex.is_alive(report.where));
}

// Nothing would move, and it would not be called: a velocity need not be asked, but a motion that
// knows no time is waited for in vain.
TEST(InterfaceMotion, RefusesNoTime) {
    auto complex = disc_complex<double>(coarse);
    Simulation<double> simulation(complex, options_for<double>(coarse));
    EXPECT_THROW((void)simulation.step(translation(0.5, 0.25), 0, 0), InputError);
    EXPECT_EQ(simulation.step(test::constant<double>(0.5, 0.25), 0, 0).sub_steps, 0U);
    EXPECT_EQ(simulation.step(translation(0.5, 0.25), 0, 0.01).sub_steps, 1U);
}

} // namespace
} // namespace dsc::interface_motion_test
