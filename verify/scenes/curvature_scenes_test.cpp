// SPDX-License-Identifier: MIT
// The scenes of curvature flow against their closed forms.
#include "scenes/catalogue/catalogue.h"
#include "scenes/run/run.h"
#include "shapes/shapes.h"

#include "dsc/base/error.h"
#include "dsc/queries/phases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dsc::scenes::curvature_scenes_test {
namespace {

using std::numbers::pi;

// The relative error of the radius, by area, at half of the first area.
double error_of_circle(double h, Strategy strategy = Strategy::sequential) {
    const Scene& scene = find_scene("curvature-circle");
    Parameters parameters = scene.defaults;
    parameters.h = h;
    RunOptions options;
    options.strategy = strategy;
    const RunResult result = run_scene(scene, parameters, options);
    EXPECT_TRUE(result.holds());
    EXPECT_LT(number(result.last, "sd_rel"), 2 * h * h);
    return std::sqrt(number(result.last, "area") / number(result.last, "area_exact")) - 1;
}

TEST(CurvatureScenes, TheCircleHasItsRadiusAtHalfItsAreaToSecondOrder) {
    const double coarse = std::abs(error_of_circle(0.03));
    const double medium = std::abs(error_of_circle(0.015)); // a twentieth of the first radius
    const double fine = std::abs(error_of_circle(0.0075));
    EXPECT_LT(medium, 2e-4);
    EXPECT_GT(std::log2(coarse / medium), 1.9) << coarse << ", " << medium;
    EXPECT_GT(std::log2(medium / fine), 1.9) << medium << ", " << fine;
    EXPECT_NEAR(std::abs(error_of_circle(0.015, Strategy::cells)), medium, 1e-5);
}

// Grayson's theorem: one piece at all times, whose area falls at the rate 2 pi.
TEST(CurvatureScenes, TheDumbbellStaysInOnePieceAndLosesTwoPiOfAreaPerTime) {
    for (const Strategy strategy : {Strategy::sequential, Strategy::cells, Strategy::active}) {
        SCOPED_TRACE(to_string(strategy));
        const Scene& scene = find_scene("curvature-dumbbell");
        const double dt = scene.prepare(scene.defaults).dt;
        const double first_area = dumbbell_area({});
        RunOptions options;
        options.strategy = strategy;
        options.observer = [&](int step, const Complex<double>& complex) {
            ASSERT_EQ(interface_curves(complex).size(), 1U) << "after step " << step;
            const double exact = first_area - 2 * pi * step * dt;
            ASSERT_NEAR(phase_area(complex, 1), exact, 0.003 * first_area) << "after step " << step;
        };
        const RunResult result = run_scene(scene, scene.defaults, options);
        EXPECT_TRUE(result.holds());
        EXPECT_NEAR(number(result.last, "area_exact"), 0.01 * first_area, 1e-12);
    }
}

TEST(CurvatureScenes, AreNotForTheReference) {
    RunOptions options;
    options.strategy = Strategy::reference;
    const Scene& scene = find_scene("curvature-circle");
    try {
        (void)run_scene(scene, scene.defaults, options);
        FAIL() << "nothing was thrown";
    } catch (const InputError& error) {
        EXPECT_EQ(error.where(), "--strategy"); // rather than an error about a missing velocity
    }
}

} // namespace
} // namespace dsc::scenes::curvature_scenes_test
