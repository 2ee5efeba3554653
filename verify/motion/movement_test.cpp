// SPDX-License-Identifier: MIT
// The move limit: a vertex moves as far as the triangles of its star keep their shape, and never so
// that rounding inverts a triangle.
#include "dsc/complex/gather.h"
#include "dsc/motion/movement.h"

#include "support/small_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsc::movement_test {
namespace {

// The smallest ratio of altitude to base among the triangles about vertex 0.
double min_shape(const Complex<double>& complex) {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
        const auto v = complex.vertices_of(Triangle{t});
        const Point<double> a = complex.position(v[1]);
        const Point<double> b = complex.position(v[2]);
        const double doubled = 2 * area<double>(complex.position(v[0]), a, b);
        smallest = std::min(smallest, doubled / (b - a).squaredNorm());
    }
    return smallest;
}

MoveOutcome move_centre(Complex<double>& complex, const Point<double>& target) {
    Star<double> star;
    EXPECT_TRUE(gather(complex, Region{}, 0, star));
    return move_vertex(Submesh(complex), star, target.x(), target.y());
}

TEST(Movement, ReachesWhatLiesInItsStar) {
    auto complex = test::hexagon<double>();
    EXPECT_EQ(move_centre(complex, {0.3, 0.2}), MoveOutcome::reached);
    EXPECT_EQ(complex.position(Vertex{0}), Point<double>(0.3, 0.2));
}

TEST(Movement, KeepsAltitudesOverBases) {
    for (const double angle : {0.0, 0.3, 0.9, 2.0}) {
        auto complex = test::hexagon<double>();
        const Point<double> far(3 * std::cos(angle), 3 * std::sin(angle));
        EXPECT_EQ(move_centre(complex, far), MoveOutcome::partly);
        EXPECT_NEAR(min_shape(complex), altitude_floor, 1e-9);
        // A flat triangle may become flatter by a fraction in each move.
        const double before = min_shape(complex);
        (void)move_centre(complex, far);
        EXPECT_GE(min_shape(complex), altitude_keep * before * (1 - 1e-9));
    }
}

// Coordinates so large that only whole numbers are representable: a target between two of them is
// rounded to one that may lie beyond the edge.
TEST(Movement, IsCertifiedWhereCoordinatesAreCoarse) {
    constexpr double far = 4503599627370496.0; // 2^52: the spacing is 1
    int partly = 0;
    for (int x = -9; x <= 9; ++x) {
        for (int y = -9; y <= 9; ++y) {
            const std::vector<Point<double>> link{{5, 0},   {2, 4},   {-3, 4},
                                                  {-5, -1}, {-2, -5}, {3, -4}};
            std::vector<Point<double>> points{{far, far}};
            std::vector<test::Indices> triangles;
            for (std::uint32_t i = 0; i < 6; ++i) {
                points.emplace_back(far + link[i].x(), far + link[i].y());
                triangles.push_back({0, i + 1, (i + 1) % 6 + 1});
            }
            auto complex = test::build<double>(points, triangles, std::vector<Phase>(6, 0));
            partly += move_centre(complex, {far + x, far + y}) == MoveOutcome::partly ? 1 : 0;
            for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
                const auto v = complex.vertices_of(Triangle{t});
                EXPECT_GT(orientation(complex.position(v[0]), complex.position(v[1]),
                                      complex.position(v[2])),
                          0)
                    << x << ", " << y;
            }
        }
    }
    EXPECT_GT(partly, 20);
}

// The sides of the square follow the axes, so that for targets that are not finite some rates of
// change of the areas are 0 times infinity, which is NaN.
TEST(Movement, RefusesWhatIsNotFinite) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::vector<Point<double>> square{{0, 0}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    for (const double x : {nan, infinity, -infinity, 0.1}) {
        for (const double y : {nan, infinity, -infinity}) {
            for (const Point<double>& target : {Point<double>(x, y), Point<double>(y, x)}) {
                auto complex = test::build<double>(
                    square, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}, std::vector<Phase>(4, 0));
                Star<double> star;
                ASSERT_TRUE(gather(complex, Region{}, 0, star));
                EXPECT_EQ(move_limit(star, target.x(), target.y()), 0) << target.transpose();
                EXPECT_FALSE(all_positive(star, target.x(), target.y())) << target.transpose();
                EXPECT_EQ(move_centre(complex, target), MoveOutcome::blocked);
                EXPECT_EQ(complex.position(Vertex{0}), square[0]);
            }
        }
    }
}

TEST(Movement, IsLimitedToAShareOfTheWay) {
    const auto complex = test::hexagon<double>();
    Star<double> star;
    ASSERT_TRUE(gather(complex, Region{}, 0, star));
    EXPECT_EQ(move_limit(star, 0.01, 0.0), 1);
    EXPECT_EQ(move_limit(star, 0.0, 0.0), 1);
    EXPECT_GT(move_limit(star, 3.0, 0.0), 0);
    EXPECT_LT(move_limit(star, 3.0, 0.0), 0.34);
}

} // namespace
} // namespace dsc::movement_test
