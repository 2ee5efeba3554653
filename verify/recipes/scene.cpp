// SPDX-License-Identifier: MIT
// A new scene: a star that turns once, beside all the others.
#include "flows/exact.h"
#include "scenes/catalogue/catalogue.h"
#include "scenes/command_line/scene_program.h"
#include "shapes/shapes.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace dsc::scenes;

static Scene turning_star() {
    return {.name = "turning-star",
            .description = "a star with five tips turns once about its centre",
            .section = "a recipe",
            .defaults = {.h = 0.04, .dt = 0.01, .steps = 100},
            .prepare = [](const Parameters& p) {
                const dsc::Point<double> middle(0.5, 0.5);
                const double speed = 2 * std::numbers::pi / (p.steps * p.dt);
                const std::vector<Outline> first{star(middle, 0.35, 0.2, 5, p.h)};
                return Setup{
                    .outlines = first,
                    .flow = steady(Rotation{middle, speed}),
                    .dt = p.dt,
                    .steps = p.steps,
                    .exact = [=](double t) { return rotated_shape(first, middle, speed * t); }};
            }};
}

TEST(Recipe, ASceneIsOneMoreInTheList) {
    std::vector<Scene> scenes = catalogue();
    scenes.push_back(turning_star()); // the line
    const std::array arguments{"my_scenes", "run", "turning-star", "--set", "steps=50"};
    EXPECT_EQ(scene_program("my_scenes", scenes, arguments.size(), arguments.data()), 0);
}
