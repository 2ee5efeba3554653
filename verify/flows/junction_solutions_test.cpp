// SPDX-License-Identifier: MIT
// Exact solutions with junctions, each against a computation that is independent of its formulas.
#include "flows/junction_solutions.h"

#include "dsc/base/error.h"
#include "measures/symmetric_difference.h"
#include "support/outline_testing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dsc::scenes::junction_solutions_test {
namespace {

using std::numbers::pi;

double degrees(double angle) { return angle * pi / 180; }

// --- the lens -----------------------------------------------------------------------------------

// The length of a lens of two arcs, whose tangents at the tips make this angle with the interface,
// minus the length of interface between the tips.
double length_of_lens(double area, double angle) {
    const double radius = std::sqrt(area / (2 * angle - std::sin(2 * angle)));
    return 4 * radius * angle - 2 * radius * std::sin(angle);
}

TEST(Lens, IsTheShortestOneOfItsArea) {
    constexpr double area = 0.05;
    const Lens lens{.centre = {0.3, -2}, .axis = {3, 4}, .area = area};
    const ExactShape shape = lens_shape(lens);
    // The lens replaces the interface between its tips, which are sqrt(3) radii apart.
    const double tip_to_tip = std::sqrt(3 * area / (2 * pi / 3 - std::sqrt(3) / 2));
    const double length = perimeter(shape.outlines) - tip_to_tip;
    EXPECT_NEAR(length, length_of_lens(area, pi / 3), 1e-8);
    for (const double away : {-0.01, 0.01}) {
        EXPECT_LT(length, length_of_lens(area, pi / 3 + away) - 1e-6);
    }
    EXPECT_DOUBLE_EQ(shape.area, area);
    EXPECT_NEAR(signed_area(shape.outlines), area, shape.own_error + 1e-15);
    EXPECT_LT(shape.own_error, 1e-8);
    EXPECT_TRUE(test::is_simple(shape.outlines));
}

// --- four sectors -------------------------------------------------------------------------------

// Integrates the self-similar curve by arc length, in long double, and returns its last direction.
// The curve moves at the speed of its curvature and stays similar to itself, so its curvature is
// (position . normal) / 2.
double last_direction(long double factor) {
    using State = std::array<long double, 3>; // x, y, direction
    const auto rate = [](const State& s) -> State {
        const long double c = std::cos(s[2]);
        const long double d = std::sin(s[2]);
        return {c, d, (-s[0] * d + s[1] * c) / 2};
    };
    State s{factor / 2, 0, std::numbers::pi_v<long double> / 3};
    constexpr int count = 40000;
    constexpr long double length = 20.0L / count;
    for (int i = 0; i < count; ++i) {
        // Heun's third-order method.
        const State a = rate(s);
        State at = s;
        for (std::size_t k = 0; k < 3; ++k) {
            at[k] = s[k] + length / 3 * a[k];
        }
        const State b = rate(at);
        for (std::size_t k = 0; k < 3; ++k) {
            at[k] = s[k] + 2 * length / 3 * b[k];
        }
        const State c = rate(at);
        for (std::size_t k = 0; k < 3; ++k) {
            s[k] += length / 4 * (a[k] + 3 * c[k]);
        }
    }
    return static_cast<double>(s[2]);
}

TEST(FourSectors, OpenAtTheKnownRates) {
    EXPECT_NEAR(opening_factor(degrees(45)), 0.77081, 5e-6);
    EXPECT_NEAR(opening_factor(degrees(40)), 1.08572, 5e-6);
    EXPECT_NEAR(opening_factor(degrees(30)), 1.87560, 5e-6);
    double before = INFINITY;
    for (const double theta : {1.0, 10.0, 20.0, 30.0, 50.0, 59.0, 59.999}) {
        const double factor = opening_factor(degrees(theta));
        EXPECT_LT(factor, before);
        before = factor;
        EXPECT_NEAR(last_direction(factor), degrees(theta), 1e-10) << theta;
    }
    EXPECT_LT(before, 1e-4) << "nothing drives it at 60 degrees";
}

const Rectangle box{{0.2, 0.1}, {1.1, 0.8}};

// The area that the sector loses: the normal of each of its two convex curves turns by pi / 3 -
// theta.
TEST(FourSectors, TheRightOneLosesAreaAtTheRateOfItsTurn) {
    for (const double theta : {20.0, 45.0, 55.0}) {
        const FourSectors sectors{.theta = degrees(theta)};
        const ExactShape first = right_sector(sectors, 0, box);
        EXPECT_NEAR(signed_area(first.outlines), first.area, 1e-15);
        for (const double time : {1e-6, 1e-4, 3e-4}) {
            const ExactShape shape = right_sector(sectors, time, box);
            EXPECT_NEAR(first.area - shape.area, 2 * (pi / 3 - degrees(theta)) * time, 1e-12)
                << theta << ", " << time;
            EXPECT_NEAR(signed_area(shape.outlines), shape.area, shape.own_error);
            EXPECT_LT(shape.own_error, 1e-9);
            EXPECT_TRUE(test::is_simple(shape.outlines));
            EXPECT_NEAR(shape.outlines.front().front().x(),
                        0.5 + opening_factor(degrees(theta)) / 2 * std::sqrt(time), 1e-15);
        }
    }
}

TEST(FourSectors, RefuseATimeWhenTheJunctionHasLeftTheBox) {
    EXPECT_THROW((void)right_sector({}, 9, box), InputError);
}

} // namespace

} // namespace dsc::scenes::junction_solutions_test
