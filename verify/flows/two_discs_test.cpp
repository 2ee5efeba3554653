// SPDX-License-Identifier: MIT
// Two discs that grow, merge and shrink, against an area that is found from distances alone.
#include "flows/two_discs.h"

#include "dsc/base/error.h"
#include "measures/symmetric_difference.h"
#include "support/outline_testing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace dsc::scenes::two_discs_test {
namespace {

using std::numbers::pi;

// The area of the points of the union that are farther than `shrinkage` from its complement. By
// columns of half the height, whose end is found by bisection; the distance is that to the nearest
// of many points of the union's outline. No formula for a neck.
double area_by_distances(double half_distance, double radius, double shrinkage) {
    constexpr int columns = 200;
    constexpr int places = 4000;
    const auto is_in_union = [=](double x, double y) {
        return std::hypot(std::abs(x) - half_distance, y) <= radius;
    };
    std::vector<Point<double>> outline{
        {0, std::sqrt(radius * radius - half_distance * half_distance)}};
    outline.emplace_back(-outline.front());
    for (int i = 0; i < places; ++i) {
        const double angle = 2 * pi * i / places;
        const double x = half_distance + radius * std::cos(angle);
        if (x > 0) { // otherwise it lies in the other disc
            outline.emplace_back(x, radius * std::sin(angle));
        }
    }
    const auto is_inside = [&](double x, double y) {
        return is_in_union(x, y) && std::ranges::all_of(outline, [&](const Point<double>& place) {
                   return std::hypot(place.x() - x, place.y() - y) >= shrinkage;
               });
    };
    // Substituted so that the columns are dense where the outline is steep.
    const double end = half_distance + radius - shrinkage;
    double sum = 0;
    for (int i = 0; i < columns; ++i) {
        const double t = pi / 2 * (i + 0.5) / columns;
        const double x = end * std::sin(t);
        double low = 0;
        double high = radius;
        for (int k = 0; k < 40; ++k) {
            const double middle = (low + high) / 2;
            (is_inside(x, middle) ? low : high) = middle;
        }
        sum += low * end * std::cos(t) * (pi / 2 / columns);
    }
    return 4 * sum;
}

TEST(TwoDiscs, HaveTheAreaThatFollowsFromDistances) {
    const TwoDiscs discs;
    for (const double shrinkage : {0.0, 0.05, 0.1, 0.15, 0.17}) {
        const double area = shrunk_discs(discs, 0.1, shrinkage).area;
        EXPECT_NEAR(area / area_by_distances(0.125, 0.2, shrinkage), 1, 1e-4) << shrinkage;
    }
    EXPECT_NEAR(grown_discs(discs, 0.1).area, 0.2187055, 1e-7);
    EXPECT_NEAR(shrunk_discs(discs, 0.1, 0.1).area, 0.07044716, 1e-8);
    EXPECT_NEAR(neck_width(discs, 0.1, 0.1), 0.112, 5e-4);
}

TEST(TwoDiscs, HaveOutlinesOfThatArea) {
    // At any place and in any direction.
    const TwoDiscs discs{.first = {0.3, 0.2}, .second = {0.45, 0.4}, .radius = 0.1};
    for (const double growth : {-0.02, 0.0, 0.02, 0.0249, 0.0251, 0.1}) {
        for (const double shrinkage : {0.0, 0.01, 0.07, 0.1, 0.155, 0.157, 0.19}) {
            const ExactShape shape = shrunk_discs(discs, growth, shrinkage);
            EXPECT_NEAR(signed_area(shape.outlines), shape.area, shape.own_error + 1e-15)
                << growth << ", " << shrinkage;
            EXPECT_LT(shape.own_error, 1e-7);
            EXPECT_TRUE(test::is_simple(shape.outlines));
        }
    }
}

TEST(TwoDiscs, MergeAndPart) {
    const TwoDiscs discs; // they touch at a growth of 0.025
    EXPECT_EQ(grown_discs(discs, 0.0249).outlines.size(), 2U);
    EXPECT_EQ(grown_discs(discs, 0.0251).outlines.size(), 1U);
    const double parting = std::sqrt(0.2 * 0.2 - 0.125 * 0.125);
    EXPECT_NEAR(parting, 0.15612, 1e-5);
    EXPECT_EQ(shrunk_discs(discs, 0.1, parting - 1e-4).outlines.size(), 1U);
    EXPECT_EQ(shrunk_discs(discs, 0.1, parting + 1e-4).outlines.size(), 2U);
    EXPECT_LT(neck_width(discs, 0.1, parting + 1e-4), 0);
    EXPECT_TRUE(shrunk_discs(discs, 0.1, 0.2).outlines.empty());
    EXPECT_EQ(shrunk_discs(discs, 0.1, 0.2).area, 0);
    // What one growth and shrinkage add is only what has merged.
    const double before = grown_discs(discs, 0).area;
    EXPECT_NEAR(shrunk_discs(discs, 0.02, 0.02).area, before, 1e-15);
    EXPECT_GT(shrunk_discs(discs, 0.1, 0.1).area, before + 1e-3);
}

TEST(TwoDiscs, RefuseWhatIsNoShape) {
    const TwoDiscs discs;
    EXPECT_THROW((void)grown_discs(discs, -0.1), InputError);
    EXPECT_THROW((void)grown_discs(discs, NAN), InputError);
    EXPECT_THROW((void)shrunk_discs(discs, 0.1, -0.01), InputError);
    EXPECT_THROW((void)shrunk_discs(discs, 0.1, INFINITY), InputError);
    EXPECT_THROW((void)grown_discs({.second = {0.375, 0.5}}, 0.1), InputError);
}

} // namespace

} // namespace dsc::scenes::two_discs_test
