// SPDX-License-Identifier: MIT
// How a value reaches a point across a triangle, and how targets spread over a whole mesh.
#include "dsc/sizes/rule.h"
#include "dsc/sizes/sizes.h"

#include "support/random/scene.h"

#include "dsc/complex/ranges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dsc::wavefront_test {
namespace {

double between(const Point<double>& a, double value_a, const Point<double>& b, double value_b,
               double slope) {
    return least_between<double>(a.x(), a.y(), value_a, b.x(), b.y(), value_b, slope);
}

TEST(Wavefront, KeepsToTheEndsWhereNothingIsKnown) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(between({1, -1}, infinity, {1, 1}, infinity, 1), infinity);
    EXPECT_EQ(between({1, -1}, 0, {1, 1}, infinity, 1), infinity);
    EXPECT_EQ(between({1, -1}, infinity, {1, 1}, 0, 1), infinity);
    EXPECT_DOUBLE_EQ(between({1, -1}, 0, {1, 1}, 0, 1), 1);
}

constexpr double h = 0.02;
constexpr double radius = 0.2;

double distance_to_circle(const Complex<double>& complex, Vertex v) {
    return std::abs((complex.position(v) - Point<double>(0.5, 0.5)).norm() - radius);
}

TEST(MeasureSizes, TargetsGrowWithTheDistance) {
    Complex<double> complex = test::disc_complex<double>(h, {0.5, 0.5}, radius);
    const SizeOptions<double> sizes{.growth = 1.5, .by_distance = [](double) { return 1.0; }};
    measure_sizes(complex, sizes, h, 0.0);
    const SizeField<double>& field = size_field(complex);
    double most = 0;
    for (const Vertex v : vertices(complex)) {
        const double distance = distance_to_circle(complex, v);
        // Edges of the circle are chords.
        EXPECT_NEAR(field[v].distance, distance, 0.02 * distance + 0.1 * h);
        EXPECT_NEAR(field[v].length, h + 0.5 * distance, 0.02 * distance + 0.1 * h);
        most = std::max(most, distance);
    }
    EXPECT_GT(most, 0.4);
}

// Along edges alone the distance would be up to 15 % too large.
TEST(MeasureSizes, DistancesAreNearlyExact) {
    Complex<double> complex = test::disc_complex<double>(h, {0.5, 0.5}, radius);
    measure_sizes(complex, {.growth = 2, .by_distance = [](double) { return 1.0; }}, h, 0.0);
    double sum = 0;
    double count = 0;
    for (const Vertex v : vertices(complex)) {
        const double distance = distance_to_circle(complex, v);
        if (distance > 0.1) {
            sum += size_field(complex)[v].distance / distance - 1;
            ++count;
        }
    }
    EXPECT_LT(std::abs(sum / count), 0.01);
}

TEST(MeasureSizes, AreBoundByEachOption) {
    Complex<double> complex = test::disc_complex<double>(h, {0.5, 0.5}, radius);
    const auto lengths = [&](const SizeOptions<double>& sizes) {
        measure_sizes(complex, sizes, h, 3.0);
        std::vector<double> list;
        for (const Vertex v : vertices(complex)) {
            list.push_back(size_field(complex)[v].length);
        }
        return list;
    };
    const auto most = [](const std::vector<double>& list) {
        return *std::ranges::max_element(list);
    };
    const auto least = [](const std::vector<double>& list) {
        return *std::ranges::min_element(list);
    };
    EXPECT_DOUBLE_EQ(most(lengths({.growth = 2, .longest = 0.07})), 0.07);
    EXPECT_DOUBLE_EQ(most(lengths({.growth = 2, .by_distance = [](double) { return 0.06; }})),
                     0.06);
    const SizeOptions<double> by_place{
        .growth = 2, .by_place = [](const Point<double>&, double time, Phase phase) {
            return phase == 1 ? 0.01 * time : 0.05;
        }};
    EXPECT_DOUBLE_EQ(most(lengths(by_place)), 0.05);
    EXPECT_DOUBLE_EQ(least(lengths(by_place)), 0.03); // on the interface as well
    const SizeOptions<double> too_fine{
        .growth = 2, .by_place = [](const Point<double>&, double, Phase) { return std::nan(""); }};
    EXPECT_DOUBLE_EQ(most(lengths(too_fine)), h);
}

} // namespace
} // namespace dsc::wavefront_test
