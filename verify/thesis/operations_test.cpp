// SPDX-License-Identifier: MIT
// The operations of the thesis that no default pass calls, on small complexes, in cases that the
// comparison with the reference (reference/equivalence_test.cpp) does not cover. A refused
// operation changes no byte; every result is validated.
#include "support/operations_testing.h"
#include "support/small_meshes.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/ranges.h"
#include "dsc/geometry/predicates.h"
#include "dsc/queries/phases.h"
#include "thesis/operations/ear_clipping.h"
#include "thesis/operations/local_retriangulation.h"
#include "thesis/operations/loop_subdivision.h"
#include "thesis/operations/triangle_collapse.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace dsc::test::thesis_operations_test {
namespace {

template <class Real>
class ThesisOperations : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(ThesisOperations, Reals);

TYPED_TEST(ThesisOperations, AreRefusedWhereThereIsNoTriangle) {
    auto K = hexagon<TypeParam>();
    for (const Triangle none : {Triangle{}, Triangle{border_triangle}, Triangle{7}}) {
        const auto expect_none = [&](auto operation) {
            expect_refused(K, Verdict::not_a_simplex,
                           [&](const auto& submesh) { return operation(submesh, none).verdict; });
        };
        expect_none([](const auto& in, Triangle t) { return loop_subdivision(in, t); });
        expect_none([](const auto& in, Triangle t) { return local_retriangulation(in, t); });
        expect_none([](const auto& in, Triangle t) { return triangle_collapse(in, t); });
    }
}

TYPED_TEST(ThesisOperations, SubdivisionNeedsIds) {
    const auto subdivide = [](const auto& in) { return loop_subdivision(in, Triangle{1}).verdict; };
    const auto K = hexagon<TypeParam>();
    EXPECT_EQ(verdict_with_ids(K, 2, 9, subdivide), Verdict::out_of_ids);
    EXPECT_EQ(verdict_with_ids(K, 9, 4, subdivide), Verdict::out_of_ids);
    EXPECT_EQ(verdict_with_ids(K, 3, 5, subdivide), Verdict::legal);
}

// --- ear clipping and local retriangulation ------------------------------------------------------
TYPED_TEST(ThesisOperations, ClippingIsStuckWithoutEars) {
    using Points = std::vector<Point<TypeParam>>;
    const Points clockwise{{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    const Points flat{{0, 0}, {1, 0}, {2, 0}, {3, 0}};
    const Points with_a_point_twice{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {2, 2}};
    for (const Points& polygon :
         {clockwise, flat, with_a_point_twice, Points{{0, 0}, {1, 0}}, Points{}}) {
        EarClipping work;
        EXPECT_FALSE(ear_clipping(std::span<const Point<TypeParam>>(polygon), work));
    }
}

TYPED_TEST(ThesisOperations, RetriangulationOfAnyDegree) {
    for (const auto method :
         {RetriangulationMethod::ear_clipping, RetriangulationMethod::delaunay}) {
        auto K = wheel<TypeParam>(300);
        const double area = phase_area(K, 0);
        const auto result = local_retriangulation(K, Triangle{1}, method);
        EXPECT_EQ(result.verdict, Verdict::legal);
        EXPECT_EQ(result.vertices_removed, 1U);
        EXPECT_EQ(result.triangles_removed, 2U);
        expect_valid(K);
        EXPECT_EQ(K.triangle_count(), 298U);
        EXPECT_NEAR(phase_area(K, 0), area, 1e-6);
    }
}

TYPED_TEST(ThesisOperations, RetriangulationIsDelaunayWhereThatIsAskedFor) {
    // A long box around one inner vertex, where cutting ears from one corner would make slivers.
    auto K = build<TypeParam>(
        {{0, 0}, {2, 0}, {4, 0}, {6, 0}, {6, 1}, {4, 1}, {2, 1}, {0, 1}, {3, TypeParam(0.5)}},
        {{8, 0, 1}, {8, 1, 2}, {8, 2, 3}, {8, 3, 4}, {8, 4, 5}, {8, 5, 6}, {8, 6, 7}, {8, 7, 0}},
        std::vector<Phase>(8, 0));
    EXPECT_EQ(local_retriangulation(K, Triangle{2}, RetriangulationMethod::delaunay).verdict,
              Verdict::legal);
    expect_valid(K);
    for (const Triangle t : triangles(K)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t.id, i);
            if (is_border(K.twin(c))) {
                continue;
            }
            const auto [a, b, w] = K.vertices_of(t);
            EXPECT_LE(in_circle<TypeParam>(K.position(a), K.position(b), K.position(w),
                                           K.position(Vertex{K.vertex(K.twin(c))})),
                      0);
        }
    }
}

// --- triangle collapse ---------------------------------------------------------------------------
// In the middle of grid(5): its vertices (2, 2), (3, 2) and (2, 3) or (3, 3) are 14, 15 and 20 or
// 21.
constexpr Triangle middle{25};

// Triangle 1 is (0, 2, 1). Vertex 0 has degree three: around it is the triangle (1, 2, 3).
template <class Real>
Complex<Real> with_degree_three() {
    const std::vector<Point<Real>> points{{-1, 0}, {0, 1}, {0, -1}, {-4, 0},
                                          {4, 0},  {0, 6}, {0, -6}};
    return build<Real>(
        points,
        {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 4}, {1, 4, 5}, {1, 5, 3}, {2, 3, 6}, {2, 6, 4}},
        std::vector<Phase>(8, 0));
}

TYPED_TEST(ThesisOperations, ThePlaceOfACollapseBelongsToTheSubmesh) {
    auto K = grid<TypeParam>(5);
    Submesh submesh = Submesh(K);
    submesh.region.kind = Region::Kind::box;
    submesh.region.low = 0.5; // the submesh owns all stars around the middle
    submesh.region.high = 4.5;
    const Point<TypeParam> beyond(TypeParam(0.25), 2);
    EXPECT_EQ(triangle_collapse(submesh, middle, {.place = beyond}).verdict,
              Verdict::on_submesh_boundary);
    EXPECT_EQ(triangle_collapse(submesh, middle).verdict, Verdict::legal);
    expect_valid(K);
}

// The edges of the remaining vertex keep their data, even an edge that would be lost if the vertex
// of degree three were collapsed last.
TYPED_TEST(ThesisOperations, EdgesOfTheVertexThatRemainsKeepTheirData) {
    for (std::uint32_t heir = 0; heir < 3; ++heir) {
        const auto before = with_degree_three<TypeParam>();
        auto K = before;
        auto& data = K.attributes.template add<Edge, double>("far end");
        const auto edge_to = [heir](const auto& complex, std::uint32_t far) {
            return complex.find_edge(Vertex{heir}, Vertex{far});
        };
        for (std::uint32_t far = 3; far < 7; ++far) {
            if (edge_to(K, far).is_valid()) {
                data.set(K, edge_to(K, far), far);
            }
        }
        K.set_locked(Vertex{heir}, true);
        ASSERT_EQ(triangle_collapse(K, Triangle{1}).verdict, Verdict::legal);
        for (std::uint32_t far = 3; far < 7; ++far) {
            if (edge_to(before, far).is_valid()) {
                ASSERT_TRUE(edge_to(K, far).is_valid());
                EXPECT_EQ(data[edge_to(K, far)], far);
            }
        }
    }
}

// All three vertices are on the interface, and one of them is a corner.
TYPED_TEST(ThesisOperations, ACollapseKeepsACorner) {
    for (std::uint32_t i = 0; i < 3; ++i) {
        auto K = grid<TypeParam>(5);
        K.set_phase(middle, 1);
        const auto v = K.vertices_of(middle);
        const Point<TypeParam> centroid =
            (K.position(v[0]) + K.position(v[1]) + K.position(v[2])) / TypeParam(3);
        K.vertices[v[i].id].flags |= vertex_feature;
        const auto result =
            triangle_collapse(K, middle, {.place = centroid, .interface = InterfaceRule::change});
        EXPECT_EQ(result.verdict, Verdict::legal);
        EXPECT_EQ(result.vertex, v[i]);
        expect_valid(K);
    }
}

} // namespace
} // namespace dsc::test::thesis_operations_test
