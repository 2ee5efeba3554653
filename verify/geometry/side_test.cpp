// SPDX-License-Identifier: MIT
// The sides of the domain boundary at a vertex.
#include "dsc/geometry/side.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace dsc::side_test {
namespace {

template <class Real>
class Sides : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Sides, Reals);

template <class Real>
Point<Real> on_circle(double radius, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {static_cast<Real>(3 + radius * std::cos(angle)),
            static_cast<Real>(-2 + radius * std::sin(angle))};
}

TYPED_TEST(Sides, AnObliqueSideIsStraightUpToRounding) {
    using Real = TypeParam;
    int rounded = 0;
    for (int i = 1; i < 100; ++i) {
        const Point<Real> from(Real(0.1), Real(0.3));
        const Point<Real> to(Real(0.1 + 0.03 * i), Real(0.7 + 0.01 * i));
        const Point<Real> at = from + Real(0.37) * (to - from);
        EXPECT_EQ(side_at<Real>(from, at, to, false), Side::straight) << i;
        EXPECT_EQ(side_at<Real>(from, at, to, true), Side::straight) << i;
        EXPECT_TRUE(may_leave_side<Real>(from, at, to));
        rounded += orientation<Real>(from, at, to) != 0 ? 1 : 0;
    }
    EXPECT_GT(rounded, 50) << "the test has lost its point";
}

// The end of a curve that has slid along a side may come so near to a corner that the direction of
// the edge between them is rounding: it is no corner of its own.
TYPED_TEST(Sides, AnEdgeAsShortAsRoundingMakesNoCorner) {
    using Real = TypeParam;
    const Point<Real> corner(Real(0.6), Real(0.9));
    const Point<Real> far(Real(0.62), Real(0.88));
    const Real unit = std::numeric_limits<Real>::epsilon() * Real(0.5);
    int turns = 0;
    for (const Real x : {-2 * unit, unit, 2 * unit}) {
        for (const Real y : {-2 * unit, unit, 2 * unit}) {
            const Point<Real> end = corner + Point<Real>(x, y);
            EXPECT_EQ(side_at<Real>(corner, end, far, false), Side::straight);
            EXPECT_TRUE(may_leave_side<Real>(corner, end, far));
            turns += turns_less<Real>(corner, end, far, Real(0.7)) ? 0 : 1;
        }
    }
    EXPECT_GT(turns, 2) << "the test has lost its point";
}

TYPED_TEST(Sides, AMarkedTurnIsAFeatureFromTwelveDegreesOnAnotherFromFortyFive) {
    using Real = TypeParam;
    const auto side = [](double degrees, bool is_marked) {
        return side_at<Real>(on_circle<Real>(1, 0), on_circle<Real>(1, degrees),
                             on_circle<Real>(1, 2 * degrees), is_marked);
    };
    EXPECT_EQ(side(11.9, true), Side::curved);
    EXPECT_EQ(side(12.1, true), Side::feature);
    EXPECT_EQ(side(44.9, false), Side::curved);
    EXPECT_EQ(side(45.1, false), Side::feature);
    EXPECT_EQ(side_at<Real>({0, 0}, {1, 0}, {Real(0.5), Real(1e-3)}, false), Side::feature)
        << "a spike";
    EXPECT_FALSE(may_leave_side<Real>({0, 0}, {1, 0}, {1, 1}));
}

// A circular side that turns left, and one that turns right.
TYPED_TEST(Sides, PlacesOnACurvedSideLieOnItsCircle) {
    using Real = TypeParam;
    const Real slack = 64 * std::numeric_limits<Real>::epsilon();
    for (const double way : {1.0, -1.0}) {
        const auto from = on_circle<Real>(0.7, 40);
        const auto at = on_circle<Real>(0.7, 40 + way * 3);
        const auto to = on_circle<Real>(0.7, 40 + way * 9);
        const Real chord = distance<Real>(from, to);
        for (const double share : {0.0, 0.2, 0.5, 0.9, 1.0}) {
            const Point<Real> place =
                point_of_side<Real>(from, at, to, static_cast<Real>(share) * chord);
            EXPECT_NEAR(distance<Real>(place, {3, -2}), 0.7, slack) << share;
            EXPECT_NEAR(distance<Real>(from, place), 0,
                        1.01 * share * static_cast<double>(chord) + static_cast<double>(slack));
        }
        const Point<Real> middle = middle_of_side<Real>(from, at, to, false);
        EXPECT_NEAR(distance<Real>(middle, on_circle<Real>(0.7, 40 + way * 6)), 0, slack);
        const Point<Real> tangent = tangent_of_side<Real>(from, at, to);
        EXPECT_NEAR(tangent.dot(at - Point<Real>(3, -2)), 0, slack);
    }
}

TYPED_TEST(Sides, AVertexLeavesACurvedSideWithinTheDeviation) {
    using Real = TypeParam;
    const auto may_leave = [](double first, double second) {
        return may_leave_side<Real>(on_circle<Real>(1, 0), on_circle<Real>(1, first),
                                    on_circle<Real>(1, first + second));
    };
    EXPECT_TRUE(may_leave(1, 8)) << "0.008 of the edge that is left";
    EXPECT_FALSE(may_leave(6, 6)) << "0.026 of it";
}

} // namespace
} // namespace dsc::side_test
