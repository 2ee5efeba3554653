// SPDX-License-Identifier: MIT
// Interface curves and outlines of phases: on grids whose squares have phases, and on random meshes
// compared with the phases of every triangle.
#include "dsc/queries/phases.h"

#include "dsc/passes/interface/list.h"
#include "support/random/complex.h"
#include "support/small_meshes.h"

#include "thesis/sets/algebra.h"
#include "thesis/sets/mesh_functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

namespace dsc::outlines_test {
namespace {

using Ids = std::vector<std::uint32_t>;

// Rows of squares from top to bottom, in reading order; each digit is a phase.
Complex<double> squares(const std::vector<std::string_view>& rows) {
    const auto n = static_cast<std::uint32_t>(rows.size());
    auto complex = test::grid<double>(n, 0.1);
    for (const Triangle t : triangles(complex)) {
        const std::uint32_t square = (t.id - 1) / 2;
        const char digit = rows[n - 1 - square / n][square % n];
        complex.set_phase(t, static_cast<Phase>(digit - '0'));
    }
    return complex;
}

Ids ids(const std::vector<Vertex>& vertices) {
    Ids result;
    for (const Vertex v : vertices) {
        result.push_back(v.id);
    }
    return result;
}

// A closed curve, starting at its smallest vertex.
Ids turned(const std::vector<Vertex>& loop) {
    Ids result = ids(loop);
    std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
    return result;
}

double area(const Complex<double>& complex, const VertexLoop& loop) {
    const Point<double> origin = complex.position(loop[0]); // some meshes are far out
    double doubled = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point<double> a = complex.position(loop[i]) - origin;
        const Point<double> b = complex.position(loop[(i + 1) % loop.size()]) - origin;
        doubled += a.x() * b.y() - a.y() * b.x();
    }
    return doubled / 2;
}

// The curve between two phases, which must be the only one.
InterfaceCurve only(const std::vector<InterfaceCurve>& curves, Phase left, Phase right) {
    std::vector<InterfaceCurve> found;
    std::copy_if(curves.begin(), curves.end(), std::back_inserter(found),
                 [&](const auto& c) { return c.left == left && c.right == right; });
    EXPECT_EQ(found.size(), 1U) << left << " against " << right;
    return found.empty() ? InterfaceCurve{} : found.front();
}

TEST(Outlines, OfADisc) {
    const auto complex = squares({"000", "010", "000"});
    const auto curves = interface_curves(complex);
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_TRUE(curves[0].is_closed);
    EXPECT_EQ(curves[0].left, 1U);
    EXPECT_EQ(curves[0].right, exterior_phase);
    EXPECT_EQ(turned(curves[0].vertices), (Ids{5, 6, 10, 9}));

    const auto disc = outlines(complex, 1);
    ASSERT_EQ(disc.size(), 1U);
    EXPECT_EQ(disc[0], curves[0].vertices);
    // Phase 0 has the sides of the domain as its outline, and the disc as a hole, clockwise.
    const auto around = outlines(complex, 0);
    ASSERT_EQ(around.size(), 2U);
    EXPECT_EQ(turned(around[0]), (Ids{0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4}));
    EXPECT_EQ(turned(around[1]), (Ids{5, 9, 10, 6}));
    EXPECT_TRUE(outlines(complex, 2).empty());
    EXPECT_TRUE(outlines(complex, border_phase).empty());
    EXPECT_EQ(outlines_where(complex, [](Phase) { return true; }).size(), 1U);
}

TEST(Outlines, OfThreePhasesEndAtJunctions) {
    const auto complex = squares({"0000", "0120", "0120", "0000"});
    const auto curves = interface_curves(complex);
    ASSERT_EQ(curves.size(), 3U);
    const InterfaceCurve between = only(curves, 2, 1);
    EXPECT_FALSE(between.is_closed);
    EXPECT_EQ(ids(between.vertices), (Ids{17, 12, 7}));
    EXPECT_EQ(ids(only(curves, 1, 0).vertices), (Ids{17, 16, 11, 6, 7}));
    EXPECT_EQ(ids(only(curves, 2, 0).vertices), (Ids{7, 8, 13, 18, 17}));
    ASSERT_EQ(outlines(complex, 1).size(), 1U);
    EXPECT_EQ(turned(outlines(complex, 1)[0]), (Ids{6, 7, 12, 17, 16, 11}));
    // Together, the phases have one outline, without the edges between them.
    const auto both = outlines_where(complex, [](Phase p) { return p != 0; });
    ASSERT_EQ(both.size(), 1U);
    EXPECT_EQ(turned(both[0]), (Ids{6, 7, 8, 13, 18, 17, 16, 11}));
}

TEST(Outlines, TouchAtAPinchedVertex) {
    const auto complex = squares({"0000", "0010", "0100", "0000"});
    const auto loops = outlines(complex, 1);
    ASSERT_EQ(loops.size(), 2U);
    EXPECT_EQ(turned(loops[0]), (Ids{6, 7, 12, 11}));
    EXPECT_EQ(turned(loops[1]), (Ids{12, 13, 18, 17}));
    // Four interface edges meet there: curves end and begin there.
    const auto curves = interface_curves(complex);
    ASSERT_EQ(curves.size(), 2U);
    EXPECT_FALSE(curves[0].is_closed || curves[1].is_closed);
    EXPECT_EQ(ids(curves[0].vertices), (Ids{12, 11, 6, 7, 12}));
    EXPECT_EQ(ids(curves[1].vertices), (Ids{12, 13, 18, 17, 12}));
}

// The number of interface edges at a vertex, by its star.
std::size_t interface_edges_at(const Complex<double>& complex, Vertex v) {
    const SimplexSet set = star(complex, v);
    return static_cast<std::size_t>(std::count_if(
        set.edges().begin(), set.edges().end(), [&](Edge e) { return is_interface(complex, e); }));
}

// The edges of a polyline, each checked to have the two phases beside it.
void add_edges(const Complex<double>& complex, const std::vector<Vertex>& line, bool is_closed,
               std::vector<Edge>& edges) {
    for (std::size_t i = 0; i + (is_closed ? 0 : 1) < line.size(); ++i) {
        const Corner c = complex.find_half_edge(line[i], line[(i + 1) % line.size()]);
        ASSERT_NE(c, no_id);
        edges.push_back(complex.edge(c));
    }
}

TEST(Outlines, HoldEachEdgeOfRandomMeshesOnce) {
    std::size_t open = 0;
    std::size_t closed = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const auto complex = test::random_complex<double>(seed, test::random_options(seed));
        std::vector<Edge> edges;
        for (const InterfaceCurve& curve : interface_curves(complex)) {
            const auto& line = curve.vertices;
            ++(curve.is_closed ? closed : open);
            ASSERT_GE(line.size(), curve.is_closed ? 3U : 2U);
            add_edges(complex, line, curve.is_closed, edges);
            const bool at_border = curve.right == border_phase;
            for (std::size_t i = 0; i < line.size(); ++i) {
                const bool is_end = !curve.is_closed && (i == 0 || i + 1 == line.size());
                const bool passes = interface_edges_at(complex, line[i]) == 2 &&
                                    (at_border || !is_boundary(complex, line[i]));
                // A curve along the domain boundary also ends where a curve from inside meets the
                // boundary.
                ASSERT_TRUE(is_end ? !passes || at_border : passes) << "seed " << seed;
                if (i + 1 < line.size()) {
                    const Corner c = complex.find_half_edge(line[i], line[i + 1]);
                    EXPECT_EQ(complex.phase_at(c), curve.left);
                    EXPECT_EQ(complex.phase_at(complex.twin(c)), curve.right);
                }
            }
        }
        std::sort(edges.begin(), edges.end());
        ASSERT_EQ(edges, interface_of(complex).edges()) << "seed " << seed;

        for (const Phase phase : phases(complex)) {
            double sum = 0;
            edges.clear();
            const std::vector<VertexLoop> loops = outlines(complex, phase);
            EXPECT_EQ(outlines(complex, phase, collect_interface(complex)), loops);
            for (const VertexLoop& loop : loops) {
                add_edges(complex, loop, true, edges);
                sum += area(complex, loop);
            }
            EXPECT_NEAR(sum, phase_area(complex, phase), 1e-9 * std::max(1.0, sum));
            std::sort(edges.begin(), edges.end());
            std::vector<Edge> expected;
            for (const Edge e : all_simplices(complex).edges()) {
                if ((complex.phase_at(e.id) == phase) !=
                    (complex.phase_at(complex.twin(e.id)) == phase)) {
                    expected.push_back(e);
                }
            }
            ASSERT_EQ(edges, expected) << "seed " << seed;
        }
    }
    EXPECT_GT(open, 500U);
    EXPECT_GT(closed, 50U);
}

} // namespace
} // namespace dsc::outlines_test
