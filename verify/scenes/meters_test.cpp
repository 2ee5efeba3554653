// SPDX-License-Identifier: MIT
// The measurements of a run must detect known faults.
#include "scenes/run/run.h"
#include "scenes/scene.h"

#include "measures/mesh_quality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc::scenes::meters_test {
namespace {

constexpr double h = 0.025;

Outline disc(double x) {
    Outline outline;
    for (int i = 0; i < 48; ++i) {
        const double angle = 2 * std::numbers::pi * i / 48;
        outline.emplace_back(x + 0.18 * std::cos(angle), 0.5 + 0.18 * std::sin(angle));
    }
    return outline;
}

// The left one of two discs is pressed against the other one, and then drawn back.
Scene pressed(int steps_against, int steps_back) {
    Scene scene;
    scene.name = "pressed";
    scene.prepare = [=](const Parameters&) {
        const auto left_moves = [](double speed) -> Velocity {
            return [speed](auto positions, double, auto velocities) {
                for (std::size_t i = 0; i < positions.size(); ++i) {
                    velocities[i] = {positions[i].x() < 0.54 - 1e-6 ? speed : 0, 0};
                }
            };
        };
        Setup setup;
        setup.domain = {{0, 0}, {1, 1}};
        setup.outlines = {disc(0.28), disc(0.72)};
        setup.flow = {{steps_against - 0.5, left_moves(0.3 * h)}, {1e9, left_moves(-0.3 * h)}};
        setup.dt = 1;
        setup.steps = steps_against + steps_back;
        return setup;
    };
    scene.defaults.h = h;
    return scene;
}

RunResult run(const Scene& scene) {
    RunOptions options;
    options.measure_shape = false;
    options.series_every = 1;
    return run_scene(scene, scene.defaults, options);
}

TEST(Meters, CountEachVertexThatDidNotArriveInAnyStep) {
    const RunResult against = run(pressed(24, 0));
    EXPECT_GT(against.unreached, 10U);
    const RunResult back = run(pressed(24, 6));
    ASSERT_FALSE(back.series.empty());
    EXPECT_EQ(back.series.back().unreached, 0U) << "all arrive in the last step";
    EXPECT_GE(back.unreached, against.unreached);
    std::uint64_t sum = 0;
    for (const SeriesRow& row : back.series) {
        sum += row.unreached;
    }
    EXPECT_EQ(sum, back.unreached);
}

TEST(Meters, RememberTheWorstTriangleOfTheWholeRun) {
    double worst = 1;
    const Scene scene = pressed(24, 12);
    RunOptions options;
    options.measure_shape = false;
    options.observer = [&](int, const Complex<double>& complex) {
        worst = std::min(worst, measure_worst(complex).min_quality);
    };
    const RunResult result = run_scene(scene, scene.defaults, options);
    EXPECT_EQ(result.min_quality_ever, worst);
    EXPECT_LT(worst, number(result.last, "min_quality"));
}

// Times are multiples of the step, not sums, so that the last step ends exactly at the scene's end.
TEST(Meters, CountTimeWithoutRoundingItStepByStep) {
    constexpr double dt = 0.005; // its sums are rounded differently from its multiples
    Scene scene = pressed(60, 0);
    scene.prepare = [usual = scene.prepare](const Parameters& parameters) {
        scenes::Setup setup = usual(parameters);
        setup.dt = dt;
        return setup;
    };
    const RunResult result = run(scene);
    ASSERT_GT(result.series.size(), 5U);
    for (const SeriesRow& row : result.series) {
        EXPECT_EQ(row.time, row.step * dt);
    }
}

} // namespace
} // namespace dsc::scenes::meters_test
