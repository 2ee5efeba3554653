// SPDX-License-Identifier: MIT
// The validator detects complexes that are not embedded in the plane: fans that go around more than
// once, domains that overlap themselves, handles of a torus, overlapping components.
#include "dsc/queries/validate.h"

#include "support/small_meshes.h"
#include "support/validate_testing.h"

#include "thesis/sets/insertion_removal.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace dsc::validate_embedding_test {
namespace {

using test::expect_problem;
using test::grid;
using test::hexagon;
using test::Indices;

template <class Real>
class ValidateEmbedding : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(ValidateEmbedding, Reals);

// Builds a complex from arrays whose triangles may overlap.
template <class Real>
Complex<Real> build(const std::vector<Point<Real>>& points, const std::vector<Indices>& triangles) {
    Complex<Real> complex;
    for (const Point<Real>& p : points) {
        (void)insert_vertex(complex, p);
    }
    for (const auto& [a, b, c] : triangles) {
        insert_triangle(complex, Vertex{a}, Vertex{b}, Vertex{c}, 0);
    }
    return complex;
}

// Fans of `count` triangles of 60 degrees, closed or open; repeated ring points get distinct
// vertices.
template <class Real>
Complex<Real> fan(std::uint32_t count, bool closed) {
    const auto six = hexagon<Real>();
    std::vector<Point<Real>> points{{0, 0}};
    std::vector<Indices> triangles;
    const std::uint32_t ring = closed ? count : count + 1;
    for (std::uint32_t i = 0; i < ring; ++i) {
        points.push_back(six.position(Vertex{i % 6 + 1}));
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        triangles.push_back({0, i + 1, (i + 1) % ring + 1});
    }
    return build<Real>(points, triangles);
}

TYPED_TEST(ValidateEmbedding, SeesFansThatGoAroundMoreThanOnce) {
    EXPECT_EQ(validate(fan<TypeParam>(6, true)).problem, "");
    EXPECT_EQ(validate(fan<TypeParam>(5, false)).problem, "");
    EXPECT_EQ(validate(fan<TypeParam>(1, false)).problem, "");
    expect_problem(fan<TypeParam>(12, true), "vertex 0 at (0, 0): the triangles go around it more");
    expect_problem(fan<TypeParam>(18, true), "go around it more than once");
    expect_problem(fan<TypeParam>(6, false), "go around it more than once"); // touches itself
    expect_problem(fan<TypeParam>(7, false), "go around it more than once");
    expect_problem(fan<TypeParam>(11, false), "go around it more than once");
}

// Adds the quads between consecutive cross sections, given as (right, left) seen in the band's
// direction.
template <class Real>
void add_band(std::vector<Indices>& triangles,
              const std::vector<std::array<std::uint32_t, 2>>& cuts) {
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        triangles.push_back({cuts[i][0], cuts[i + 1][0], cuts[i + 1][1]});
        triangles.push_back({cuts[i][0], cuts[i + 1][1], cuts[i][1]});
    }
}

// A road of width 0.5 that turns left about the origin, at a constant distance.
template <class Real>
Complex<Real> road(double turns, std::uint32_t pieces) {
    std::vector<Point<Real>> points;
    std::vector<std::array<std::uint32_t, 2>> cuts;
    for (std::uint32_t i = 0; i <= pieces; ++i) {
        const bool closes = turns == 1 && i == pieces; // exactly onto its begin
        const double angle = closes ? 0 : 2 * 3.14159265358979323846 * turns * i / pieces;
        for (const double radius : {1.5, 1.0}) {
            points.emplace_back(static_cast<Real>(radius * std::cos(angle)),
                                static_cast<Real>(radius * std::sin(angle)));
        }
        cuts.push_back({2 * i, 2 * i + 1});
    }
    std::vector<Indices> triangles;
    add_band<Real>(triangles, cuts);
    return build<Real>(points, triangles);
}

TYPED_TEST(ValidateEmbedding, SeesADomainThatLiesOverItself) {
    EXPECT_EQ(validate(road<TypeParam>(0.9, 16)).problem, "");
    expect_problem(road<TypeParam>(1.25, 19), "overlaps itself");
    expect_problem(road<TypeParam>(1, 16), "overlaps itself"); // the ends touch
}

// Two vertical boundaries: side by side, one above the other, or overlapping.
TYPED_TEST(ValidateEmbedding, SeesVerticalBoundariesThatMeet) {
    using P = Point<TypeParam>;
    const auto with = [](TypeParam x, TypeParam y) {
        Complex<TypeParam> complex = grid<TypeParam>(8);
        const Vertex a = insert_vertex(complex, P(x, y));
        const Vertex b = insert_vertex(complex, P(x + 1, y));
        const Vertex c = insert_vertex(complex, P(x, y + TypeParam(1.5)));
        insert_triangle(complex, a, b, c, 0);
        return complex;
    };
    EXPECT_EQ(validate(with(TypeParam(8.5), 3)).problem, "");
    EXPECT_EQ(validate(with(8, TypeParam(8.5))).problem, "");
    for (const TypeParam y : {TypeParam(-1.25), TypeParam(3), TypeParam(3.25), TypeParam(7.5)}) {
        expect_problem(with(8, y), "the domain overlaps itself");
    }
}

// Two bands that cross, from one side of a square to the opposite one: a torus with one hole.
TYPED_TEST(ValidateEmbedding, SeesAHandle) {
    using P = Point<TypeParam>;
    std::vector<P> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    std::vector<Indices> triangles{{0, 1, 2}, {0, 2, 3}};
    const std::vector<std::array<P, 2>> way{
        {P(3, 0), P(2, 1)}, {P(3, 3), P(2, 2)}, {P(-2, 3), P(-1, 2)}, {P(-2, 0), P(-1, 1)}};
    const auto band = [&](bool turned, std::array<std::uint32_t, 2> from,
                          std::array<std::uint32_t, 2> to) {
        std::vector<std::array<std::uint32_t, 2>> cuts{from};
        for (const auto& cut : way) {
            for (const P& p : cut) {
                points.push_back(turned ? P(1 - p.y(), p.x()) : p);
            }
            const auto size = static_cast<std::uint32_t>(points.size());
            cuts.push_back({size - 2, size - 1});
        }
        cuts.push_back(to);
        add_band<TypeParam>(triangles, cuts);
    };
    band(false, {1, 2}, {0, 3});
    const auto one = build<TypeParam>(points, triangles);
    EXPECT_EQ(validate(one).problem, "");
    EXPECT_EQ(validate(one).boundary_loops, 2U);
    band(true, {2, 3}, {1, 0});
    const auto two = build<TypeParam>(points, triangles);
    expect_problem(two, "Euler characteristic: V - E + T is -1 instead of 1");
}

TYPED_TEST(ValidateEmbedding, SeesComponentsThatOverlap) {
    using P = Point<TypeParam>;
    const auto with = [](const Complex<TypeParam>& base, const std::vector<P>& corners) {
        Complex<TypeParam> complex = base;
        std::vector<Vertex> v;
        for (const P& p : corners) {
            v.push_back(insert_vertex(complex, p));
        }
        for (std::size_t i = 2; i < v.size(); ++i) {
            insert_triangle(complex, v[0], v[i - 1], v[i], 0);
        }
        return complex;
    };
    const auto base = grid<TypeParam>(2);
    EXPECT_EQ(validate(with(base, {{3, 3}, {4, 3}, {4, 4}})).problem, "");
    const TypeParam small(0.125);
    expect_problem(with(base, {{1, small}, {1 + small, small}, {1, 2 * small}}),
                   "inside another component");
    expect_problem(with(base, {{-9, -9}, {20, -9}, {-9, 20}}), "inside another component");
    expect_problem(with(base, {{1, 1}, {9, 1}, {9, 9}}), "meets");
    expect_problem(with(base, {{2, 1}, {9, 1}, {9, 9}}), "meets");         // touches from outside
    expect_problem(with(base, {{2, 0}, {4, 0}, {4, 2}, {2, 2}}), "meets"); // along a whole side
    // A corner touches the middle of a vertical side, from the right or from the left.
    const TypeParam half(0.5);
    expect_problem(with(base, {{2, half}, {3, 0}, {3, 1}}), "meets");
    expect_problem(with(base, {{-1, 0}, {0, half}, {-1, 1}}), "meets");
    // Two rings; the outer loop of one lies between the loops of the other, so neither contains the
    // other.
    Complex<TypeParam> rings;
    for (const auto& [low, high] : {std::pair{1, 3}, std::pair{2, 4}}) {
        std::vector<Vertex> v;
        for (const int side : {low, high}) {
            const auto s = static_cast<TypeParam>(side);
            for (const P& p : {P(-s, -s), P(s, -s), P(s, s), P(-s, s)}) {
                v.push_back(insert_vertex(rings, p));
            }
        }
        for (std::size_t i = 0; i < 4; ++i) {
            insert_triangle(rings, v[i], v[4 + i], v[4 + (i + 1) % 4], 0);
            insert_triangle(rings, v[i], v[4 + (i + 1) % 4], v[(i + 1) % 4], 0);
        }
        if (low == 1) {
            EXPECT_EQ(validate(rings).problem, "");
        }
    }
    expect_problem(rings, "inside another component");
}

} // namespace
} // namespace dsc::validate_embedding_test
