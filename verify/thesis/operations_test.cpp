// SPDX-License-Identifier: MIT
// The operations of the thesis that no default pass calls, on hand-sized complexes: what their
// comparison with the reference (reference/equivalence_test.cpp) does not ask for. A refused
// operation changes no byte; every result is validated.
#include "support/operations_testing.h"
#include "support/small_meshes.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/geometry/predicates.h"
#include "dsc/queries/phases.h"
#include "thesis/operations/ear_clipping.h"
#include "thesis/operations/local_retriangulation.h"
#include "thesis/operations/loop_subdivision.h"
#include "thesis/operations/triangle_collapse.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace dsc::test::thesis_operations_test {
namespace {

using Reals = testing::Types<double, float>;

// --- loop subdivision ----------------------------------------------------------------------------
template <class Real>
class LoopSubdivision : public testing::Test {};
TYPED_TEST_SUITE(LoopSubdivision, Reals);

TYPED_TEST(LoopSubdivision, IsRefused) {
    const auto subdivide = [](Triangle t) {
        return [t](const auto& submesh) { return loop_subdivision(submesh, t).verdict; };
    };
    auto K = hexagon<TypeParam>();
    expect_refused(K, Verdict::not_a_simplex, subdivide(Triangle{}));
    expect_refused(K, Verdict::not_a_simplex, subdivide(Triangle{border_triangle}));
    expect_refused(K, Verdict::not_a_simplex, subdivide(Triangle{7}));
    // Triangle 1 is (0, 1, 2), and vertex 3 is beyond it.
    expect_refused(K, Verdict::on_submesh_boundary, subdivide(Triangle{1}), {1, 1, 1, 0, 1, 1, 1});
    EXPECT_EQ(verdict_with_ids(K, 2, 9, subdivide(Triangle{1})), Verdict::out_of_ids);
    EXPECT_EQ(verdict_with_ids(K, 9, 4, subdivide(Triangle{1})), Verdict::out_of_ids);
    EXPECT_EQ(verdict_with_ids(K, 3, 5, subdivide(Triangle{1})), Verdict::legal);
    // The domain boundary of another phase than the exterior is interface (figure 8.3).
    auto inner = build<TypeParam>({{0, 0}, {2, 0}, {0, 2}}, {{0, 1, 2}}, {1});
    expect_refused(inner, Verdict::on_interface, subdivide(Triangle{1}));
}

// --- ear clipping and local retriangulation ------------------------------------------------------
template <class Real>
class Retriangulation : public testing::Test {};
TYPED_TEST_SUITE(Retriangulation, Reals);

using Ears = std::vector<Indices>;

// The ears in the order of cutting; empty where clipping gets stuck.
template <class Real>
Ears clip(const std::vector<Point<Real>>& polygon) {
    EarClipping work;
    const bool done = ear_clipping(std::span<const Point<Real>>(polygon), work);
    return done ? work.triangles : Ears{};
}

TYPED_TEST(Retriangulation, WhatHasNoEarsIsStuck) {
    using Points = std::vector<Point<TypeParam>>;
    EXPECT_TRUE(clip(Points{{0, 0}, {0, 1}, {1, 1}, {1, 0}}).empty()); // clockwise
    EXPECT_TRUE(clip(Points{{0, 0}, {1, 0}, {2, 0}, {3, 0}}).empty()); // flat
    EXPECT_TRUE(clip(Points{{0, 0}, {1, 0}, {2, 0}}).empty());
    EXPECT_TRUE(clip(Points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {2, 2}}).empty());
    EXPECT_TRUE(clip(Points{{0, 0}, {1, 0}}).empty());
    EXPECT_TRUE(clip(Points{}).empty());
}

TYPED_TEST(Retriangulation, TakesTheVerticesOfTheTriangleOut) {
    for (const auto method :
         {RetriangulationMethod::ear_clipping, RetriangulationMethod::delaunay}) {
        auto K = grid<TypeParam>(6, 0.1, 3);
        const Triangle t{triangle_of(K.find_half_edge(Vertex{16}, Vertex{17}))};
        const auto corners = K.vertices_of(t);
        const auto triangles = K.triangle_count();
        const auto vertices = K.vertex_count();
        const auto result = local_retriangulation(K, t, method);
        EXPECT_EQ(result.verdict, Verdict::legal);
        expect_valid(K);
        EXPECT_EQ(result.vertices_removed, 3U);
        EXPECT_EQ(result.triangles_removed, 6U);
        EXPECT_EQ(K.vertex_count(), vertices - 3);
        EXPECT_EQ(K.triangle_count(), triangles - 6);
        EXPECT_TRUE(K.is_alive(t));
        for (const Vertex v : corners) {
            EXPECT_FALSE(K.is_alive(v));
        }
        EXPECT_NEAR(phase_area(K, 0), 36, 1e-5);
    }
}

TYPED_TEST(Retriangulation, IsRefusedAsItsGuardSays) {
    auto K = grid<TypeParam>(6);
    const Triangle t{triangle_of(K.find_half_edge(Vertex{16}, Vertex{17}))};
    const auto retriangulate = [](Triangle one) {
        return [one](const auto& submesh) {
            const Verdict said = local_retriangulation_guard(submesh.complex, one, submesh.region);
            const Verdict verdict = local_retriangulation(submesh, one).verdict;
            EXPECT_EQ(said, verdict);
            return verdict;
        };
    };
    expect_refused(K, Verdict::not_a_simplex, retriangulate(Triangle{}));
    expect_refused(K, Verdict::not_a_simplex, retriangulate(Triangle{border_triangle}));
    expect_refused(K, Verdict::not_a_simplex, retriangulate(Triangle{73}));
    K.set_locked(Vertex{17}, true);
    expect_refused(K, Verdict::locked, retriangulate(t));
    // A triangle of another phase that shares a vertex: the interface comes before the lock.
    K.set_phase(Triangle{triangle_of(K.twin(K.find_half_edge(Vertex{9}, Vertex{16})))}, 1);
    expect_refused(K, Verdict::on_interface, retriangulate(t));
}

TYPED_TEST(Retriangulation, AnyDegree) {
    for (const auto method :
         {RetriangulationMethod::ear_clipping, RetriangulationMethod::delaunay}) {
        auto K = wheel<TypeParam>(300);
        const double area = phase_area(K, 0);
        EXPECT_EQ(local_retriangulation(K, Triangle{1}, method).verdict, Verdict::legal);
        expect_valid(K);
        EXPECT_EQ(K.triangle_count(), 298U);
        EXPECT_NEAR(phase_area(K, 0), area, 1e-6);
    }
}

TYPED_TEST(Retriangulation, DelaunayIsDelaunay) {
    // A long box around one inner vertex: ears from one corner make slivers.
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
template <class Real>
class TriangleCollapse : public testing::Test {};
TYPED_TEST_SUITE(TriangleCollapse, Reals);

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

TYPED_TEST(TriangleCollapse, ThreeVerticesBecomeOneAtTheCentroid) {
    auto K = grid<TypeParam>(5);
    const auto [a, b, c] = K.vertices_of(middle);
    const Point<TypeParam> centroid =
        (K.position(a) + K.position(b) + K.position(c)) / TypeParam(3);
    const std::uint32_t vertices_before = K.vertex_count();
    const std::uint32_t triangles_before = K.triangle_count();
    const auto result = triangle_collapse(K, middle);
    ASSERT_EQ(result.verdict, Verdict::legal);
    expect_valid(K);
    EXPECT_EQ(result.vertex, std::min({a, b, c}));
    EXPECT_EQ(K.position(result.vertex), centroid);
    EXPECT_EQ(K.vertex_count(), vertices_before - 2);
    EXPECT_EQ(K.triangle_count(), triangles_before - 4);
    EXPECT_NEAR(phase_area(K, 0), 25, 1e-5);
    EXPECT_FALSE(K.is_alive(middle));
    EXPECT_EQ(K.journal.counts.collapses, 2U);
}

TYPED_TEST(TriangleCollapse, IsRefusedWhereThereIsNoTriangle) {
    auto K = grid<TypeParam>(5);
    for (const Triangle none : {Triangle{}, Triangle{border_triangle}}) {
        expect_refused(K, Verdict::not_a_simplex, [none](const auto& submesh) {
            return triangle_collapse(submesh, none).verdict;
        });
    }
}

TYPED_TEST(TriangleCollapse, ThePlaceBelongsToTheSubmesh) {
    auto K = grid<TypeParam>(5);
    Submesh submesh = Submesh(K);
    submesh.region.kind = Region::Kind::box;
    submesh.region.low = 0.5; // owns all stars of the middle
    submesh.region.high = 4.5;
    const Point<TypeParam> beyond(TypeParam(0.25), 2);
    EXPECT_EQ(triangle_collapse(submesh, middle, {.place = beyond}).verdict,
              Verdict::on_submesh_boundary);
    EXPECT_EQ(triangle_collapse(submesh, middle).verdict, Verdict::legal);
    expect_valid(K);
}

TYPED_TEST(TriangleCollapse, APlaceThatIsNotFiniteIsBadInput) {
    auto K = grid<TypeParam>(5);
    const TypeParam nan = std::numeric_limits<TypeParam>::quiet_NaN();
    EXPECT_THROW((void)triangle_collapse(K, middle, {.place = {{nan, 1}}}), InputError);
}

// The edges that the remaining vertex had keep their data, even one that would be lost from sight
// if the vertex of degree three went last.
TYPED_TEST(TriangleCollapse, EdgesOfTheVertexThatRemainsKeepTheirData) {
    for (std::uint32_t heir = 0; heir < 3; ++heir) {
        auto K = with_degree_three<TypeParam>();
        auto& data = K.attributes.template add<Edge, double>("name");
        const auto name = [](Vertex a, Vertex b) { return a.id + 10.0 * b.id; };
        for (std::uint32_t a = 0; a < 7; ++a) {
            for (std::uint32_t b = a + 1; b < 7; ++b) {
                if (const Edge e = K.find_edge(Vertex{a}, Vertex{b}); e.is_valid()) {
                    data.set(K, e, name(Vertex{a}, Vertex{b}));
                }
            }
        }
        std::vector<Vertex> known;
        for (std::uint32_t w = 3; w < 7; ++w) {
            if (K.find_edge(Vertex{heir}, Vertex{w}).is_valid()) {
                known.push_back(Vertex{w});
            }
        }
        K.set_locked(Vertex{heir}, true);
        ASSERT_EQ(triangle_collapse(K, Triangle{1}).verdict, Verdict::legal);
        for (const Vertex w : known) {
            const Edge e = K.find_edge(Vertex{heir}, w);
            ASSERT_TRUE(e.is_valid());
            EXPECT_EQ(data[e], name(Vertex{heir}, w));
        }
    }
}

// Two sheets with a gap of one row of squares between them: 2 < y < 3 is exterior.
template <class Real>
Complex<Real> two_sheets() {
    auto K = grid<Real>(6);
    for (const Triangle t : triangles(K)) {
        const auto [a, b, c] = K.vertices_of(t);
        const Real y = (K.position(a) + K.position(b) + K.position(c)).y() / 3;
        K.set_phase(t, y > 2 && y < 3 ? 0 : y < 2 ? 1 : 2);
    }
    return K;
}

// All three vertices are on the interface, and one of them is a corner.
TYPED_TEST(TriangleCollapse, ACornerIsKept) {
    const auto K = two_sheets<TypeParam>();
    const Triangle t{2 * (2 * 6 + 2) + 1};
    const auto [a, b, c] = K.vertices_of(t);
    const Point<TypeParam> centroid =
        (K.position(a) + K.position(b) + K.position(c)) / TypeParam(3);
    for (std::uint32_t i = 0; i < 3; ++i) {
        auto copy = K;
        const Vertex corner = copy.vertices_of(t)[i];
        copy.vertices[corner.id].flags |= vertex_corner;
        const auto result =
            triangle_collapse(copy, t, {.place = centroid, .interface = InterfaceRule::change});
        EXPECT_EQ(result.verdict, Verdict::legal);
        EXPECT_EQ(result.vertex, corner);
        expect_valid(copy);
    }
}

} // namespace
} // namespace dsc::test::thesis_operations_test
