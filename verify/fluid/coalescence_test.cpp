// SPDX-License-Identifier: MIT
// Hopper's exact solution, and the scene that follows it.
#include "measures/mesh_quality.h"
#include "scenes/catalogue/catalogue.h"
#include "scenes/catalogue/coalescence.h"
#include "scenes/run/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc::scenes::coalescence_test {
namespace {

using std::numbers::pi;

// How fast the poles of the map move: the mean over the unit circle of the reciprocal of its slope,
// weighted by Poisson's kernel at them.
double rate_by_the_map(double m) {
    constexpr int count = 2000;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * pi * (i + 0.5) / count;
        const double kernel = (1 - m) / (1 - 2 * std::sqrt(m) * std::cos(angle) + m);
        const double slope = (1 - m * m) / std::sqrt(1 + m * m) *
                             std::sqrt(1 + 2 * m * std::cos(2 * angle) + m * m) /
                             (1 - 2 * m * std::cos(2 * angle) + m * m);
        sum += kernel / slope / count;
    }
    return m * sum;
}

TEST(Coalescence, TimesAgreeWithTheConformalMap) {
    for (const double m : {0.1, 0.3, 0.5, 0.7}) {
        constexpr double step = 1e-3;
        const double rate = 2 * step / (coalescing_time(m - step) - coalescing_time(m + step));
        EXPECT_NEAR(rate / rate_by_the_map(m), 1, 1e-4) << "m = " << m;
        EXPECT_NEAR(coalescing_at_time(coalescing_time(m)), m, 1e-9);
        EXPECT_NEAR(coalescing_at_neck(coalescing_neck(m)), m, 1e-12);
    }
}

// Integrated by a library, in 30 digits.
TEST(Coalescence, TimesOfNecksAreThoseOfAnotherQuadrature) {
    const auto time_at = [](double neck) { return coalescing_time(coalescing_at_neck(neck)); };
    EXPECT_NEAR(time_at(0.0743), 0.0450923966849328, 1e-13);
    EXPECT_NEAR(time_at(0.2458), 0.199785417888417, 1e-13);
    EXPECT_NEAR(time_at(0.8955), 1.98422189775172, 1e-12);
}

TEST(Coalescence, OutlinesHaveTheAreaOfTheDisc) {
    for (const double m : {0.1, 0.5, 0.9}) {
        constexpr int count = 20000;
        double area = 0;
        for (int i = 0; i < count; ++i) {
            const Point<double> a = coalescing_outline(m, 2 * pi * i / count);
            const Point<double> b = coalescing_outline(m, 2 * pi * (i + 1) / count);
            area += (a.x() * b.y() - a.y() * b.x()) / 2;
        }
        EXPECT_NEAR(area, pi, 1e-4);
        EXPECT_NEAR(coalescing_outline(m, 0).x(), coalescing_neck(m), 1e-12);
    }
}

// From a notch whose tip has a radius of 2e-4.
TEST(Coalescence, TheSceneHasTheExactNeck) {
    const Scene& scene = find_scene("coalescing-cylinders");
    Parameters parameters = scene.defaults;
    apply_setting(parameters, scene.keys, "h=0.08");
    apply_setting(parameters, scene.keys, "dt=0.1");
    RunOptions options;
    double smallest_angle = 180;
    options.observer = [&](int, const Complex<double>& complex) {
        smallest_angle = std::min(smallest_angle, measure_quality(complex).min_angle_deg);
    };
    const RunResult result = run_scene(scene, parameters, options);
    EXPECT_TRUE(result.holds());
    EXPECT_LT(number(result.fluid, "neck_error"), 5e-3);
    EXPECT_GT(smallest_angle, 12);
}

} // namespace
} // namespace dsc::scenes::coalescence_test
