// SPDX-License-Identifier: MIT
// Growth along the normal against exact shapes: corners that open, notches that stay sharp, and
// both when the flow reverses.
#include "support/random/scene.h"
#include "support/topology/growth_testing.h"

#include "measures/mesh_quality.h"

#include <gtest/gtest.h>

#include <array>

namespace dsc::growth_test {
namespace {

using std::numbers::pi;
using test::complex_of;
using test::difference;
using test::grow_and_shrink;
using test::GrowingShape;
using test::offset_polygon;
using test::Outline;

const Outline square{{0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}};
const Outline angle{{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.5}, {0.5, 0.5}, {0.5, 0.7}, {0.3, 0.7}};
const Outline star = scenes::star({0.5, 0.5}, 0.3, 0.15, 5, 1);

constexpr std::array<double, 3> sizes{0.02, 0.01, 0.005};

// The errors at three edge lengths; expects the order between the first and the last.
template <class ErrorAt>
std::array<double, 3> expect_order(double order, ErrorAt error_at) {
    std::array<double, 3> errors{};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        errors[i] = error_at(sizes[i]);
    }
    EXPECT_GT(std::log2(errors[0] / errors[2]) / 2, order)
        << errors[0] << ", " << errors[1] << ", " << errors[2];
    return errors;
}

double error_of(const Outline& outline, double h, double growth, double shrinkage,
                double step = 0.4) {
    auto complex = complex_of(outline, h);
    grow_and_shrink(complex, h, growth, shrinkage, step);
    return difference(complex, {offset_polygon(outline, growth, shrinkage)});
}

// --- one way ------------------------------------------------------------------------------------

TEST(Growth, TheCornersOfASquareOpenIntoArcs) {
    const auto errors = expect_order(1.9, [](double h) { return error_of(square, h, 0.1, 0); });
    EXPECT_LT(errors[1], 4e-4);
}

TEST(Growth, TheNotchesOfAStarStaySharp) {
    const auto errors = expect_order(1.9, [](double h) { return error_of(star, h, 0.1, 0); });
    EXPECT_LT(errors[1], 3e-4);
}

TEST(Growth, ASquareShrinksToASquare) {
    for (const double h : sizes) {
        EXPECT_LT(error_of(square, h, 0, 0.05), 1e-12) << h;
    }
}

TEST(Growth, ANotchOpensWhereTheShapeShrinks) {
    const auto errors = expect_order(1.9, [](double h) { return error_of(angle, h, 0, 0.06); });
    EXPECT_LT(errors[1], 1.5e-4);
    EXPECT_LT(error_of(star, 0.005, 0, 0.05), 2e-4);
}

TEST(Growth, StepsOfAnyLengthWillDo) {
    for (const double step : {0.05, 0.25, 0.6, 3.0}) {
        EXPECT_LT(error_of(square, 0.01, 0.1, 0, step), 4e-4) << step;
        EXPECT_LT(error_of(star, 0.01, 0.1, 0, step), 3e-4) << step;
        EXPECT_LT(error_of(angle, 0.01, 0, 0.06, step), 1.5e-4) << step;
    }
}

// --- there and back -----------------------------------------------------------------------------

TEST(Growth, AFanShrinksWhereTheFlowTurnsRound) {
    expect_order(1.9, [](double h) { return error_of(square, h, 0.1, 0.06); });
    expect_order(1.9, [](double h) { return error_of(star, h, 0.1, 0.06); });
}

TEST(Growth, AFanClosesIntoTheCornerThatItCameFrom) {
    for (const double h : sizes) {
        // For straight sheets and one corner the result is exact.
        EXPECT_LT(error_of(square, h, 0.1, 0.1), 1e-6) << h;
        EXPECT_LT(error_of(square, h, 0.1, 0.15), 1e-6) << h;
    }
    expect_order(1.9, [](double h) { return error_of(star, h, 0.1, 0.12); });
}

// --- smooth curves ------------------------------------------------------------------------------

constexpr double half_width = 0.25;
constexpr double half_height = 0.15;

Point<double> on_ellipse(double t) {
    return {0.5 + half_width * std::cos(t), 0.5 + half_height * std::sin(t)};
}

double distance_to_ellipse(const Point<double>& p) {
    constexpr int starts = 2000;
    const auto from = [&](double t) { return (p - on_ellipse(t)).norm(); };
    double best = 0;
    for (int i = 1; i < starts; ++i) {
        const double t = 2 * pi * i / starts;
        best = from(t) < from(best) ? t : best;
    }
    double low = best - 2 * pi / starts;
    double high = best + 2 * pi / starts;
    for (int k = 0; k < 80; ++k) {
        const double one = low + (high - low) / 3;
        const double other = high - (high - low) / 3;
        (from(one) < from(other) ? high : low) = from(one) < from(other) ? other : one;
    }
    return from(low);
}

TEST(Growth, TheVerticesOfAnEllipseStayOnItsParallelCurveToFourthOrder) {
    for (const double distance : {0.1, -0.05}) {
        const auto errors = expect_order(3.5, [=](double h) {
            Outline ellipse; // all edges are shorter than h
            const int vertices = static_cast<int>(1.6 / h);
            for (int i = 0; i < vertices; ++i) {
                ellipse.push_back(on_ellipse(2 * pi * i / vertices));
            }
            auto complex = complex_of(ellipse, h);
            GrowingShape growing(complex, h, {.speeds = {{1, 0, distance > 0 ? 1.0 : -1.0}}});
            EXPECT_EQ(growing.run(0, std::abs(distance)), 0U);
            double sum = 0;
            for (const std::uint32_t v : growing.simulation().interface()) {
                sum +=
                    std::abs(distance_to_ellipse(complex.position(Vertex{v})) - std::abs(distance));
            }
            return sum / static_cast<double>(growing.simulation().interface_size());
        });
        EXPECT_LT(errors[1], 2e-8);
    }
}

// The chords of a disc with few vertices turn like corners. They are none: a fan there would be two
// vertices at one place.
TEST(Growth, TheVerticesOfASmallDiscAreNoCorners) {
    constexpr double h = 0.02;
    constexpr double grown = 0.1;
    const Point<double> centre(0.5, 0.5);
    for (const int n : {11, 12}) {
        const double radius = n * h / (2 * pi);
        auto complex = complex_of(test::circle_points(centre, radius, n), h);
        GrowingShape growing(complex, h, {.speeds = {{1, 0, 1.0}}});
        EXPECT_EQ(growing.run(0, grown), 0U);
        EXPECT_GT(scenes::measure_quality(complex).min_angle_deg, 10) << n;
        for (const std::uint32_t v : growing.simulation().interface()) {
            const double distance = (complex.position(Vertex{v}) - centre).norm();
            EXPECT_NEAR(distance, radius + grown, 0.01 * h) << n;
        }
    }
}

} // namespace
} // namespace dsc::growth_test
