// SPDX-License-Identifier: MIT
// The frame of a box: conversion is exact in both directions for all points of the box.
#include "dsc/initial/initial_complex.h"

#include "support/frame_testing.h"
#include "support/random/scene.h"

#include "dsc/base/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dsc::frame_test {
namespace {

TEST(Frames, BringsTheLargerSideToOneToTwo) {
    test::Dice dice(3);
    for (int i = 0; i < 1000; ++i) {
        const double size = std::pow(10.0, dice.in(-280.0, 280.0));
        const Point<double> low = size * dice.in(-3.0, 3.0) * Point<double>(1, dice.in(-1.0, 1.0));
        const Point<double> high = low + size * Point<double>(1, dice.in(0.1, 1.0));
        const Frame frame = choose_frame(low, high);
        const double unit = (high - low).maxCoeff() / frame.unit;
        EXPECT_GE(unit, 1) << size;
        EXPECT_LT(unit, 2) << size;
    }
}

TEST(Frames, IsExactBothWaysForPointsOfTheBox) {
    test::Dice dice(5);
    int shifted = 0;
    for (int i = 0; i < 2000; ++i) {
        // Boxes at the origin, far from it, and around it.
        const double size = std::pow(10.0, dice.in(-140.0, 140.0));
        const double away = dice.chance(0.5) ? dice.in(-3.0, 3.0) : dice.in(-1e9, 1e9);
        const Point<double> low = size * away * Point<double>(1, dice.in(-1.0, 1.0));
        const Point<double> high = low + Point<double>(size, size);
        const Frame frame = choose_frame(low, high);
        shifted += frame.origin.x() != 0 ? 1 : 0;
        for (int k = 0; k < 10; ++k) {
            const Point<double> p(
                std::clamp(low.x() + size * dice.in(0.0, 1.0), low.x(), high.x()),
                std::clamp(low.y() + size * dice.in(0.0, 1.0), low.y(), high.y()));
            const Point<double> unit = test::to_frame(frame, p);
            EXPECT_EQ(test::to_world(frame, unit), p);
            // The difference is exact: it is the same when computed in more digits.
            for (int axis = 0; axis < 2; ++axis) {
                const long double exact = static_cast<long double>(p[axis]) - frame.origin[axis];
                EXPECT_EQ(static_cast<long double>(frame.unit * unit[axis]), exact);
            }
        }
    }
    EXPECT_GT(shifted, 500);
    EXPECT_LT(shifted, 2000);
}

TEST(Frames, RefusesWhatIsNoBox) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW((void)choose_frame({0, 0}, {0, 1}), InputError);
    EXPECT_THROW((void)choose_frame({0, 1}, {1, 0}), InputError);
    EXPECT_THROW((void)choose_frame({nan, 0}, {1, 1}), InputError);
    EXPECT_THROW((void)choose_frame({0, 0}, {infinity, 1}), InputError);
    EXPECT_THROW((void)choose_frame({0, 0}, {nan, 1}), InputError);
    EXPECT_THROW((void)choose_frame({0, 0}, {1e-291, 1e-291}), InputError);
    EXPECT_THROW((void)choose_frame({-1e308, 0}, {1e308, 1}), InputError);
}

TEST(Frames, ABoxAsFarAwayAsItIsLargeHasItsCornerAsTheOrigin) {
    EXPECT_EQ(choose_frame({1, 0}, {2, 1}).origin, Point<double>(1, 0));
    EXPECT_EQ(choose_frame({-2, 0}, {-1, 1}).origin, Point<double>(-1, 0));
    EXPECT_EQ(choose_frame({0.5, 0}, {1.5, 1}).origin, Point<double>(0, 0));
}

} // namespace
} // namespace dsc::frame_test
