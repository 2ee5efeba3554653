// SPDX-License-Identifier: MIT
// Attributes of new vertices: blended from both ends of the edge, by the place on it.
#include "support/simulation_testing.h"

#include "dsc/complex/ranges.h"
#include "dsc/operations/edge_split.h"

#include <gtest/gtest.h>

#include <vector>

namespace dsc::blending_test {
namespace {

using test::disc_complex;

// Where the new vertex lies, and not always in the middle.
TEST(Blending, OfAVertexAnywhereOnItsEdge) {
    for (const double fraction : {0.5, 0.25, 0.875, 1 / 3.0}) {
        auto complex = disc_complex<double>(0.1);
        auto& heat = complex.attributes.add<Vertex, double>("heat");
        std::vector<double> told;
        (void)complex.attributes.add<Vertex>("told", 0.0, [&](double a, double, double share) {
            told.push_back(share);
            return a;
        });
        const auto heat_at = [](const Point<double>& p) { return 1 + 3 * p.x() - p.y(); };
        for (const Vertex v : vertices(complex)) {
            heat[v] = heat_at(complex.position(v));
        }
        std::vector<Edge> some;
        for (const Edge edge : edges(complex)) {
            some.push_back(edge);
        }
        for (const std::size_t i : {std::size_t{0}, some.size() / 2, some.size() - 1}) {
            const auto [a, b] = complex.vertices_of(some[i]);
            const Point<double> from = complex.position(a);
            const Point<double> place =
                fraction == 0.5 ? midpoint<double>(from, complex.position(b))
                                : Point<double>(from + fraction * (complex.position(b) - from));
            const SplitResult split = edge_split(complex, some[i], place);
            ASSERT_EQ(split.verdict, Verdict::legal);
            EXPECT_NEAR(heat[split.vertex], heat_at(place), 1e-14);
        }
        ASSERT_EQ(told.size(), 3U);
        if (fraction == 0.5) {
            EXPECT_EQ(told, std::vector<double>(3, 0.5));
        }
    }
}

// A point off the edge counts by the nearest point of the edge.
TEST(Blending, OfAVertexBesideItsEdge) {
    EXPECT_EQ((rewire::split_fraction<double>({0.25, 0.5}, {0, 0}, {1, 0})), 0.25);
    EXPECT_EQ((rewire::split_fraction<double>({2, 0.5}, {0, 0}, {1, 0})), 1);
    EXPECT_EQ((rewire::split_fraction<float>({0.5F, 0}, {0, 0}, {1, 0})), 0.5);
}

} // namespace
} // namespace dsc::blending_test
