// SPDX-License-Identifier: MIT
// Hopper's exact solution. The gate holds the scene to it.
#include "scenes/catalogue/coalescence.h"

#include <gtest/gtest.h>

#include <numbers>

namespace dsc::scenes::coalescence_test {
namespace {

using std::numbers::pi;

// Reference values, integrated by a library in 30 digits.
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
        EXPECT_NEAR(coalescing_at_neck(coalescing_neck(m)), m, 1e-12);
        EXPECT_NEAR(coalescing_at_time(coalescing_time(m)), m, 1e-9);
    }
}

} // namespace
} // namespace dsc::scenes::coalescence_test
