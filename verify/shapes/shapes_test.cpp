// SPDX-License-Identifier: MIT
// Outlines and the shapes of the scenes: areas in closed form, and corners at the given points.
#include "dsc/base/error.h"
#include "measures/symmetric_difference.h"
#include "shapes/shapes.h"
#include "support/outline_testing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace dsc::scenes::shapes_test {
namespace {

using std::numbers::pi;
using test::transformed;

OverlapAreas areas_of(const Outline& p, const Outline& q, FillRule rule = FillRule::even_odd) {
    return overlap_areas({std::span(&p, 1), rule}, {std::span(&q, 1), rule});
}

TEST(Outline, AreaDoesNotLoseDigitsFarFromTheOrigin) {
    const Outline near = transformed(circle({0.0, 0.0}, 0.5, 0.01), 1.0, {0.0, 0.0});
    Outline grid = near; // coordinates to which the offset is added exactly
    for (Point<double>& p : grid) {
        p = {std::round(std::ldexp(p.x(), 20)) * 0x1p-20,
             std::round(std::ldexp(p.y(), 20)) * 0x1p-20};
    }
    const Outline far = transformed(grid, 1.0, {0x1p30, -0x1p31});
    EXPECT_EQ(signed_area(far), signed_area(grid));
    EXPECT_EQ(signed_area(reversed(grid)), -signed_area(grid));
    EXPECT_NEAR(signed_area(near), 0.5 * 315 * 0.25 * std::sin(2.0 * pi / 315), 1e-16);
}

void expect_sound(const Outline& outline, double edge_length, double area, double tolerance) {
    EXPECT_TRUE(test::is_simple(outline));
    EXPECT_LE(test::longest_edge(outline), edge_length * (1.0 + 1e-12));
    EXPECT_NEAR(signed_area(outline), area, tolerance);
}

TEST(Shapes, KeepTheirAreaCornersAndEdgeLength) {
    const Outline round = circle({0.5, 0.75}, 0.15, 0.0196);
    EXPECT_EQ(round.size(), 49U);
    expect_sound(round, 0.0196, pi * 0.15 * 0.15, 3e-4);
    EXPECT_EQ(circle({0, 0}, 1.0, 100.0).size(), 13U);
    for (const Point<double>& p : round) {
        EXPECT_NEAR(std::hypot(p.x() - 0.5, p.y() - 0.75), 0.15, 1e-16);
    }
    expect_sound(rectangle({1, 2}, {4, 3}, 0.3), 0.3, 3.0, 1e-15);

    const SlottedDisc disc;
    const Outline zalesak = slotted_disc(disc, 1e-3);
    expect_sound(zalesak, 1e-3, slotted_disc_area(disc), 1e-6);
    for (const Point<double>& corner :
         {Point<double>{0.475, 0.85}, {0.525, 0.85}, {0.475, slot_corners(disc)[0].y()}}) {
        EXPECT_EQ(std::count(zalesak.begin(), zalesak.end(), corner), 1) << corner.transpose();
    }
    const std::vector<Outline> slot_alone{circle({0.5, 0.75}, 0.15, 1e-4),
                                          rectangle({0.475, 0.55}, {0.525, 0.85}, 1.0)};
    const OverlapAreas cut =
        overlap_areas({std::span(slot_alone).first(1)}, {std::span(slot_alone).last(1)});
    EXPECT_NEAR(cut.only_first, slotted_disc_area(disc), 6e-9);

    const Crescent moon{{1, 2}, 1.0, {1.5, 2.5}, 0.8};
    const OverlapAreas bitten = areas_of(circle({1, 2}, 1.0, 1e-4), circle({1.5, 2.5}, 0.8, 1e-4));
    expect_sound(crescent(moon, 1e-3), 1e-3, bitten.only_first, 1e-6);

    expect_sound(star({0, 0}, 1.0, 0.4, 5, 0.05), 0.05, 5 * 0.4 * std::sin(pi / 5), 1e-14);
    EXPECT_THROW((void)circle({0, 0}, -1.0, 0.1), InputError);
    EXPECT_THROW((void)circle({0, 0}, 1.0, NAN), InputError);
    EXPECT_THROW((void)slotted_disc({.slot_width = 0.4}, 0.1), InputError);
    EXPECT_THROW((void)crescent({{0, 0}, 1.0, {3, 0}, 1.0}, 0.1), InputError);
}

} // namespace

} // namespace dsc::scenes::shapes_test
