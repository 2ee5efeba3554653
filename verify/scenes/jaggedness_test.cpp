// SPDX-License-Identifier: MIT
// The measure distinguishes jagged interfaces from smooth ones.
#include "scenes/catalogue/catalogue.h"
#include "scenes/run/run.h"

#include <gtest/gtest.h>

namespace dsc::scenes::jaggedness_test {
namespace {

// Linear insertion changes the turns of a curve, but hardly its area.
TEST(Jagged, LinearInsertionIsJagged) {
    const Scene& scene = find_scene("swirl");
    Parameters parameters = scene.defaults;
    parameters.h = 0.02;
    parameters.steps = 160;
    const RunResult cubic = run_scene(scene, parameters, {});
    parameters.insertion = Insertion::linear;
    const RunResult linear = run_scene(scene, parameters, {});
    EXPECT_LE(number(cubic.last, "jaggedness.largest_excess_deg"), 0.0);
    EXPECT_GT(number(linear.last, "jaggedness.largest_excess_deg"), 0.0);
}

} // namespace
} // namespace dsc::scenes::jaggedness_test
