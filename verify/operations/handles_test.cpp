// SPDX-License-Identifier: MIT
// Operations and guards that an application calls by handles.
#include "support/operations_testing.h"
#include "support/small_meshes.h"

#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"
#include "thesis/local_retriangulation.h"
#include "thesis/loop_subdivision.h"

#include <gtest/gtest.h>

namespace dsc::test::handles_test {
namespace {

template <class Real>
class Handles : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Handles, Reals);

TYPED_TEST(Handles, GuardsTakeHandles) {
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

// Either end may be named, and only that one is tried.
TYPED_TEST(Handles, CollapseMakesTheNamedEndVanish) {
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

TYPED_TEST(Handles, SplitTakesAnyPointOfAnEdge) {
    auto K = grid<TypeParam>(2);
    const Edge side = K.find_edge(Vertex{3}, Vertex{4});
    EXPECT_EQ(edge_split(K, Edge{}, Point<TypeParam>(1, 1)).verdict, Verdict::not_a_simplex);
    const Point<TypeParam> p(TypeParam(0.25), 1);
    const SplitResult result = edge_split(K, side, p);
    EXPECT_EQ(result.verdict, Verdict::legal);
    EXPECT_EQ(K.position(result.vertex), p);
    expect_valid(K);
}

} // namespace
} // namespace dsc::test::handles_test
