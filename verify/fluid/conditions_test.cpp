// SPDX-License-Identifier: MIT
// The names of edges of the domain boundary.
#include "fluid/system/conditions.h"

#include "dsc/geometry/points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

namespace dsc::conditions_test {
namespace {

// Two rings of 37 edges, each with a name of its own, and places near and far.
TEST(FluidConditions, AreThoseOfTheNearestEdge) {
    FluidOptions options;
    for (const double radius : {1.0, 0.4}) {
        const auto at = [&](int i) {
            const double angle = 2 * std::numbers::pi * i / 37;
            return Point<double>(radius * std::cos(angle), radius * std::sin(angle));
        };
        for (int i = 0; i < 37; ++i) {
            options.sides.push_back({.name = "edge " + std::to_string(options.sides.size())});
            options.domain_edges.push_back({at(i), at(i + 1), options.sides.back().name});
        }
    }
    const SideConditions conditions({{-1, -1}, {1, 1}}, options);
    std::mt19937_64 random(1);
    for (int trial = 0; trial < 2000; ++trial) {
        const auto coordinate = [&] { return static_cast<double>(random() % 3001) / 1000 - 1.5; };
        const Point<double> from(coordinate(), coordinate());
        const Point<double> to(coordinate(), coordinate());
        const auto nearest =
            std::ranges::min_element(options.domain_edges, {}, [&](const DomainEdge& edge) {
                return squared_distance<double>(midpoint<double>(from, to), edge.from, edge.to);
            });
        EXPECT_EQ(conditions.between(from, to).side, nearest - options.domain_edges.begin());
    }
}

// An edge without a name has that of the box, or `other`.
TEST(FluidConditions, AreOtherwiseThoseOfTheBox) {
    FluidOptions options;
    options.walls = {.left = Wall::slip, .right = Wall::open, .other = Wall::slip};
    options.sides = {{.name = "left", .wall = Wall::open}, {.name = "lid", .wall = Wall::slip}};
    options.domain_edges = {
        {{0, 1}, {0, 0}}, {{0, 0}, {1, 0}, "unknown"}, {{1, 0}, {1, 1}}, {{1, 1}, {0, 1}, "lid"}};
    const SideConditions conditions({{0, 0}, {1, 1}}, options);
    const auto expect = [&](const Point<double>& from, const Point<double>& to, Wall wall,
                            std::uint32_t side) {
        const SideCondition found = conditions.between(from, to);
        EXPECT_EQ(found.wall, wall);
        EXPECT_EQ(found.side, side);
    };
    expect({0, 1}, {0, 0.5}, Wall::open, 0);
    expect({0, 0}, {0.5, 0}, Wall::no_slip, no_id);
    expect({1, 0}, {1, 1}, Wall::open, no_id);
    expect({1, 1}, {0.5, 1}, Wall::slip, 1);
    expect({0.9, 0.4}, {0.9, 0.6}, Wall::slip, no_id);
}

} // namespace
} // namespace dsc::conditions_test
