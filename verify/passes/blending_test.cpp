// SPDX-License-Identifier: MIT
// Attributes of the vertices that a step makes itself: blended from both ends of the edge, on the
// interface as well as inside. Operations by hand are tested elsewhere; here the driver splits.
#include "support/simulation_testing.h"

#include "dsc/complex/ranges.h"
#include "dsc/operations/edge_split.h"

#include <gtest/gtest.h>

#include <vector>

namespace dsc::blending_test {
namespace {

using test::disc_complex;
using test::options_for;

// Nothing moves, and edges are too long: new vertices lie exactly in the middle of old edges, or of
// new ones, so that blended coordinates remain coordinates.
TEST(Blending, OfVerticesThatTheDriverMakes) {
    constexpr double coarse = 0.08;
    auto complex = disc_complex<double>(coarse);
    auto& abscissa = complex.attributes.add<Vertex, double>(
        "abscissa", 0.0,
        [](double a, double b, double fraction) { return a + fraction * (b - a); });
    for (const Vertex v : vertices(complex)) {
        abscissa[v] = complex.position(v).x();
    }
    auto options = options_for<double>(coarse);
    options.insertion = Insertion::linear;
    options.interface.longest = 0.7;
    options.interface.shortest = 0.2;
    options.phases.longest = 0.9;
    options.phases.smooth_quality = 0; // a vertex that smoothing moves keeps its value
    options.phases.collapse_quality = 0;
    Simulation<double> simulation(complex, options);
    OperationCounts counts;
    std::vector<Vertex> made;
    std::size_t on_interface = 0;
    simulation.add_listener([&](std::span<const Edit> edits) {
        for (const Edit& edit : edits) {
            if (edit.kind == EditKind::split) {
                made.push_back(edit.vertex);
                on_interface += edit.on_interface ? 1 : 0;
            }
        }
    });
    for (int step = 0; step < 4; ++step) {
        // Too slow to matter: stars are looked at where vertices move.
        counts += simulation.step(test::constant<double>(1e-12, 0), 0, 1).operations;
    }
    EXPECT_EQ(counts.smoothed, 0U);
    EXPECT_GT(on_interface, 10U);
    EXPECT_GT(made.size() - on_interface, 10U);
    for (const Vertex v : made) {
        if (complex.is_alive(v)) {
            EXPECT_NEAR(abscissa[v], complex.position(v).x(), 1e-9);
        }
    }
}

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
