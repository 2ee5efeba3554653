// SPDX-License-Identifier: MIT
// Two discs that merge and shrink again, a dumbbell that splits, and discs that fill the square,
// against the exact shapes.
#include "scenes/catalogue/catalogue.h"
#include "scenes/run/run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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

// A disc beside a straight seam and a corner of the square, and one that has not begun to grow.
TEST(JohnsonMehl, ExactCellsEndWhereTwoFrontsMeetAndAtTheSides) {
    const GrowingDiscs discs{{{0.25, 0.5}, {0.75, 0.5}}, {0.1, 0.1}, {0, 0}};
    EXPECT_NEAR(exact_cell(discs, 0, 0.1).area, std::numbers::pi * 0.04, 1e-6);
    EXPECT_NEAR(exact_cell(discs, 1, 2).area, 0.5, 1e-6);
    EXPECT_NEAR(filling_time(discs), std::hypot(0.25, 0.5) - 0.1, 2e-3);
    const GrowingDiscs late{{{0.25, 0.5}, {0.75, 0.5}}, {0.1, 0.1}, {0, 0.2}};
    EXPECT_NEAR(exact_cell(late, 1, 0.15).area, std::numbers::pi * 0.01, 1e-6);
    EXPECT_NEAR(exact_cell(late, 0, 2).area + exact_cell(late, 1, 2).area, 1, 1e-6);
    EXPECT_GT(exact_cell(late, 0, 2).area, 0.6);
}

TEST(JohnsonMehl, DiscsThatNucleateHaveRoomAndFillTheSquare) {
    const auto discs = nucleating_discs(4, 13, 40);
    EXPECT_GT(discs.radii.size(), 4U);
    for (std::size_t i = 0; i < discs.radii.size(); ++i) {
        for (std::size_t j = 0; j < discs.radii.size(); ++j) {
            EXPECT_GE(discs.arrival(j, discs.centres[i]) - (i == j ? 0 : discs.radii[i]),
                      i == j ? discs.start(i) - discs.radii[i] : discs.start(i))
                << i << ", " << j;
        }
    }
    const Scene& scene = find_scene("johnson-mehl");
    Parameters parameters = scene.defaults;
    parameters.grains = 4;
    parameters.sites = 13;
    parameters.nucleation = 40;
    const RunResult result = run_scene(scene, parameters, {});
    EXPECT_EQ(result.inverted, 0U);
    EXPECT_EQ(result.phases.phases.size(), discs.radii.size()) << "of the exterior nothing is left";
    EXPECT_LT(number(result.diagram, "wrong_area_last"), 0.02);
}

} // namespace
} // namespace dsc::scenes::growth_scenes_test
