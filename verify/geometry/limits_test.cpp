// SPDX-License-Identifier: MIT
// Formulas where something is zero, or exactly as large as something else.
#include "dsc/geometry/points.h"
#include "dsc/initial/initial_complex.h"

#include <gtest/gtest.h>

namespace dsc::limits_test {
namespace {

TEST(Limits, ASegmentOfNoLengthIsItsFirstEnd) {
    const Point<double> a(1, 2);
    const Point<double> p(4, 6);
    EXPECT_EQ(nearest_fraction<double>(p, a, a), 0);
    EXPECT_EQ(nearest_point<double>(p, a, a), a);
    EXPECT_EQ(squared_distance<double>(p, a, a), 25);
    EXPECT_EQ(distance<double>(p, a, a), 5);
}

TEST(Limits, CurvatureOfPointsThatCoincideIsZero) {
    const Point<double> a(0, 0);
    const Point<double> b(1, 0);
    EXPECT_EQ(curvature<double>(a, a, b), 0);
    EXPECT_EQ(curvature<double>(a, b, b), 0);
    EXPECT_EQ(curvature<double>(a, b, a), 0);
    EXPECT_NEAR(curvature<double>({0.01, 0}, {0, 0.01}, {-0.01, 0}), 100, 1e-9);
}

TEST(Limits, ABoxAsFarAwayAsItIsLargeHasItsCornerAsTheOrigin) {
    EXPECT_EQ(choose_frame({1, 0}, {2, 1}).origin, Point<double>(1, 0));
    EXPECT_EQ(choose_frame({-2, 0}, {-1, 1}).origin, Point<double>(-1, 0));
    EXPECT_EQ(choose_frame({0.5, 0}, {1.5, 1}).origin, Point<double>(0, 0));
}

} // namespace
} // namespace dsc::limits_test
