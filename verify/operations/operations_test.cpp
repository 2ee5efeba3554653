// SPDX-License-Identifier: MIT
// Edge flip, edge split and edge collapse on hand-sized complexes: each verdict, each result. A
// refused operation changes no byte; every result is validated.
#include "support/operations_testing.h"
#include "support/small_meshes.h"

#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"
#include "dsc/queries/phases.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsc::test::operations_test {
namespace {

template <class Real>
class Operations : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Operations, Reals);

// (0, 0), (2, 0), (2, 2), (0, 2), cut from 0 to 2.
template <class Real>
Complex<Real> square(Phase lower = 0, Phase upper = 0) {
    return build<Real>({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{0, 1, 2}, {0, 2, 3}}, {lower, upper});
}

// --- edge flip -----------------------------------------------------------------------------------

TYPED_TEST(Operations, FlipTurnsTheDiagonal) {
    auto K = square<TypeParam>();
    const Edge e = K.find_edge(Vertex{0}, Vertex{2});
    EXPECT_EQ(edge_flip(K, e), Verdict::legal);
    expect_valid(K);
    EXPECT_FALSE(K.find_edge(Vertex{0}, Vertex{2}).is_valid());
    EXPECT_TRUE(K.find_edge(Vertex{1}, Vertex{3}).is_valid());
    EXPECT_EQ(K.triangle_count(), 2U);
}

TYPED_TEST(Operations, FlipIsRefused) {
    auto K = square<TypeParam>();
    const Edge diagonal = K.find_edge(Vertex{0}, Vertex{2});
    const Edge side = K.find_edge(Vertex{0}, Vertex{1});
    const auto flip = [](Edge e) {
        return [e](const auto& submesh) { return edge_flip(submesh, e); };
    };
    expect_refused(K, Verdict::not_a_simplex, flip(Edge{}));
    expect_refused(K, Verdict::not_a_simplex, flip(Edge{corner_of(7, 0)}));
    expect_refused(K, Verdict::not_a_simplex, flip(Edge{corner_of(1, 3)}));
    expect_refused(K, Verdict::not_a_simplex, flip(Edge{border_corner}));
    expect_refused(K, Verdict::not_a_simplex, flip(Edge{K.twin(diagonal.id)})); // the other corner
    expect_refused(K, Verdict::on_boundary, flip(side));
    expect_refused(K, Verdict::on_submesh_boundary, flip(diagonal), {1, 1, 1, 0});
    expect_refused(K, Verdict::on_submesh_boundary, flip(side), {1, 1, 0, 0});
    auto two_phases = square<TypeParam>(1, 2);
    expect_refused(two_phases, Verdict::on_interface, flip(diagonal));
}

TYPED_TEST(Operations, FlipOfAQuadrilateralThatIsNotStrictlyConvexInverts) {
    // The quadrilateral (0, 1, 2, 3), cut from 1 to 3, is reflex at 1, or flat.
    for (const TypeParam y : {TypeParam(0.5), TypeParam(0)}) {
        auto K = build<TypeParam>({{0, 0}, {1, y}, {2, 0}, {1, 2}}, {{0, 1, 3}, {1, 2, 3}}, {0, 0});
        expect_refused(K, Verdict::inverts, [](const auto& submesh) {
            return edge_flip(submesh, submesh.complex.find_edge(Vertex{1}, Vertex{3}));
        });
    }
}

// --- edge split ----------------------------------------------------------------------------------

TYPED_TEST(Operations, SplitCutsBothTriangles) {
    auto K = square<TypeParam>(1, 2);
    const auto [verdict, m] = edge_split(K, K.find_edge(Vertex{0}, Vertex{2}));
    EXPECT_EQ(verdict, Verdict::legal);
    expect_valid(K);
    EXPECT_EQ(K.vertex_count(), 5U);
    EXPECT_EQ(K.triangle_count(), 4U);
    EXPECT_EQ(K.position(m), Point<TypeParam>(1, 1));
    for (std::uint32_t v = 0; v < 4; ++v) {
        EXPECT_TRUE(K.find_edge(m, Vertex{v}).is_valid());
    }
    EXPECT_EQ(phase_area(K, 1), 2);
    EXPECT_EQ(phase_area(K, 2), 2);
}

TYPED_TEST(Operations, SplitOfABoundaryEdgeCutsOneTriangle) {
    auto K = square<TypeParam>();
    const auto [verdict, m] = edge_split(Submesh(K), K.find_edge(Vertex{0}, Vertex{1}),
                                         Point<TypeParam>(TypeParam(0.5), TypeParam(-0.25)));
    EXPECT_EQ(verdict, Verdict::legal);
    expect_valid(K);
    EXPECT_EQ(K.triangle_count(), 3U);
    EXPECT_TRUE(is_boundary(K, m));
}

TYPED_TEST(Operations, SplitIsRefused) {
    auto K = square<TypeParam>();
    const Edge diagonal = K.find_edge(Vertex{0}, Vertex{2});
    const Edge side = K.find_edge(Vertex{0}, Vertex{1});
    const auto split = [](Edge e) {
        return [e](const auto& submesh) { return edge_split(submesh, e).verdict; };
    };
    const auto split_at = [](Edge e, TypeParam x, TypeParam y) {
        return [=](const auto& submesh) {
            return edge_split(submesh, e, Point<TypeParam>(x, y)).verdict;
        };
    };
    expect_refused(K, Verdict::not_a_simplex, split(Edge{}));
    expect_refused(K, Verdict::not_a_simplex, split_at(Edge{}, 1, 1));
    expect_refused(K, Verdict::on_submesh_boundary, split(diagonal), {0, 1, 1, 1});
    expect_refused(K, Verdict::on_submesh_boundary, split(diagonal), {1, 1, 1, 0});
    expect_refused(K, Verdict::on_submesh_boundary, split(side), {1, 1, 0, 1});
    expect_refused(K, Verdict::inverts, split_at(diagonal, 0, 0));
    expect_refused(K, Verdict::inverts, split_at(diagonal, 1, 0));
    expect_refused(K, Verdict::inverts, split_at(diagonal, 3, 3));
    expect_refused(K, Verdict::inverts, split_at(side, 1, 1));
    EXPECT_EQ(verdict_with_ids(K, 0, 9, split(diagonal)), Verdict::out_of_ids);
    EXPECT_EQ(verdict_with_ids(K, 9, 1, split(diagonal)), Verdict::out_of_ids);
    EXPECT_EQ(verdict_with_ids(K, 1, 2, split(diagonal)), Verdict::legal);
    EXPECT_EQ(verdict_with_ids(K, 9, 0, split(side)), Verdict::out_of_ids);
    EXPECT_EQ(verdict_with_ids(K, 1, 1, split(side)), Verdict::legal);
}

// --- edge collapse -------------------------------------------------------------------------------

TYPED_TEST(Operations, CollapseTakesTheSmallerIdFirst) {
    auto K = grid<TypeParam>(3);
    // 5, 6, 9, 10 are inside.
    EXPECT_EQ(edge_collapse(K, K.find_edge(Vertex{5}, Vertex{6})), Verdict::legal);
    expect_valid(K);
    EXPECT_FALSE(K.is_alive(Vertex{5}));
    EXPECT_TRUE(K.is_alive(Vertex{6}));
    EXPECT_EQ(K.triangle_count(), 16U);
    EXPECT_EQ(K.vertex_count(), 15U);
}

TYPED_TEST(Operations, CollapseTriesTheOtherEnd) {
    auto K = grid<TypeParam>(3);
    K.set_locked(Vertex{5}, true);
    EXPECT_EQ(edge_collapse(K, K.find_edge(Vertex{5}, Vertex{6})), Verdict::legal);
    expect_valid(K);
    EXPECT_TRUE(K.is_alive(Vertex{5}));
    EXPECT_FALSE(K.is_alive(Vertex{6}));
}

TYPED_TEST(Operations, CollapseAlongAStraightBoundary) {
    auto K = grid<TypeParam>(2);
    EXPECT_EQ(edge_collapse(K, K.find_edge(Vertex{0}, Vertex{1})), Verdict::legal); // 0 is a corner
    expect_valid(K);
    EXPECT_TRUE(K.is_alive(Vertex{0}));
    EXPECT_FALSE(K.is_alive(Vertex{1}));
    EXPECT_EQ(phase_area(K, 0), 4);
}

TYPED_TEST(Operations, CollapseKeepsTheShapeOfTheDomain) {
    auto K = hexagon<TypeParam>();
    // Between two corners of the domain, and from a corner into the middle.
    expect_refused(K, Verdict::on_boundary, collapse_between(1, 2));
    auto H = hexagon<TypeParam>();
    EXPECT_EQ(edge_collapse(H, H.find_edge(Vertex{0}, Vertex{1})), Verdict::legal); // 0 goes
    expect_valid(H);
    EXPECT_FALSE(H.is_alive(Vertex{0}));
    K.set_locked(Vertex{0}, true);
    expect_refused(K, Verdict::locked, collapse_between(0, 1));
    // Both on a straight side, but the edge runs through the inside.
    auto S = square<TypeParam>();
    for (const std::uint32_t v : {0U, 2U}) { // midpoints of two sides: vertices 4 and 5
        edge_split(S, S.find_edge(Vertex{v}, Vertex{v + 1}));
    }
    edge_flip(S, S.find_edge(Vertex{0}, Vertex{2}));
    expect_valid(S);
    ASSERT_TRUE(S.find_edge(Vertex{4}, Vertex{5}).is_valid());
    expect_refused(S, Verdict::on_boundary, collapse_between(4, 5));
}

// A strip of four quadrilaterals of two phases: the interface runs through 5 to 9.
//   10 11 12 13 14   (phase 2 below, phase 1 under the middle row)
//    5  6  7  8  9
//    0  1  2  3  4
template <class Real>
Complex<Real> strip(Real bump = 0) {
    std::vector<Point<Real>> points;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 5; ++i) {
            const Real y = static_cast<Real>(j);
            points.emplace_back(static_cast<Real>(i), j == 1 && i == 2 ? y + bump : y);
        }
    }
    std::vector<Indices> triangles;
    std::vector<Phase> phases;
    for (std::uint32_t j = 0; j < 2; ++j) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t a = 5 * j + i;
            triangles.push_back({a, a + 1, a + 6});
            triangles.push_back({a, a + 6, a + 5});
            phases.insert(phases.end(), {j == 0 ? 1U : 2U, j == 0 ? 1U : 2U});
        }
    }
    return build<Real>(points, triangles, phases);
}

TYPED_TEST(Operations, CollapseCoarsensTheInterface) {
    auto K = strip<TypeParam>();
    EXPECT_EQ(edge_collapse(K, K.find_edge(Vertex{6}, Vertex{7})), Verdict::legal);
    expect_valid(K);
    EXPECT_FALSE(K.is_alive(Vertex{6}));
    EXPECT_TRUE(is_interface(K, K.find_edge(Vertex{5}, Vertex{7})));
    EXPECT_EQ(phase_area(K, 1), 4);
}

TYPED_TEST(Operations, CollapseKeepsTheInterface) {
    auto K = strip<TypeParam>();
    // Off the interface: the boundary vertex cannot go, nor the interface vertex.
    expect_refused(K, Verdict::on_boundary, collapse_between(2, 7));
    expect_refused(K, Verdict::on_interface, collapse_between(7, 12));
    // Where three phases meet, the interface vertex 7 has more than two interface edges.
    auto J = strip<TypeParam>();
    for (std::uint32_t t = 1; t < J.triangle_bound(); ++t) {
        const auto [a, b, c] = J.vertices_of(Triangle{t});
        const auto x = (J.position(a) + J.position(b) + J.position(c)).x();
        if (J.phase(Triangle{t}) == 2 && x > 6) {
            J.set_phase(Triangle{t}, 3);
        }
    }
    J.set_locked(Vertex{6}, true);
    expect_refused(J, Verdict::locked, collapse_between(6, 7));
    J.set_locked(Vertex{6}, false);
    J.set_locked(Vertex{8}, true);
    expect_refused(J, Verdict::on_interface, collapse_between(7, 8));
}

TYPED_TEST(Operations, CollapseMustNotFoldTheInterface) {
    // Triangle (5, 6, 10) of phase 1 has two interface edges: they would fall onto each other.
    auto K = grid<TypeParam>(3);
    const Corner inside = K.find_half_edge(Vertex{5}, Vertex{6});
    K.set_phase(Triangle{triangle_of(inside)}, 1);
    const std::uint32_t apex = K.vertex(inside);
    expect_refused(K, Verdict::changes_topology, collapse_between(5, 6));
    expect_refused(K, Verdict::changes_topology, collapse_between(5, apex));
}

TYPED_TEST(Operations, CollapseKeepsTheLinkCondition) {
    // 0 and 1 have a third common neighbour, 4, beyond the triangle (0, 1, 3): around 3, which has
    // degree three, the triangles would fall onto each other.
    auto K = build<TypeParam>({{0, 0}, {6, 0}, {3, -4}, {3, 2}, {3, 6}, {-8, 3}, {14, 3}, {3, -12}},
                              {{0, 1, 3},
                               {0, 2, 1},
                               {0, 3, 4},
                               {3, 1, 4},
                               {0, 4, 5},
                               {4, 1, 6},
                               {5, 7, 0},
                               {0, 7, 2},
                               {2, 7, 1},
                               {1, 7, 6}},
                              std::vector<Phase>(10, 0));
    expect_refused(K, Verdict::changes_topology, collapse_between(0, 1));
}

TYPED_TEST(Operations, CollapseMustNotInvert) {
    // A dart: 0 sees 3 past the reflex corner 2, but the triangle at (1, 2) would turn over.
    auto K = build<TypeParam>({{0, 0}, {4, -4}, {1, 0}, {4, 4}, {-4, 0}},
                              {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}, {0, 0, 0, 0});
    expect_refused(K, Verdict::inverts, collapse_between(0, 3));
    EXPECT_EQ(edge_collapse(K, K.find_edge(Vertex{0}, Vertex{2})), Verdict::legal);
    expect_valid(K);
}

TYPED_TEST(Operations, CollapseIsRefusedOutsideAndOnTheSubmeshBoundary) {
    auto K = grid<TypeParam>(4);
    std::vector<std::uint32_t> labels(25, 1);
    for (std::uint32_t v = 0; v < 25; ++v) {
        labels[v] = v % 5 < 3 ? 1 : 0; // columns 0 to 2; column 2 is the submesh boundary
    }
    expect_refused(K, Verdict::not_a_simplex,
                   [](const auto& submesh) { return edge_collapse(submesh, Edge{}); });
    expect_refused(K, Verdict::on_submesh_boundary, collapse_between(12, 13), labels);
    expect_refused(K, Verdict::on_submesh_boundary, collapse_between(7, 12), labels);
    expect_refused(K, Verdict::on_submesh_boundary, collapse_between(3, 4), labels);
    // Towards the submesh boundary it is legal: figure 6.12.
    Submesh submesh = submesh_of(K, labels);
    EXPECT_EQ(edge_collapse(submesh, K.find_edge(Vertex{11}, Vertex{12})), Verdict::legal);
    expect_valid(K);
    EXPECT_FALSE(K.is_alive(Vertex{11}));
}

TYPED_TEST(Operations, SplitOfTheSmallestTriangleInverts) {
    // The midpoint of two neighbouring numbers is one of them.
    const TypeParam one = 1;
    const TypeParam after = std::nextafter(one, TypeParam(2));
    auto K = build<TypeParam>({{one, one}, {after, one}, {one, after}}, {{0, 1, 2}}, {0});
    expect_refused(K, Verdict::inverts, [](const auto& submesh) {
        return edge_split(submesh, submesh.complex.find_edge(Vertex{0}, Vertex{1})).verdict;
    });
}

} // namespace
} // namespace dsc::test::operations_test
