// SPDX-License-Identifier: MIT
// The formulas of lib/dsc/geometry: distances to segments, turns, the polynomial, circles; variants
// of a formula with different rounding agree.
#include "dsc/geometry/points.h"
#include "dsc/geometry/predicates.h"
#include "dsc/geometry/triangle.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace dsc::formulas_test {
namespace {

using P = Point<double>;

class Dice {
public:
    P point() { return {uniform_(random_), uniform_(random_)}; }

private:
    std::mt19937 random_{7};
    std::uniform_real_distribution<double> uniform_{-1, 1};
};

TEST(Distance, ToASegmentIsTheLeastOverItsPoints) {
    Dice dice;
    for (int i = 0; i < 200; ++i) {
        const P p = dice.point();
        const P a = dice.point();
        const P b = dice.point();
        double smallest = std::numeric_limits<double>::infinity();
        constexpr int samples = 2000;
        for (int k = 0; k <= samples; ++k) {
            smallest =
                std::min(smallest, (a + (b - a) * (static_cast<double>(k) / samples) - p).norm());
        }
        EXPECT_NEAR(distance<double>(p, a, b), smallest, 2e-3);
        EXPECT_LE(distance<double>(p, a, b), smallest + 1e-15);
        EXPECT_NEAR(std::sqrt(squared_distance<double>(p, a, b)), distance<double>(p, a, b), 1e-15);
        EXPECT_NEAR((nearest_point<double>(p, a, b) - p).norm(), distance<double>(p, a, b), 1e-15);
    }
    EXPECT_EQ(distance<double>(P(3, 4), P(0, 0), P(0, 0)), 5);
    EXPECT_EQ(squared_distance<double>(P(3, 4), P(0, 0), P(0, 0)), 25);
    EXPECT_EQ(nearest_fraction<double>(P(3, 4), P(0, 0), P(0, 0)), 0);
}

TEST(Distance, BesideALineKeepsItsDigits) {
    // The nearest point of the diagonal cannot be represented by doubles.
    const P a(0, 0);
    const P b(1, 1);
    const double above = std::nextafter(0.7, 1.0);
    const double step = above - 0.7;
    EXPECT_NEAR(distance<double>(P(0.7, above), a, b), step / std::numbers::sqrt2, 1e-6 * step);
}

TEST(Turn, HasTheAngleBetweenTheEdges) {
    for (int degrees = -170; degrees <= 170; degrees += 10) {
        const double angle = degrees * std::numbers::pi / 180;
        const P at(2, 1);
        const P from(2 - 3, 1);
        const P to = at + 0.5 * P(std::cos(angle), std::sin(angle));
        EXPECT_NEAR(turn_angle<double>(from, at, to), angle, 1e-15);
        const double size = std::abs(angle);
        EXPECT_TRUE(turns_less<double>(from, at, to, std::cos(size + 0.01)));
        EXPECT_FALSE(turns_less<double>(from, at, to, std::cos(std::max(0.0, size - 0.01))));
        EXPECT_FALSE(turns_more<double>(from, at, to, std::cos(size + 0.01)));
        if (degrees != 0) {
            EXPECT_TRUE(turns_more<double>(from, at, to, std::cos(size - 0.01)));
        }
    }
    EXPECT_FALSE(turns_less<double>(P(0, 0), P(0, 0), P(1, 0), 0.5));
    EXPECT_FALSE(turns_more<double>(P(0, 0), P(0, 0), P(1, 0), 0.5));
    // Lengths whose product of squares underflows.
    EXPECT_TRUE(turns_more<double>(P(0, 0), P(1e-100, 0), P(1e-100, 1e-100), 0.9));
}

TEST(Turn, CurvatureIsThatOfTheCircle) {
    const auto on_circle = [](double angle) {
        return P(5 + 0.25 * std::cos(angle), 0.25 * std::sin(angle));
    };
    EXPECT_NEAR(curvature<double>(on_circle(0.1), on_circle(0.4), on_circle(0.5)), 4, 1e-11);
    EXPECT_NEAR(curvature<double>(on_circle(0.5), on_circle(0.4), on_circle(0.1)), -4, 1e-11);
    for (const auto& [a, b, c] : {std::array{P(1, 1), P(1, 1), P(2, 1)},
                                  {P(1, 1), P(2, 1), P(2, 1)},
                                  {P(1, 1), P(2, 1), P(1, 1)}}) {
        EXPECT_EQ(curvature<double>(a, b, c), 0);
    }
}

TEST(Lagrange, ReproducesAPolynomialOfItsDegree) {
    const auto cubic = [](double t) { return P(2 * t * t * t - t, 1 - 3 * t + t * t); };
    const std::array<double, 4> knots{-1, 0, 0.75, 2};
    const std::array<P, 4> points{cubic(-1), cubic(0), cubic(0.75), cubic(2)};
    for (const double at : {-0.5, 0.25, 0.75, 1.5}) {
        for (const P& origin : {P(0, 0), points[1], P(30, -20)}) {
            const P value = lagrange<double>(points, knots, at, origin);
            EXPECT_NEAR((value - cubic(at)).norm(), 0, 1e-13);
        }
    }
    // Far from the origin of coordinates the result is as exact as a coordinate is.
    const P far(1e9, -1e9);
    std::array<P, 4> moved{};
    for (std::size_t i = 0; i < 4; ++i) {
        moved[i] = far + P(knots[i], 0);
    }
    EXPECT_EQ(lagrange<double>(moved, knots, 0.5, moved[1]), P(far + P(0.5, 0)));
}

TEST(Triangles, TheRoundingsOfEquationFourAgree) {
    Dice dice;
    for (int i = 0; i < 500; ++i) {
        const P a = dice.point();
        const P b = dice.point();
        const P c = dice.point();
        const double q = quality<double>(a, b, c);
        const double squared = q * std::abs(q);
        const double tolerance = 1e-12 * std::abs(squared);
        EXPECT_NEAR(4.0 / 3 * sine_squared<double>(a, b, c), squared, tolerance);
        EXPECT_NEAR(4.0 / 3 *
                        sine_squared_of_lanes<double>(b.x() - a.x(), b.y() - a.y(), c.x() - a.x(),
                                                      c.y() - a.y()),
                    squared, tolerance);
    }
    for (const double legs : {1.0, 1.25, 3.0, 100.0}) {
        const double q =
            quality<double>(P(-0.5, 0), P(0.5, 0), P(0, std::sqrt(legs * legs - 0.25)));
        EXPECT_NEAR(squared_quality_of_needle(legs * legs), q * q, 1e-14);
    }
    // This variant works at any scale.
    EXPECT_NEAR(sine_squared<double>(P(0, 0), P(1e-100, 0), P(0, 1e-100)), 0.5, 1e-15);
}

TEST(Triangles, TheCircumcentreIsAsFarFromAllCorners) {
    Dice dice;
    for (int i = 0; i < 200; ++i) {
        const P a = dice.point();
        const P b = dice.point();
        const P c = dice.point();
        const P centre = circumcentre<double>(a, b, c);
        const double radius = (centre - a).norm();
        const double tolerance = 1e-13 * radius * radius / std::abs(area<double>(a, b, c));
        EXPECT_NEAR((centre - b).norm(), radius, tolerance);
        EXPECT_NEAR((centre - c).norm(), radius, tolerance);
    }
    EXPECT_FALSE(circumcentre<double>(P(0, 0), P(1, 1), P(2, 2)).allFinite());
}

// The Delaunay test of one edge (b, w) in three ways: by angles, by the filtered and by the exact
// in-circle determinant.
TEST(Delaunay, TheTestsAgreeWhereTheAnswerIsClear) {
    Dice dice;
    int flips = 0;
    int checked = 0;
    for (int i = 0; i < 2000; ++i) {
        const P a = dice.point();
        const P b = dice.point();
        const P w = dice.point();
        const P d = dice.point();
        if (orientation(a, b, w) <= 0 || orientation(d, w, b) <= 0) {
            continue;
        }
        const bool inside = in_circle(a, b, w, d) > 0;
        EXPECT_EQ(certainly_in_circle(a, b, w, d), inside);
        EXPECT_EQ(is_delaunay<double>(a, b, d, w), !inside);
        flips += inside ? 1 : 0;
        ++checked;
    }
    EXPECT_GT(checked, 100);
    EXPECT_GT(flips, 20);
    // An edge between cocircular points is not flipped.
    EXPECT_TRUE(is_delaunay<double>(P(0, 0), P(1, 0), P(1, 1), P(0, 1)));
    // Four points on one circle, without right angles: neither diagonal may replace the other.
    EXPECT_TRUE(is_delaunay<double>(P(5, 0), P(3, 4), P(-4, 3), P(0, -5)));
    EXPECT_TRUE(is_delaunay<double>(P(3, 4), P(-4, 3), P(0, -5), P(5, 0)));
    EXPECT_FALSE(certainly_in_circle(P(0, 0), P(1, 0), P(0, 1), P(1, 1)));
    // Where doubles underflow, the exact predicate decides.
    EXPECT_TRUE(certainly_in_circle(P(0, 0), P(1e-160, 0), P(0, 1e-160), P(3e-161, 3e-161)));
}

TEST(Segments, MeetWhereTheyShareAPoint) {
    const auto meet = [](const P& a, const P& b, const P& c, const P& d) {
        const bool result = segments_meet<double>(a, b, c, d);
        EXPECT_EQ(segments_meet<double>(b, a, c, d), result);
        EXPECT_EQ(segments_meet<double>(c, d, a, b), result);
        return result;
    };
    EXPECT_TRUE(meet(P(0, 0), P(2, 2), P(0, 2), P(2, 0))) << "they cross";
    EXPECT_TRUE(meet(P(0, 0), P(2, 0), P(1, 0), P(1, 5))) << "an end on the other";
    EXPECT_TRUE(meet(P(0, 0), P(2, 0), P(2, 0), P(3, 1))) << "a common end";
    EXPECT_TRUE(meet(P(0, 0), P(2, 0), P(1, 0), P(3, 0))) << "they overlap";
    EXPECT_FALSE(meet(P(0, 0), P(1, 0), P(2, 0), P(3, 0))) << "one behind the other";
    EXPECT_FALSE(meet(P(0, 0), P(2, 0), P(1, 1e-300), P(1, 1)));
    EXPECT_FALSE(meet(P(0, 0), P(1, 1), P(2, 0), P(1.5, 0.5)));
    EXPECT_TRUE(meet(P(0, 0), P(2, 2), P(1, 1), P(1, 1))) << "a point on it";
    EXPECT_FALSE(meet(P(0, 0), P(2, 2), P(3, 3), P(3, 3))) << "a point behind it";
}

} // namespace
} // namespace dsc::formulas_test
