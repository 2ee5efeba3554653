// SPDX-License-Identifier: MIT
// Edge flip, edge split and edge collapse in cases that the comparison with the reference
// (reference/equivalence_test.cpp) does not cover: handles of no edge, a given end or position,
// exhausted ids, and one figure for each, checked by hand. A refused operation changes no byte;
// every result is validated.
#include "support/operations_testing.h"
#include "support/small_meshes.h"

#include "dsc/base/verdict.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"
#include "dsc/queries/phases.h"
#include "thesis/operations/local_retriangulation.h"
#include "thesis/operations/loop_subdivision.h"

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

TYPED_TEST(Operations, GuardsTakeHandles) {
    const auto K = grid<TypeParam>(3);
    const Edge inside = K.find_edge(Vertex{5}, Vertex{6});
    const Edge side = K.find_edge(Vertex{1}, Vertex{2});
    const Point<TypeParam> middle(TypeParam(1.5), 1);
    EXPECT_EQ(edge_flip_guard(K, inside), edge_flip_guard(K, Region{}, inside.id));
    EXPECT_EQ(edge_flip_guard(K, side), Verdict::on_boundary);
    EXPECT_EQ(edge_split_guard(K, inside, middle), Verdict::legal);
    EXPECT_EQ(edge_split_guard(K, side, middle), Verdict::inverts);
    EXPECT_EQ(edge_collapse_guard(K, inside, Vertex{5}), Verdict::legal);
    EXPECT_EQ(edge_collapse_guard(K, side, Vertex{2}), Verdict::legal);
    EXPECT_EQ(edge_collapse_guard(K, K.find_edge(Vertex{0}, Vertex{1}), Vertex{0}),
              Verdict::on_boundary);
    EXPECT_EQ(loop_subdivision_guard(K, Triangle{1}), Verdict::legal);
    EXPECT_EQ(local_retriangulation_guard(K, Triangle{99}), Verdict::not_a_simplex);
    for (const Edge none : {Edge{}, Edge{border_corner}, Edge{corner_of(99, 0)},
                            Edge{K.twin(inside.id)}, Edge{corner_of(1, 3)}}) {
        EXPECT_EQ(edge_flip_guard(K, none), Verdict::not_a_simplex);
        EXPECT_EQ(edge_split_guard(K, none, middle), Verdict::not_a_simplex);
        EXPECT_EQ(edge_collapse_guard(K, none, Vertex{5}), Verdict::not_a_simplex);
    }
    for (const Vertex none : {Vertex{}, Vertex{0}, Vertex{99}}) {
        EXPECT_EQ(edge_collapse_guard(K, inside, none), Verdict::not_a_simplex);
    }
}

// Either end may be named; only the named one is collapsed.
TYPED_TEST(Operations, CollapseMakesTheNamedEndVanish) {
    for (const std::uint32_t v : {5U, 6U}) {
        auto K = grid<TypeParam>(3);
        const Edge e = K.find_edge(Vertex{5}, Vertex{6});
        EXPECT_EQ(edge_collapse(K, e, Vertex{0}), Verdict::not_a_simplex);
        EXPECT_EQ(edge_collapse(K, Edge{}, Vertex{v}), Verdict::not_a_simplex);
        K.set_locked(Vertex{v}, true);
        EXPECT_EQ(edge_collapse(K, e, Vertex{v}), Verdict::locked);
        EXPECT_EQ(K.vertex_count(), 16U);
        K.set_locked(Vertex{v}, false);
        EXPECT_EQ(edge_collapse(K, e, Vertex{v}), Verdict::legal);
        expect_valid(K);
        EXPECT_FALSE(K.is_alive(Vertex{v}));
        EXPECT_TRUE(K.is_alive(Vertex{11 - v}));
    }
}

TYPED_TEST(Operations, AreRefusedWhereThereIsNoEdge) {
    auto K = square<TypeParam>();
    const Edge diagonal = K.find_edge(Vertex{0}, Vertex{2});
    for (const Edge none : {Edge{}, Edge{border_corner}, Edge{corner_of(7, 0)},
                            Edge{corner_of(1, 3)}, Edge{K.twin(diagonal.id)}}) {
        const auto refuse = [&](auto operate) {
            expect_refused(K, Verdict::not_a_simplex, operate);
        };
        refuse([none](const auto& submesh) { return edge_flip(submesh, none); });
        refuse([none](const auto& submesh) { return edge_split(submesh, none).verdict; });
        refuse([none](const auto& submesh) { return edge_collapse(submesh, none); });
        refuse([none](const auto& submesh) {
            return edge_split(submesh, none, Point<TypeParam>(1, 1)).verdict;
        });
    }
}

TYPED_TEST(Operations, FlipTurnsTheDiagonal) {
    auto K = square<TypeParam>();
    EXPECT_EQ(edge_flip(K, K.find_edge(Vertex{0}, Vertex{2})), Verdict::legal);
    expect_valid(K);
    EXPECT_TRUE(K.find_edge(Vertex{1}, Vertex{3}).is_valid());
    EXPECT_EQ(K.triangle_count(), 2U);
}

TYPED_TEST(Operations, SplitCutsBothTriangles) {
    auto K = square<TypeParam>(1, 2);
    const auto [verdict, m] = edge_split(K, K.find_edge(Vertex{0}, Vertex{2}));
    EXPECT_EQ(verdict, Verdict::legal);
    expect_valid(K);
    EXPECT_EQ(K.position(m), Point<TypeParam>(1, 1));
    EXPECT_EQ(K.triangle_count(), 4U);
    EXPECT_EQ(phase_area(K, 1), 2);
    EXPECT_EQ(phase_area(K, 2), 2);
}

// The position may be on the edge, or beside it if no triangle is inverted; for an edge of the
// domain boundary also outside.
TYPED_TEST(Operations, SplitTakesAPlace) {
    for (const auto& [from, to, place] :
         {std::tuple{0U, 2U, Point<TypeParam>(TypeParam(0.5), TypeParam(0.75))},
          {0U, 1U, Point<TypeParam>(TypeParam(0.5), TypeParam(-0.25))}}) {
        auto K = square<TypeParam>();
        const auto result = edge_split(K, K.find_edge(Vertex{from}, Vertex{to}), place);
        EXPECT_EQ(result.verdict, Verdict::legal);
        EXPECT_EQ(K.position(result.vertex), place);
        expect_valid(K);
    }
    auto K = square<TypeParam>();
    for (const auto& [from, to, x, y] :
         {std::array{0, 2, 0, 0}, {0, 2, 1, 0}, {0, 2, 3, 3}, {0, 1, 1, 1}}) {
        const Edge e =
            K.find_edge(Vertex{static_cast<unsigned>(from)}, Vertex{static_cast<unsigned>(to)});
        const Point<TypeParam> place(static_cast<TypeParam>(x), static_cast<TypeParam>(y));
        expect_refused(K, Verdict::inverts,
                       [=](const auto& submesh) { return edge_split(submesh, e, place).verdict; });
    }
}

TYPED_TEST(Operations, SplitNeedsIds) {
    const auto K = square<TypeParam>();
    const auto split = [&](std::uint32_t to) {
        return [e = K.find_edge(Vertex{0}, Vertex{to})](const auto& submesh) {
            return edge_split(submesh, e).verdict;
        };
    };
    EXPECT_EQ(verdict_with_ids(K, 0, 9, split(2)), Verdict::out_of_ids);
    EXPECT_EQ(verdict_with_ids(K, 9, 1, split(2)), Verdict::out_of_ids);
    EXPECT_EQ(verdict_with_ids(K, 1, 2, split(2)), Verdict::legal);
    EXPECT_EQ(verdict_with_ids(K, 9, 0, split(1)), Verdict::out_of_ids);
    EXPECT_EQ(verdict_with_ids(K, 1, 1, split(1)), Verdict::legal);
}

TYPED_TEST(Operations, SplitOfTheSmallestTriangleInverts) {
    // The midpoint of two adjacent floating-point numbers is rounded to one of them.
    const TypeParam one = 1;
    const TypeParam after = std::nextafter(one, TypeParam(2));
    auto K = build<TypeParam>({{one, one}, {after, one}, {one, after}}, {{0, 1, 2}}, {0});
    expect_refused(K, Verdict::inverts, [](const auto& submesh) {
        return edge_split(submesh, submesh.complex.find_edge(Vertex{0}, Vertex{1})).verdict;
    });
}

// Three vertices of a side are on one line, along whichever direction: rounding gives them an area.
TYPED_TEST(Operations, CollapseMakesNoTriangleOfThreeVerticesOfASide) {
    using Real = TypeParam;
    int rounded = 0;
    for (int i = 1; i < 100; ++i) {
        const Point<Real> a(Real(0.1), Real(0.3));
        const Point<Real> c(Real(0.1 + 0.03 * i), Real(0.7 + 0.01 * i));
        const Point<Real> b = a + Real(0.37) * (c - a);
        const Point<Real> up(a.y() - c.y(), c.x() - a.x());
        const auto K = build<Real>({a, b, c, a + up, b + up / 4},
                                   {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}, {0, 0, 0, 0});
        const auto guard = [&](std::uint32_t side) {
            const Edge e = K.find_edge(Vertex{side}, Vertex{4});
            return edge_collapse_guard(K, Region{}, e.id, *end_of(K, e, Vertex{4}),
                                       JunctionRule::kept, BoundaryRule::smooth);
        };
        EXPECT_EQ(guard(2), Verdict::inverts) << i;
        EXPECT_EQ(guard(1), Verdict::legal) << i;
        rounded += orientation<Real>(a, b, c) > 0 ? 1 : 0;
    }
    EXPECT_GT(rounded, 20) << "the test has lost its point";
}

// Along a straight side of the domain, and towards the submesh boundary (figure 6.12).
TYPED_TEST(Operations, CollapseKeepsTheDomainAndTheSubmeshBoundary) {
    auto K = grid<TypeParam>(2);
    EXPECT_EQ(edge_collapse(K, K.find_edge(Vertex{0}, Vertex{1})), Verdict::legal);
    expect_valid(K);
    EXPECT_TRUE(K.is_alive(Vertex{0})) << "a corner of the domain";
    EXPECT_EQ(phase_area(K, 0), 4);

    auto J = grid<TypeParam>(2);
    J.set_boundary_feature(Vertex{1}, true);
    EXPECT_EQ(edge_collapse_guard(J, J.find_edge(Vertex{0}, Vertex{1}), Vertex{1}),
              Verdict::on_boundary);
    J.set_boundary_feature(Vertex{1}, false);
    EXPECT_EQ(edge_collapse_guard(J, J.find_edge(Vertex{0}, Vertex{1}), Vertex{1}), Verdict::legal);

    auto L = grid<TypeParam>(4);
    std::vector<std::uint32_t> labels(25);
    for (std::uint32_t v = 0; v < 25; ++v) {
        labels[v] = v % 5 < 3 ? 1 : 0; // columns 0 to 2; column 2 is the submesh boundary
    }
    EXPECT_EQ(edge_collapse(submesh_of(L, labels), L.find_edge(Vertex{11}, Vertex{12})),
              Verdict::legal);
    expect_valid(L);
    EXPECT_TRUE(L.is_alive(Vertex{12}));
}

} // namespace
} // namespace dsc::test::operations_test
