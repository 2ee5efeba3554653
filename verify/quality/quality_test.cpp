// SPDX-License-Identifier: MIT
// Measures [thesis 4.3] against trigonometry.
#include "dsc/quality/measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace dsc::quality_test {
namespace {

using std::numbers::pi;

template <class Real>
class Measures : public testing::Test {
protected:
    using P = Point<Real>;
    static constexpr double tolerance = sizeof(Real) == 8 ? 1e-13 : 2e-5;

    // A triangle with two given angles, at an arbitrary position, rotation and scale.
    static std::array<P, 3> by_angles(double alpha_deg, double beta_deg, double scale = 1,
                                      double turn = 0.7) {
        const double a = alpha_deg * pi / 180;
        const double b = beta_deg * pi / 180;
        const double side = std::sin(b) / std::sin(a + b); // from the corner of alpha to the apex
        const auto place = [&](double x, double y) {
            return P(static_cast<Real>(scale * (x * std::cos(turn) - y * std::sin(turn))),
                     static_cast<Real>(scale * (x * std::sin(turn) + y * std::cos(turn))));
        };
        return {place(0, 0), place(1, 0), place(side * std::cos(a), side * std::sin(a))};
    }
};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Measures, Reals);

TYPED_TEST(Measures, AgreeWithTrigonometry) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> angle(2, 88);
    for (int i = 0; i < 1000; ++i) {
        const double alpha = angle(random);
        const double beta = angle(random);
        const double gamma = 180 - alpha - beta;
        // Scales for which products of two lengths nearly overflow or underflow.
        constexpr double decades = sizeof(TypeParam) == 8 ? 25 : 2.8;
        const double scale = std::pow(10.0, decades * (i % 13 - 6));
        const auto p = TestFixture::by_angles(alpha, beta, scale, i);
        const double smallest = std::min({alpha, beta, gamma});
        const auto sine = [](double degrees) { return std::sin(degrees * pi / 180); };
        const double a = sine(alpha) / sine(gamma); // edges; the one opposite to gamma has length 1
        const double b = sine(beta) / sine(gamma);
        const double size = 0.5 * sine(alpha) * b;
        const auto near = [&](auto value, double expected) {
            EXPECT_NEAR(static_cast<double>(value), expected,
                        30 * TestFixture::tolerance * expected);
        };
        near(area(p[0], p[1], p[2]), size * scale * scale);
        near(distance(p[0], p[1]), scale);
        near(squared_distance(p[1], p[2]), a * a * scale * scale);
        near(min_angle_deg(p[0], p[1], p[2]), smallest);
        near(quality(p[0], p[1], p[2]), 2 / std::sqrt(3) * sine(smallest));
    }
}

TYPED_TEST(Measures, DoNotDependOnTheFirstCornerAndChangeSignWithOrientation) {
    const auto p = TestFixture::by_angles(31, 77);
    const auto all = [](const auto& a, const auto& b, const auto& c) {
        return std::array{quality(a, b, c), area(a, b, c)};
    };
    const auto first = all(p[0], p[1], p[2]);
    const auto turned = all(p[1], p[2], p[0]);
    const auto inverted = all(p[0], p[2], p[1]);
    for (std::size_t i = 0; i < first.size(); ++i) {
        const double size = std::abs(static_cast<double>(first[i]));
        EXPECT_NEAR(first[i], turned[i], 4 * TestFixture::tolerance * size);
        EXPECT_NEAR(first[i], -inverted[i], 4 * TestFixture::tolerance * size);
        EXPECT_GT(first[i], 0);
    }
    EXPECT_EQ(min_angle_deg(p[0], p[2], p[1]), min_angle_deg(p[0], p[1], p[2]));
}

TYPED_TEST(Measures, DegenerateTrianglesAreWorth0) {
    using Q = typename TestFixture::P;
    const std::vector<std::array<Q, 3>> list{
        {Q(1, 1), Q(1, 1), Q(1, 1)}, {Q(0, 0), Q(1, 1), Q(2, 2)}, {Q(0, 0), Q(3, 1), Q(3, 1)}};
    for (const auto& p : list) {
        EXPECT_EQ(quality(p[0], p[1], p[2]), 0);
        EXPECT_EQ(min_angle_deg(p[0], p[1], p[2]), 0);
    }
}

} // namespace
} // namespace dsc::quality_test
