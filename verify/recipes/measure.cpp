// SPDX-License-Identifier: MIT
// A new measure: how round a shape is, in the result of every run that takes it.
#include "scenes/catalogue/catalogue.h"
#include "scenes/run/json.h"
#include "scenes/run/run.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace dsc::scenes;

static Measure roundness() {
    return {.name = "roundness",
            .unit = "1",
            .description = "4 pi area / perimeter^2, which is 1 for a circle",
            .needs = Needs::outlines,
            .function = [](const Moment& moment) {
                const double length = perimeter(moment.outlines);
                return 4 * std::numbers::pi * signed_area(moment.outlines) / (length * length);
            }};
}

TEST(Recipe, AMeasureIsOneMoreInTheList) {
    RunOptions options;
    options.measures.push_back(roundness()); // the line

    const Scene& scene = find_scene("swirl");
    Parameters parameters = scene.defaults;
    parameters.h = 0.05;
    parameters.steps = 40;
    const RunResult result = run_scene(scene, parameters, options);
    EXPECT_LT(number(*result.half, "roundness"), 0.9); // drawn out
    EXPECT_GT(number(result.last, "roundness"), 0.98); // and back
    EXPECT_NE(to_json(result).find("\"roundness_last\": 0.9"), std::string::npos);
}
