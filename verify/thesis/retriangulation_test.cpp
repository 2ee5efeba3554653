// SPDX-License-Identifier: MIT
// Ear clipping and local retriangulation on hand-sized cases: each verdict, each result.
#include "support/operations_testing.h"
#include "support/small_meshes.h"

#include "dsc/complex/ranges.h"
#include "dsc/geometry/predicates.h"
#include "dsc/queries/phases.h"
#include "thesis/ear_clipping.h"
#include "thesis/local_retriangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc::test::retriangulation_test {
namespace {

template <class Real>
class Retriangulation : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Retriangulation, Reals);

using Ears = std::vector<Indices>;

// The ears in the order of cutting; empty where clipping gets stuck.
template <class Real>
Ears clip(const std::vector<Point<Real>>& polygon) {
    EarClipping work;
    const bool done = ear_clipping(std::span<const Point<Real>>(polygon), work);
    return done ? work.triangles : Ears{};
}

TYPED_TEST(Retriangulation, EarsAreCutInTheOrderOfTheWalk) {
    using Points = std::vector<Point<TypeParam>>;
    EXPECT_EQ(clip(Points{{0, 0}, {1, 0}, {0, 1}}), (Ears{{2, 0, 1}}));
    EXPECT_EQ(clip(Points{{0, 0}, {1, 0}, {1, 1}, {0, 1}}), (Ears{{3, 0, 1}, {3, 1, 2}}));
    // Convex: each second vertex of a round, then what is left.
    EXPECT_EQ(clip(Points{{0, 0}, {2, 0}, {3, 2}, {1, 3}, {-1, 2}}),
              (Ears{{4, 0, 1}, {4, 1, 2}, {4, 2, 3}}));
    // As in figure 7.4: the walk begins at a reflex vertex, which is skipped, 1 is cut, and 2 next.
    EXPECT_EQ(clip(Points{{2, 1}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}),
              (Ears{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
    // 0 turns left, but its triangle holds 3: no ear. 1 is one.
    EXPECT_EQ(clip(Points{{0, 0}, {6, 0}, {4, 1}, {1, 1}, {0, 6}}).front(), (Indices{0, 1, 2}));
}

TYPED_TEST(Retriangulation, EarsHoldNoOtherVertexNotEvenOnTheirEdges) {
    using Points = std::vector<Point<TypeParam>>;
    // Corner 1 is cut from (0, 0) and (4, 4) only if the middle of that diagonal is free.
    const Points open{{0, 0}, {4, 0}, {4, 4}, {1, 3}};
    const Points touched{{0, 0}, {4, 0}, {4, 4}, {2, 2}, {0, 4}};
    EXPECT_EQ(clip(open).front(), (Indices{3, 0, 1}));
    for (const Indices& ear : clip(touched)) {
        EXPECT_NE(ear, (Indices{0, 1, 2}));
    }
    EXPECT_EQ(clip(touched).size(), 3U);
    // Flat corners are no ears; they are reached from the other side.
    const Points flat{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {2, 1}};
    EXPECT_EQ(clip(flat).size(), 4U);
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

TYPED_TEST(Retriangulation, VerticesOfTheDomainBoundaryStay) {
    auto K = hexagon<TypeParam>();
    const auto result = local_retriangulation(K, Triangle{3});
    EXPECT_EQ(result.verdict, Verdict::legal);
    expect_valid(K);
    EXPECT_EQ(result.vertices_removed, 1U);
    EXPECT_EQ(K.triangle_count(), 4U);
    EXPECT_FALSE(K.is_alive(Vertex{0}));
    // A triangle with a vertex inside becomes one without; then there is nothing to take out.
    auto T = build<TypeParam>({{0, 0}, {3, 0}, {0, 3}, {1, 1}}, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                              {0, 0, 0});
    EXPECT_EQ(local_retriangulation(T, Triangle{2}).verdict, Verdict::legal);
    expect_valid(T);
    EXPECT_EQ(T.triangle_count(), 1U);
    const auto again = local_retriangulation(T, Triangle{2});
    EXPECT_EQ(again.verdict, Verdict::legal);
    EXPECT_EQ(again.triangles_removed, 0U);
    expect_valid(T);
}

auto retriangulate(Triangle t) {
    return [t](const auto& submesh) {
        const Verdict guess = local_retriangulation_guard(submesh.complex, t, submesh.region);
        const Verdict verdict = local_retriangulation(submesh, t).verdict;
        EXPECT_EQ(guess, verdict);
        return verdict;
    };
}

TYPED_TEST(Retriangulation, IsRefused) {
    auto K = grid<TypeParam>(6);
    const Triangle t{triangle_of(K.find_half_edge(Vertex{16}, Vertex{17}))};
    expect_refused(K, Verdict::not_a_simplex, retriangulate(Triangle{}));
    expect_refused(K, Verdict::not_a_simplex, retriangulate(Triangle{border_triangle}));
    expect_refused(K, Verdict::not_a_simplex, retriangulate(Triangle{73}));
    std::vector<std::uint32_t> labels(49, 1);
    labels[16] = 0; // in the triangle
    expect_refused(K, Verdict::on_submesh_boundary, retriangulate(t), labels);
    labels[16] = 1;
    labels[9] = 0; // beside it: 16 is on the submesh boundary
    expect_refused(K, Verdict::on_submesh_boundary, retriangulate(t), labels);
    K.set_locked(Vertex{17}, true);
    expect_refused(K, Verdict::locked, retriangulate(t));
    // A triangle of another phase that shares a vertex: the interface comes before the lock.
    const Triangle beside{triangle_of(K.twin(K.find_half_edge(Vertex{9}, Vertex{16})))};
    K.set_phase(beside, 1);
    expect_refused(K, Verdict::on_interface, retriangulate(t));
    // A locked vertex of the domain boundary is not in danger.
    auto H = hexagon<TypeParam>();
    H.set_locked(Vertex{1}, true);
    EXPECT_EQ(local_retriangulation(H, Triangle{1}).verdict, Verdict::legal);
    expect_valid(H);
    // ... but in another phase than the exterior, that boundary is interface.
    auto inner = build<TypeParam>({{0, 0}, {2, 0}, {0, 2}}, {{0, 1, 2}}, {1});
    expect_refused(inner, Verdict::on_interface, retriangulate(Triangle{1}));
}

TYPED_TEST(Retriangulation, NeedsOneSimplePolygon) {
    // A triangle with a triangular hole: R' is two loops, or runs twice through vertex 2.
    const std::vector<Point<TypeParam>> corners{{0, 0}, {10, 0}, {5, 9}, {4, 2}, {6, 2}, {5, 4}};
    auto ring = build<TypeParam>(corners,
                                 {{0, 1, 3}, {1, 4, 3}, {1, 5, 4}, {1, 2, 5}, {2, 0, 5}, {0, 3, 5}},
                                 std::vector<Phase>(6, 0));
    expect_refused(ring, Verdict::not_a_simple_polygon, retriangulate(Triangle{1}));
    auto pinched = build<TypeParam>(
        corners, {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 0, 5}, {0, 3, 5}},
        std::vector<Phase>(6, 0));
    expect_refused(pinched, Verdict::not_a_simple_polygon, retriangulate(Triangle{1}));
    // Vertex 4 hangs on vertex 3 by one edge of R', which has R on both sides.
    auto dangling =
        build<TypeParam>({{0, 0}, {4, 0}, {2, 3}, {2, -4}, {2, -1}},
                         {{0, 1, 2}, {0, 4, 1}, {0, 3, 4}, {3, 1, 4}}, std::vector<Phase>(4, 0));
    expect_refused(dangling, Verdict::not_a_simple_polygon, retriangulate(Triangle{1}));
}

// A wheel: vertex 0 in the middle of n vertices on a circle.
template <class Real>
Complex<Real> wheel(std::uint32_t n) {
    std::vector<Point<Real>> points{{0, 0}};
    std::vector<Indices> triangles;
    for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        points.emplace_back(static_cast<Real>(std::cos(angle)), static_cast<Real>(std::sin(angle)));
        triangles.push_back({0, i + 1, (i + 1) % n + 1});
    }
    return build<Real>(points, triangles, std::vector<Phase>(n, 0));
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

template <class Real>
double smallest_sine(const Complex<Real>& K) {
    double least = 2;
    for (const Triangle t : triangles(K)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t.id, i);
            const auto at = [&](Corner k) {
                return K.position(Vertex{K.vertex(k)}).template cast<double>().eval();
            };
            const Point<double> a = at(next(c)) - at(c);
            const Point<double> b = at(prev(c)) - at(c);
            least = std::min(least, (a.x() * b.y() - a.y() * b.x()) / (a.norm() * b.norm()));
        }
    }
    return least;
}

TYPED_TEST(Retriangulation, DelaunayIsDelaunayAndBetter) {
    // A long box around one inner vertex: ears from one corner make slivers.
    auto K = build<TypeParam>(
        {{0, 0}, {2, 0}, {4, 0}, {6, 0}, {6, 1}, {4, 1}, {2, 1}, {0, 1}, {3, TypeParam(0.5)}},
        {{8, 0, 1}, {8, 1, 2}, {8, 2, 3}, {8, 3, 4}, {8, 4, 5}, {8, 5, 6}, {8, 6, 7}, {8, 7, 0}},
        std::vector<Phase>(8, 0));
    auto D = K;
    EXPECT_EQ(local_retriangulation(K, Triangle{2}).verdict, Verdict::legal);
    EXPECT_EQ(local_retriangulation(D, Triangle{2}, RetriangulationMethod::delaunay).verdict,
              Verdict::legal);
    expect_valid(K);
    expect_valid(D);
    EXPECT_GT(smallest_sine(D), 1.5 * smallest_sine(K));
    for (const Triangle t : triangles(D)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t.id, i);
            if (is_border(D.twin(c))) {
                continue;
            }
            const auto [a, b, w] = D.vertices_of(t);
            EXPECT_LE(in_circle<TypeParam>(D.position(a), D.position(b), D.position(w),
                                           D.position(Vertex{D.vertex(D.twin(c))})),
                      0);
        }
    }
}

} // namespace
} // namespace dsc::test::retriangulation_test
