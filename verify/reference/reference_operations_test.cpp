// SPDX-License-Identifier: MIT
// The operations of reference/ on cases that can be checked by hand, each with every verdict that
// it can give.
#include "support/reference_testing.h"

#include "dsc/base/error.h"
#include "reference/complex/algebra.h"
#include "reference/operations/ear_clipping.h"
#include "reference/operations/edge_collapse.h"
#include "reference/operations/edge_flip.h"
#include "reference/operations/laplacian_smoothing.h"
#include "reference/operations/local_retriangulation.h"
#include "reference/operations/loop_subdivision.h"

#include <limits>

namespace dsc::reference::reference_operations_test {
namespace {

// --- edge flip, algorithm 7.1
// -----------------------------------------------------------------------

TEST(ReferenceEdgeFlip, FlipsAndKeepsThePhase) {
    Complex K = square({0, 1});
    expect_legal(K, [](Complex& k) { return edge_flip(E(0, 2), k); });
    EXPECT_TRUE(K.is_valid_simplex(T(0, 1, 3)));
    EXPECT_TRUE(K.is_valid_simplex(T(1, 2, 3)));
    EXPECT_FALSE(K.is_valid_simplex(E(0, 2)));
}

TEST(ReferenceEdgeFlip, Verdicts) {
    const auto flip = [](const EdgeKey& e) { return [e](Complex& k) { return edge_flip(e, k); }; };
    expect_refused(square(), Verdict::not_a_simplex, flip(E(1, 3)));
    expect_refused(square(), Verdict::on_boundary, flip(E(0, 1)));
    expect_refused(square({0}), Verdict::on_interface, flip(E(0, 2)));
    Complex K = square();
    K.submesh_boundary_edges = {E(0, 1)};
    expect_refused(K, Verdict::on_submesh_boundary, flip(E(0, 1)));
    const Triples pair{{0, 1, 2}, {0, 2, 3}};
    expect_refused(make({{0, 0}, {1, -1}, {.2, 0}, {1, 1}}, pair), Verdict::inverts, flip(E(0, 2)));
    // Figure 4.1; and the limit of it: 0, 1 and 3 in one line.
    expect_refused(make({{0, 0}, {0, -1}, {1, 0}, {0, 1}}, pair), Verdict::inverts, flip(E(0, 2)));
}

// --- edge split, algorithms 7.6 and 7.2
// -------------------------------------------------------------

TEST(ReferenceEdgeSplit, SplitsInnerAndBoundaryEdges) { // figures 7.5 and 6.9
    Complex K = square({0});
    expect_legal(K, [](Complex& k) { return edge_split(E(0, 2), k); });
    EXPECT_EQ(K.coord(4_v), Point<double>(0.5, 0.5));
    EXPECT_EQ(K.triangles().size(), 4U);
    EXPECT_EQ(K.phase(T(0, 1, 4)), 1U);
    EXPECT_EQ(K.phase(T(0, 3, 4)), 0U);
    EXPECT_TRUE(K.is_interface(E(4, 2)));
    expect_legal(K, [](Complex& k) { return edge_split(E(0, 1), k); });
    EXPECT_EQ(K.triangles().size(), 5U);
    EXPECT_EQ(K.coord(5_v), Point<double>(0.5, 0));
}

TEST(ReferenceEdgeSplit, AsksTheInterpolatorAndTakesAGivenPlace) {
    Complex K = square();
    std::vector<Vertex> asked;
    K.interpolate = [&](Vertex m, Vertex a, Vertex b) { asked = {m, a, b}; };
    expect_legal(K, [](Complex& k) { return edge_split(E(0, 2), k, Point<double>(0.25, 0.5)); });
    EXPECT_EQ(K.coord(4_v), Point<double>(0.25, 0.5));
    EXPECT_EQ(asked, (std::vector{4_v, 0_v, 2_v}));
}

TEST(ReferenceEdgeSplit, Verdicts) {
    Complex K = square();
    K.submesh_boundary_edges = {E(0, 1)};
    expect_refused(K, Verdict::not_a_simplex, [](Complex& k) { return edge_split(E(1, 3), k); });
    expect_refused(K, Verdict::on_submesh_boundary,
                   [](Complex& k) { return edge_split(E(0, 1), k); });
    for (const Point<double>& p : Points{{0, 1}, {2, 2}, {0.5, 1}}) {
        expect_refused(K, Verdict::inverts, [&](Complex& k) { return edge_split(E(0, 2), k, p); });
    }
}

// --- loop subdivision, algorithms 7.4 and 7.3
// -------------------------------------------------------

TEST(ReferenceLoopSubdivision, InTheMiddleAndAtTheBoundary) { // figures 7.2 and 6.6
    const Points points{{0, 0}, {4, 0}, {0, 4}, {4, 4}, {-4, 4}, {4, -4}};
    Complex K = make(points, {{0, 1, 2}, {1, 3, 2}, {0, 2, 4}, {0, 5, 1}});
    EXPECT_EQ(opposite_vertex(T(0, 1, 2), E(1, 2), K), 3_v);
    EXPECT_EQ(opposite_vertex(T(1, 2, 3), E(2, 3), K), std::nullopt);
    expect_legal(K, [](Complex& k) { return loop_subdivision(T(0, 1, 2), k); });
    EXPECT_EQ(K.triangles().size(), 10U);
    EXPECT_EQ(K.vertices().size(), 9U);
    EXPECT_TRUE(K.is_valid_simplex(T(6, 7, 8)));
    EXPECT_EQ(K.coord(6_v), Point<double>(2, 2));
    EXPECT_EQ(K.coord(7_v), Point<double>(0, 2));
    EXPECT_EQ(K.coord(8_v), Point<double>(2, 0));
    EXPECT_TRUE(K.is_valid_simplex(E(3, 6)));
    Complex one = square();
    expect_legal(one, [](Complex& k) { return loop_subdivision(T(0, 1, 2), k); });
    EXPECT_EQ(one.triangles().size(), 6U);
}

TEST(ReferenceLoopSubdivision, Verdicts) {
    const auto loop = [](Complex& k) { return loop_subdivision(T(0, 1, 2), k); };
    expect_refused(square({1}), Verdict::on_interface, loop);
    Complex K = square();
    K.submesh_boundary_edges = {E(1, 2)};
    expect_refused(K, Verdict::on_submesh_boundary, loop);
    K.remove(T(0, 1, 2));
    expect_refused(K, Verdict::not_a_simplex, loop);
    // Half of the smallest number rounds to nothing: the midpoints coincide with the vertices.
    const double tiny = std::numeric_limits<double>::denorm_min();
    expect_refused(make({{0, 0}, {tiny, 0}, {0, tiny}}, {{0, 1, 2}}), Verdict::inverts, loop);
}

// --- ear clipping and local retriangulation, algorithm 7.5
// ------------------------------------------

TEST(ReferenceEarClipping, TakesTheWayOfFigure7_4) {
    // Like the figure's: the first vertex is no ear until the second is cut, the fifth none until
    // the fourth is, and the sixth is skipped.
    const Points polygon{{-3, 2}, {-9, 3}, {1, -6}, {8, -1}, {2, 1}, {0, 3}, {-1, 8}, {-2, 4}};
    const auto ears = ear_clipping(polygon);
    ASSERT_TRUE(ears);
    EXPECT_EQ(*ears, (std::vector<std::array<std::size_t, 3>>{
                         {0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {5, 6, 7}, {5, 7, 0}}));
}

TEST(ReferenceEarClipping, StuckWherePolygonIsNone) {
    EXPECT_FALSE(ear_clipping(Points{{0, 0}, {0, 1}, {1, 1}, {1, 0}})); // clockwise
    EXPECT_FALSE(ear_clipping(Points{{0, 0}, {1, 0}, {2, 0}}));
    EXPECT_FALSE(ear_clipping(Points{{0, 0}, {1, 0}}));
}

TEST(ReferenceEarClipping, FlatCornerIsNoEar) {
    const auto ears = ear_clipping(Points{{1, 0}, {2, 0}, {1, 1}, {0, 0}});
    ASSERT_TRUE(ears);
    EXPECT_EQ(*ears, (std::vector<std::array<std::size_t, 3>>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ReferenceLocalRetriangulation, RemovesTheThreeVerticesInside) { // figures 7.3 and 4.5
    Complex K = grid(5);
    expect_legal(K, [](Complex& k) { return local_retriangulation(T(14, 15, 21), k); });
    EXPECT_EQ(K.vertices().size(), 33U);  // 36 less 3
    EXPECT_EQ(K.triangles().size(), 44U); // 50 less 13 and 7 more
    EXPECT_FALSE(K.is_valid_simplex(14_v));
}

TEST(ReferenceLocalRetriangulation, LeavesTheDomainBoundary) {
    Complex K = grid(5);
    expect_legal(K, [](Complex& k) { return local_retriangulation(T(2, 3, 9), k); });
    EXPECT_EQ(K.vertices().size(), 35U);
    EXPECT_TRUE(K.is_valid_simplex(2_v));
    EXPECT_TRUE(K.is_boundary(E(2, 3)));
}

TEST(ReferenceLocalRetriangulation, Verdicts) {
    const auto at = [](const TriangleKey& t) {
        return [t](Complex& k) { return local_retriangulation(t, k); };
    };
    expect_refused(grid(5), Verdict::not_a_simplex, at(T(14, 15, 20)));
    expect_refused(grid(5, {0}), Verdict::on_interface, at(T(7, 8, 14))); // touches it in vertex 7
    Complex K = grid(5);
    K.submesh_boundary_vertices = {21_v};
    expect_refused(K, Verdict::on_submesh_boundary, at(T(14, 15, 21)));
    K.submesh_boundary_vertices.clear();
    K.locked = {21_v, 2_v};
    expect_refused(K, Verdict::locked, at(T(14, 15, 21)));
    expect_legal(K, at(T(2, 3, 9))); // 2 is on the domain boundary and stays anyway
    Complex mirrored = grid(5);
    for (Vertex v : mirrored.vertices()) {
        mirrored.set_coord(v, {-mirrored.coord(v).x(), mirrored.coord(v).y()});
    }
    expect_refused(mirrored, Verdict::inverts, at(T(14, 15, 21)));
    // Vertex 3 lies in <1, 2, 4>, across an edge of t: only its edge to 4 stays, with a loose end.
    Complex loose = make(
        {{0, 0}, {2, 0}, {0, 2}, {1.5, 1.5}, {4, 4}, {-4, 4}, {4, -4}},
        {{0, 1, 2}, {1, 3, 2}, {1, 4, 3}, {2, 3, 4}, {0, 2, 5}, {0, 6, 1}, {2, 4, 5}, {1, 6, 4}});
    expect_refused(loose, Verdict::not_a_simple_polygon, at(T(0, 1, 2)));
}

// --- edge collapse, algorithm 7.7
// -------------------------------------------------------------------

TEST(ReferenceEdgeCollapse, SmallerNumberVanishesFirst) { // figure 7.6
    Complex K = grid(4);
    expect_legal(K, [](Complex& k) { return edge_collapse(E(12, 13), k); });
    EXPECT_FALSE(K.is_valid_simplex(12_v));
    EXPECT_EQ(K.triangles().size(), 30U);
    EXPECT_TRUE(K.is_valid_simplex(E(11, 13)));
}

TEST(ReferenceEdgeCollapse, TriesTheOtherEnd) { // figure 6.11 (3)
    Complex K = grid(2);
    expect_legal(K, [](Complex& k) { return edge_collapse(E(1, 4), k); }); // 1 is on the boundary
    EXPECT_FALSE(K.is_valid_simplex(4_v));
}

TEST(ReferenceEdgeCollapse, CoarsensAStraightBoundaryAndTheInterface) {
    Complex K = grid(3);
    expect_legal(K, [](Complex& k) { return edge_collapse(E(1, 2), k); });
    EXPECT_TRUE(K.is_boundary(E(0, 2)));
    Complex two = grid(4, {16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31});
    expect_legal(two, [](Complex& k) { return edge_collapse(E(11, 12), k); });
    EXPECT_TRUE(two.is_interface(E(10, 12)));
}

TEST(ReferenceEdgeCollapse, Verdicts) {
    const auto at = [](const EdgeKey& e) {
        return [e](Complex& k) { return edge_collapse(e, k); };
    };
    expect_refused(grid(3), Verdict::not_a_simplex, at(E(1, 4)));
    expect_refused(grid(1), Verdict::on_boundary, at(E(0, 3)));
    expect_refused(grid(1), Verdict::on_boundary, at(E(0, 1))); // corners
    Complex K = grid(4);
    K.submesh_boundary_edges = {E(11, 12)};
    expect_refused(K, Verdict::on_submesh_boundary, at(E(11, 12)));
    K.submesh_boundary_edges.clear();
    K.submesh_boundary_vertices = {11_v, 12_v};
    expect_refused(K, Verdict::on_submesh_boundary, at(E(11, 12)));
    K.submesh_boundary_vertices.clear();
    K.locked = {11_v, 12_v};
    expect_refused(K, Verdict::locked, at(E(11, 12)));
    K.locked = {11_v};
    EXPECT_EQ(edge_collapse(E(11, 12), K), Verdict::legal);
    EXPECT_TRUE(K.is_valid_simplex(11_v));
    // Phase 1 in one column of squares: an edge from side to side, figure 6.11 (6).
    const std::vector<std::size_t> strip{2, 3, 10, 11, 18, 19, 26, 27};
    expect_refused(grid(4, strip), Verdict::on_interface, at(E(11, 12)));
    // A phase of one triangle would vanish with any of its edges.
    expect_refused(grid(4, {10}), Verdict::changes_topology, at(E(6, 7)));
    // The ends 0 and 1 have the neighbour 4 in common, without a triangle: the link condition.
    const Complex pinched =
        make({{-1, 0}, {1, 0}, {0, .5}, {0, -.5}, {0, 2}, {0, -2}, {-3, 0}, {3, 0}}, {{0, 1, 2},
                                                                                      {0, 2, 4},
                                                                                      {1, 4, 2},
                                                                                      {0, 3, 1},
                                                                                      {0, 5, 3},
                                                                                      {1, 3, 5},
                                                                                      {0, 4, 6},
                                                                                      {0, 6, 5},
                                                                                      {1, 7, 4},
                                                                                      {1, 5, 7}});
    expect_refused(pinched, Verdict::changes_topology, at(E(0, 1)));
    // Figure 7.7 at both ends: 1 cannot see <4, 5>, nor 0 <6, 7>.
    const Complex bent = make(
        {{0, 0}, {2, 0}, {1, 3}, {1, -3}, {-.5, .3}, {-4, 2}, {2.5, -.3}, {6, -2}},
        {{0, 1, 2}, {0, 2, 4}, {0, 4, 5}, {0, 5, 3}, {0, 3, 1}, {1, 3, 6}, {1, 6, 7}, {1, 7, 2}});
    expect_refused(bent, Verdict::inverts, at(E(0, 1)));
}

// --- Laplacian smoothing, equation 6
// ----------------------------------------------------------------

TEST(ReferenceSmoothing, MovesToTheMeanOfTheLink) {
    Complex K = fan();
    K.set_coord(0_v, {0.5, 0.3});
    EXPECT_EQ(laplacian_smoothing(0_v, K), Verdict::legal);
    EXPECT_NEAR(K.coord(0_v).norm(), 0, 1e-15);
    EXPECT_NEAR(ring_quality(K, 0_v), 1, 1e-12);
}

TEST(ReferenceSmoothing, Verdicts) {
    const auto at = [](Vertex v) { return [v](Complex& k) { return laplacian_smoothing(v, k); }; };
    Complex K = fan();
    expect_refused(K, Verdict::not_a_simplex, at(7_v));
    expect_refused(K, Verdict::on_boundary, at(1_v));
    expect_refused(K, Verdict::no_gain, at(0_v));
    expect_refused(fan({0}), Verdict::on_interface, at(0_v));
    K.locked = {0_v};
    expect_refused(K, Verdict::locked, at(0_v));
    K.submesh_boundary_vertices = {0_v};
    expect_refused(K, Verdict::on_submesh_boundary, at(0_v));
    // An L: only its corner sees all of it, and the mean lies outside.
    const Complex ell = make({{.5, .5}, {0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}},
                             {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}});
    expect_refused(ell, Verdict::inverts, at(0_v));
}

} // namespace
} // namespace dsc::reference::reference_operations_test
