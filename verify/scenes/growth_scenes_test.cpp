// SPDX-License-Identifier: MIT
// Two discs that merge and shrink again, and a dumbbell that splits, against the exact shapes.
#include "scenes/catalogue/catalogue.h"
#include "scenes/run/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dsc::scenes::growth_scenes_test {
namespace {

RunResult run(double h, Strategy strategy, const char* name = "grow-shrink") {
    const Scene& scene = find_scene(name);
    Parameters parameters = scene.defaults;
    parameters.h = h;
    RunOptions options;
    options.strategy = strategy;
    return run_scene(scene, parameters, options);
}

TEST(GrowShrink, MergesOnceAndIsOfSecondOrder) {
    const RunResult coarse = run(0.02, Strategy::sequential);
    const RunResult fine = run(0.005, Strategy::sequential);
    ASSERT_TRUE(fine.half.has_value());
    EXPECT_LT(number(*fine.half, "sd_rel"), 1.2e-4);
    EXPECT_LT(number(fine.last, "sd_rel"), 5e-4);
    const auto order = [](double one, double other) { return std::log2(one / other) / 2; };
    EXPECT_GT(order(number(*coarse.half, "sd_rel"), number(*fine.half, "sd_rel")), 1.9);
    EXPECT_GT(order(number(coarse.last, "sd_rel"), number(fine.last, "sd_rel")), 1.9);
}

TEST(GrowShrink, HappensInTheSameWayInEveryStrategy) {
    for (const Strategy strategy : all_strategies()) {
        if (strategy == Strategy::reference) {
            continue;
        }
        SCOPED_TRACE(to_string(strategy));
        const RunResult result = run(0.01, strategy);
        EXPECT_LT(number(*result.half, "sd_rel"), 5e-4);
        EXPECT_LT(number(result.last, "sd_rel"), 2e-3);
        EXPECT_EQ(result.inverted, 0U);
        EXPECT_EQ(std::ranges::count(result.events, EventKind::merge, &Event::kind), 1);
        EXPECT_EQ(std::ranges::count(result.events, EventKind::split, &Event::kind), 0);
        // They touch at 0.025, two sheets at a speed of 1: half the contact distance and a step.
        const auto merge = std::ranges::find(result.events, EventKind::merge, &Event::kind);
        EXPECT_NEAR(merge->time, 0.025, 0.4 * 0.01 / 2 + result.parameters.dt);
    }
}

RunResult erode(double h, Strategy strategy = Strategy::sequential) {
    return run(h, strategy, "erode-dumbbell");
}

TEST(ErodeDumbbell, IsOfSecondOrderBeforeAndAfterItSplits) {
    const RunResult coarse = erode(0.02);
    const RunResult fine = erode(0.005);
    ASSERT_TRUE(fine.half.has_value());
    EXPECT_LT(number(*fine.half, "sd_rel"), 5e-5);
    EXPECT_LT(number(fine.last, "sd_rel"), 5e-5);
    const auto order = [](double one, double other) { return std::log2(one / other) / 2; };
    EXPECT_GT(order(number(*coarse.half, "sd_rel"), number(*fine.half, "sd_rel")), 1.9);
    EXPECT_GT(order(number(coarse.last, "sd_rel"), number(fine.last, "sd_rel")), 1.9);
}

TEST(ErodeDumbbell, SplitsOnceInEveryStrategy) {
    for (const Strategy strategy : all_strategies()) {
        if (strategy == Strategy::reference) {
            continue;
        }
        SCOPED_TRACE(to_string(strategy));
        const RunResult result = erode(0.01, strategy);
        EXPECT_LT(number(*result.half, "sd_rel"), 2.5e-4);
        EXPECT_LT(number(result.last, "sd_rel"), 5e-4);
        EXPECT_EQ(result.inverted, 0U);
        // A straight neck closes all along at once: one event, and its seam that goes on.
        ASSERT_FALSE(result.events.empty());
        const Event& split = result.events.front();
        EXPECT_EQ(split.kind, EventKind::split);
        EXPECT_EQ(split.lost, 1U);
        EXPECT_EQ(static_cast<std::size_t>(
                      std::ranges::count(result.events, EventKind::widen, &Event::kind)),
                  result.events.size() - 1);
        // At 0.04; two sheets at a speed of 1: half the contact distance and a step.
        EXPECT_NEAR(split.time, 0.04, 0.4 * 0.01 / 2 + result.parameters.dt);
        const auto lobes = std::ranges::find(result.phases.phases, 1U, &PhaseFigures::phase);
        ASSERT_NE(lobes, result.phases.phases.end());
        EXPECT_EQ(lobes->components, 2U);
        EXPECT_EQ(lobes->holes, 0U);
        EXPECT_EQ(result.phases.phases.front().components, 1U) << "something is left in a lobe";
    }
}

// Flows that keep areas: what gets thin is drawn out, and nothing happens, to the bit.
TEST(Topology, ScenesWithoutContactAreWhatTheyWere) {
    for (const char* name : {"translation", "zalesak", "vortex-square", "speedup-four-circles"}) {
        SCOPED_TRACE(name);
        const Scene& scene = find_scene(name);
        RunOptions options;
        options.measure_shape = false;
        Parameters parameters = scene.defaults;
        const RunResult kept = run_scene(scene, parameters, options);
        parameters.topology = Topology::change;
        const RunResult free = run_scene(scene, parameters, options);
        EXPECT_TRUE(free.events.empty());
        EXPECT_EQ(free.mesh_hash, kept.mesh_hash);
    }
}

} // namespace
} // namespace dsc::scenes::growth_scenes_test
