// SPDX-License-Identifier: MIT
// How a distance propagates across a triangle, and how targets spread over a whole mesh: also from
// the domain boundary, and in stars with a single triangle of a phase.
#include "support/random/scene.h"
#include "support/small_meshes.h"

#include "dsc/complex/gather.h"
#include "dsc/complex/ranges.h"
#include "dsc/sizes/rule.h"
#include "dsc/sizes/sizes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace dsc::wavefront_test {
namespace {

double between(const Point<double>& a, double value_a, const Point<double>& b, double value_b,
               double slope) {
    return min_between<double>(a.x(), a.y(), value_a, b.x(), b.y(), value_b, slope);
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
    double largest = 0;
    double error = 0; // the mean one, far away
    int far = 0;
    for (const Vertex v : vertices(complex)) {
        const double distance = distance_to_circle(complex, v);
        // Edges of the circle are chords.
        EXPECT_NEAR(field[v].distance, distance, 0.02 * distance + 0.1 * h);
        EXPECT_NEAR(field[v].length, h + 0.5 * distance, 0.02 * distance + 0.1 * h);
        largest = std::max(largest, distance);
        if (distance > 0.1) {
            error += field[v].distance / distance - 1;
            ++far;
        }
    }
    EXPECT_GT(largest, 0.4);
    EXPECT_LT(std::abs(error / far), 0.01);
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
    const auto largest = [](const std::vector<double>& list) {
        return *std::ranges::max_element(list);
    };
    const auto smallest = [](const std::vector<double>& list) {
        return *std::ranges::min_element(list);
    };
    EXPECT_DOUBLE_EQ(largest(lengths({.growth = 2, .longest = 0.07})), 0.07);
    EXPECT_DOUBLE_EQ(largest(lengths({.growth = 2, .by_distance = [](double) { return 0.06; }})),
                     0.06);
    const SizeOptions<double> by_place{
        .growth = 2, .by_place = [](const Point<double>&, double time, Phase phase) {
            return phase == 1 ? 0.01 * time : 0.05;
        }};
    EXPECT_DOUBLE_EQ(largest(lengths(by_place)), 0.05);
    EXPECT_DOUBLE_EQ(smallest(lengths(by_place)), 0.03); // on the interface as well
    const SizeOptions<double> too_fine{
        .growth = 2, .by_place = [](const Point<double>&, double, Phase) { return 1e-9; }};
    EXPECT_DOUBLE_EQ(largest(lengths(too_fine)), h);
}

// In turn, only the first or the last vertex of the link has a low value.
TEST(WavefrontLimits, BothEndsOfAnOpenLinkCount) {
    const auto complex = test::grid<double>(4, 0.1);
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        Star<double> star;
        ASSERT_TRUE(gather(complex, Region{}, v, star));
        if (star.closed) {
            continue;
        }
        for (const std::uint32_t low : {0U, star.size}) {
            LinkValues<double> values;
            values.take(star, [&](std::uint32_t w) { return w == star.link[low] ? 0.0 : 1e3; });
            const Point<double> end(star.link_x(low), star.link_y(low));
            EXPECT_NEAR(min_over_link(star, 0.5, values),
                        0.5 * (end - Point<double>(star.x0, star.y0)).norm(), 1e-12)
                << v;
        }
    }
}

// Vertex 0 gets its value late and only from vertex 1. The front from the boundary edge between 0
// and 3 then reaches vertex 2 before any front along an edge.
TEST(WavefrontLimits, AFrontFromTheBoundaryReachesTheMeshBesideIt) {
    const std::vector<Point<double>> points{{0, 0}, {0.3, 0.02}, {-1, 1}, {-2, 0}};
    auto complex = test::build<double>(points, {{0, 1, 2}, {0, 2, 3}}, {0, 0});
    const std::vector<double> wanted{100, 1.0001, 100, 1};
    SizeOptions<double> sizes{.growth = 1.1, .longest = 100};
    sizes.by_place = [&](const Point<double>& place, double, Phase) {
        const auto at = std::ranges::find(points, place);
        return wanted[static_cast<std::size_t>(at - points.begin())];
    };
    measure_sizes(complex, sizes, 1.0, 0.0);
    const SizeField<double>& field = size_field(complex);
    const double at_0 = wanted[1] + 0.1 * points[1].norm();
    EXPECT_NEAR(field[Vertex{0}].length, at_0, 1e-12);
    const Point<double> from_0 = points[0] - points[2];
    const Point<double> from_3 = points[3] - points[2];
    const double straight =
        min_between<double>(from_3.x(), from_3.y(), 1, from_0.x(), from_0.y(), at_0, 0.1);
    ASSERT_LT(straight, 1.12);
    EXPECT_NEAR(field[Vertex{2}].length, straight, 1e-12);
}

// Random targets, whose differences are about as large as the lengths of edges allow.
TEST(SizeLimits, WhatIsSeenToStayIsNotFollowed) {
    Complex<double> complex = test::disc_complex<double>(h, {0.5, 0.5}, radius);
    std::mt19937 random(1);
    for (const double growth : {1.05, 1.3, 2.0}) {
        const SizeOptions<double> sizes{.growth = growth};
        const SizeRule<double> rule(sizes, h);
        std::uniform_real_distribution<double> share(1, 1 + 2 * rule.slope());
        int within = 0;
        int stays = 0;
        for (const Vertex v : vertices(complex)) {
            Star<double> star;
            std::vector<VertexSize<double>> field(complex.vertex_bound());
            ASSERT_TRUE(gather(complex, Region{}, v.id, star));
            for (VertexSize<double>& size : field) {
                size.length = h * share(random);
            }
            if (!star.closed || is_on_interface(star)) {
                continue;
            }
            const double stored = field[v.id].length;
            const double now = rule.at(star, field, 0).length;
            const bool is_within = std::abs(now - stored) <= rule.slack() * std::min(now, stored);
            const bool is_seen = rule.stays(star, field, stored, 0);
            EXPECT_TRUE(is_within || !is_seen) << v.id << ": " << stored << " to " << now;
            within += is_within ? 1 : 0;
            stays += is_seen ? 1 : 0;
        }
        EXPECT_GT(stays, within / 3) << growth;
        EXPECT_LT(within, 3 * static_cast<int>(complex.vertex_bound()) / 4);
    }
}

TEST(SizeLimits, EachPhaseOfAStarIsAskedFor) {
    const std::vector<Point<double>> points{{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const std::vector<test::Indices> triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
    SizeOptions<double> sizes;
    sizes.growth = 1.5;
    sizes.by_place = [](const Point<double>&, double, Phase phase) {
        return phase == 1 ? 2.0 : 4.0;
    };
    for (std::size_t single = 0; single < 4; ++single) {
        std::vector<Phase> phases(4, 0);
        phases[single] = 1;
        const auto complex = test::build<double>(points, triangles, phases);
        Star<double> star;
        ASSERT_TRUE(gather(complex, Region{}, 0, star));
        EXPECT_EQ(SizeRule<double>(sizes, 1).own(star, 0, 0), 2) << single;
    }
}

TEST(SizeLimits, TheExtentIsThatOfTheVertices) {
    const auto complex = test::build<double>({{3, 3}, {3.5, 3}, {3, 3.25}}, {{0, 1, 2}}, {0});
    EXPECT_EQ(extent_of(complex), 0.5);
}

} // namespace
} // namespace dsc::wavefront_test
