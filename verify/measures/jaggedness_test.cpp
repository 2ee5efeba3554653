// SPDX-License-Identifier: MIT
// Turning angles, and cases that easily deceive a measure of smoothness.
#include "dsc/base/error.h"
#include "flows/exact.h"
#include "measures/jaggedness.h"
#include "shapes/curve.h"
#include "shapes/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace dsc::scenes::jaggedness_test {
namespace {

using std::numbers::pi;

double degrees(double radians) { return radians * 180.0 / pi; }

Jaggedness jaggedness(const Outline& polygon, const Outline& exact) {
    return measure_jaggedness(std::span(&polygon, 1), std::span(&exact, 1));
}

std::size_t index_of(const Outline& outline, const Point<double>& p) {
    return static_cast<std::size_t>(std::min_element(outline.begin(), outline.end(),
                                                     [&](const auto& s, const auto& t) {
                                                         return (s - p).norm() < (t - p).norm();
                                                     }) -
                                    outline.begin());
}

TEST(Jaggedness, OfAnInscribedPolygonIsThatOfTheCircle) {
    // Vertices at very unequal distances on a circle: the turn at each is half the sum of the two
    // central angles beside it, and so is that of its projections.
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> gap(0.02, 0.3);
    std::vector<double> angles{0.0};
    while (angles.back() < 2.0 * pi - 0.4) {
        angles.push_back(angles.back() + gap(random));
    }
    Outline polygon;
    for (const double angle : angles) {
        polygon.emplace_back(0.5 + 0.3 * std::cos(angle), 0.4 + 0.3 * std::sin(angle));
    }
    const ExactShape exact = exact_circle({0.5, 0.4}, 0.3);
    const Jaggedness j = jaggedness(polygon, exact.outlines.front());
    EXPECT_LT(j.largest_excess_deg, -2.0);
}

/// The unit square with edges of 0.1.
Outline fine_square() { return rectangle({0, 0}, {1, 1}, 0.1); }
const Outline plain_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(Jaggedness, FindsATooth) {
    Outline polygon = fine_square();
    const std::size_t tooth = index_of(polygon, {0.5, 0});
    polygon[tooth].y() -= 0.1 * std::tan(1.5 * pi / 180);
    const Jaggedness j = jaggedness(polygon, plain_square);
    EXPECT_EQ(j.worst, polygon[tooth]);
    EXPECT_NEAR(j.largest_excess_deg, 1.0, 1e-9);
}

TEST(Jaggedness, CornersOfTheExactShapeAreNone) {
    for (const double h : {0.004, 0.01, 0.024}) {
        const Outline exact = unmoved_shape(slotted_disc_curve({})).outlines.front();
        const Outline polygon = slotted_disc({}, h);
        EXPECT_LE(jaggedness(polygon, exact).largest_excess_deg, 0);
        // Without its corner vertices, the polygon has two turns instead of one at each corner.
        Outline cut;
        const auto corners = slot_corners({});
        for (const Point<double>& p : polygon) {
            if (std::find(corners.begin(), corners.end(), p) == corners.end()) {
                cut.push_back(p);
            }
        }
        EXPECT_LE(jaggedness(cut, exact).largest_excess_deg, 0);
    }
}

TEST(Jaggedness, AFoldExcusesNothing) {
    Outline polygon = fine_square();
    const std::size_t i = index_of(polygon, {0.5, 0});
    std::swap(polygon[i], polygon[i + 1]);
    const Jaggedness j = jaggedness(polygon, plain_square);
    EXPECT_NEAR(j.largest_excess_deg, 178.0, 1e-9);
    // The fold is beside a corner, at a distance shorter than the fold is long, but does not
    // contain it.
    const Outline beside{{0, 0}, {0.5, 0}, {0.15, 0}, {0.6, 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_NEAR(jaggedness(beside, plain_square).largest_excess_deg, 178.0, 1e-9);
}

TEST(Jaggedness, TheFarSideOfAFilamentExcusesNothing) {
    // Every other vertex of the lower side is nearer to the upper side.
    const Outline exact = rectangle({0, 0}, {1, 0.004}, 0.001);
    Outline polygon = rectangle({0, 0}, {1, 0.004}, 0.05);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point<double> p = polygon[i];
        if (p.y() == 0.0 && p.x() > 0.0 && p.x() < 1.0) {
            polygon[i].y() = i % 2 == 0 ? 0.003 : 0.0;
        }
    }
    const Jaggedness j = jaggedness(polygon, exact);
    EXPECT_NEAR(j.largest_excess_deg, 2.0 * degrees(std::atan(0.06)) - 2.0, 1e-6);
}

TEST(Jaggedness, OfNothing) {
    const Outline one = fine_square();
    EXPECT_EQ(measure_jaggedness({}, std::span(&one, 1)).largest_excess_deg, -INFINITY);
    EXPECT_EQ(measure_jaggedness(std::span(&one, 1), {}).largest_excess_deg, -INFINITY);
    const Outline bad{{0, 0}, {1, 0}, {NAN, 1}};
    EXPECT_THROW((void)jaggedness(bad, one), InputError);
    EXPECT_THROW((void)jaggedness(one, {{0, 0}, {1, 0}}), InputError);
}

} // namespace

} // namespace dsc::scenes::jaggedness_test
