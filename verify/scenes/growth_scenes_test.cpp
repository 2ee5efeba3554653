// SPDX-License-Identifier: MIT
// Two discs that merge and shrink again, and a dumbbell that splits, against the exact shapes.
#include "scenes/catalogue/catalogue.h"
#include "scenes/run/run.h"

#include <gtest/gtest.h>

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

} // namespace
} // namespace dsc::scenes::growth_scenes_test
