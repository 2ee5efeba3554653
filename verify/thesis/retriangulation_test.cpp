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

} // namespace
} // namespace dsc::test::retriangulation_test
