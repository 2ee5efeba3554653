// SPDX-License-Identifier: MIT
// Scenes whose interface is jagged, told from those whose interface is not.
#include "scenes/catalogue/catalogue.h"
#include "scenes/run/run.h"

#include <gtest/gtest.h>

namespace dsc::scenes::jaggedness_test {
namespace {

// What linear insertion does to a curve shows in its turns, not in its area.
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
