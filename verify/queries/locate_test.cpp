// SPDX-License-Identifier: MIT
// Point location, against the signs of all triangles.
#include "dsc/queries/locate.h"

#include "support/random/complex.h"
#include "support/refusal.h"
#include "support/small_meshes.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/complex/walk.h"
#include "dsc/geometry/predicates.h"
#include "thesis/sets/algebra.h"
#include "thesis/sets/insertion_removal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dsc::locate_test {
namespace {

using test::grid;
using test::hexagon;
using Kind = Location::Kind;

// The number of edges of the triangle on whose line the point lies: 0 inside, 1 on an edge, 2 at a
// vertex; -1 if the point is outside.
template <class Real>
int zeros_in(const Complex<Real>& complex, Triangle t, const Point<Real>& p) {
    int zeros = 0;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Corner c = corner_of(t.id, i);
        const int sign = orientation<Real>(complex.position(Vertex{complex.vertex(next(c))}),
                                           complex.position(Vertex{complex.vertex(prev(c))}), p);
        if (sign < 0) {
            return -1;
        }
        zeros += sign == 0 ? 1 : 0;
    }
    return zeros;
}

template <class Real>
void expect_right(const Complex<Real>& complex, const Point<Real>& p, const Location& location) {
    if (location.kind == Kind::outside) {
        EXPECT_EQ(location, Location{});
        for (const Triangle t : triangles(complex)) {
            ASSERT_EQ(zeros_in(complex, t, p), -1) << "triangle " << t.id << " holds the point";
        }
        return;
    }
    ASSERT_TRUE(complex.is_alive(location.triangle));
    const int zeros = zeros_in(complex, location.triangle, p);
    EXPECT_EQ(zeros, location.kind == Kind::triangle ? 0 : location.kind == Kind::edge ? 1 : 2);
    const SimplexSet faces = closure(complex, location.triangle);
    EXPECT_EQ(location.edge.is_valid(), location.kind == Kind::edge);
    EXPECT_EQ(location.vertex.is_valid(), location.kind == Kind::vertex);
    if (location.kind == Kind::edge) {
        EXPECT_TRUE(faces.contains(location.edge));
        const auto [a, b] = complex.vertices_of(location.edge);
        EXPECT_EQ(orientation<Real>(complex.position(a), complex.position(b), p), 0);
    }
    if (location.kind == Kind::vertex) {
        EXPECT_TRUE(faces.contains(location.vertex));
        EXPECT_EQ(complex.position(location.vertex), p);
    }
}

template <class Real>
class Locate : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Locate, Reals);

// A point that is off an edge by the smallest number.
TYPED_TEST(Locate, IsExact) {
    const auto complex = hexagon<TypeParam>();
    const auto smallest = std::numeric_limits<TypeParam>::denorm_min();
    using P = Point<TypeParam>;
    const Edge incident_edge = complex.find_edge(Vertex{0}, Vertex{1});
    EXPECT_EQ(locate(complex, P(TypeParam(0.5), 0)).edge, incident_edge);
    EXPECT_EQ(locate(complex, P(TypeParam(0.5), smallest)).triangle, Triangle{1});
    EXPECT_EQ(locate(complex, P(TypeParam(0.5), smallest)).kind, Kind::triangle);
    EXPECT_EQ(locate(complex, P(TypeParam(0.5), -smallest)).triangle, Triangle{6});
    EXPECT_EQ(locate(complex, P(0, 0)).vertex, Vertex{0});
    EXPECT_EQ(locate(complex, P(smallest, 0)).edge, incident_edge);
    EXPECT_EQ(locate(complex, P(1, 0)).vertex, Vertex{1});
    EXPECT_EQ(locate(complex, P(std::nextafter(TypeParam(1), TypeParam(2)), 0)).kind,
              Kind::outside);
}

TYPED_TEST(Locate, TakesAnyHint) {
    auto complex = hexagon<TypeParam>();
    const Point<TypeParam> p(TypeParam(0.5), TypeParam(0.25));
    for (const Triangle hint : {Triangle{}, Triangle{0}, Triangle{4}, Triangle{7}, Triangle{99}}) {
        EXPECT_EQ(locate(complex, p, hint).triangle, Triangle{1});
    }
    remove(complex, SimplexSet({}, {}, {Triangle{3}}));
    EXPECT_EQ(locate(complex, p, Triangle{3}).triangle, Triangle{1});
}

TYPED_TEST(Locate, FindsNothingInAnEmptyComplex) {
    Complex<TypeParam> complex;
    EXPECT_EQ(locate(complex, Point<TypeParam>(0, 0)), Location{});
    insert_vertex(complex, Point<TypeParam>(0, 0));
    EXPECT_EQ(locate(complex, Point<TypeParam>(0, 0)), Location{});
}

TYPED_TEST(Locate, RefusesWhatIsNotFinite) {
    const auto complex = hexagon<TypeParam>();
    const auto infinity = std::numeric_limits<TypeParam>::infinity();
    test::expect_refusal([&] { (void)locate(complex, Point<TypeParam>(0, infinity)); }, "locate",
                         "(0, inf)");
    EXPECT_THROW((void)locate(complex, Point<TypeParam>(infinity - infinity, 0)), InputError);
}

// Each component is convex, but a point outside one of them may lie in another.
TEST(Locate, LooksBeyondAPieceOfAComplex) {
    auto complex = grid<double>(7);
    SimplexSet cut;
    for (const Triangle t : triangles(complex)) {
        if ((t.id - 1) / 2 % 7 == 3) {
            cut.insert(t);
        }
    }
    remove(complex, cut);
    for (const Triangle hint : triangles(complex)) {
        for (double x = 0.25; x < 7; x += 0.5) {
            const Point<double> p(x, 3.25);
            const Location location = locate(complex, p, hint);
            expect_right(complex, p, location);
            EXPECT_EQ(location.kind == Kind::outside, x > 3 && x < 4) << x;
        }
    }
}

// Meshes after random flips, with holes, free ids and points on a lattice.
TEST(Locate, AgreesWithAllTrianglesOfMeshesThatAreNotDelaunay) {
    std::size_t met[4] = {0, 0, 0, 0};
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
        const auto complex = test::random_complex<double>(
            seed, {.points = 40, .grid = 12, .holes = seed % 2 == 0 ? 0.0 : 0.15, .scramble = 200});
        test::Random random(seed);
        for (int i = 0; i < 60; ++i) {
            const double y = 0.5 * random.below(24);
            const Point<double> p(0.5 * random.below(24), y);
            const Triangle hint{random.below(complex.triangle_bound())};
            const Location location = locate(complex, p, hint);
            expect_right(complex, p, location);
            EXPECT_EQ(location, locate(complex, p, hint));
            ++met[static_cast<std::size_t>(location.kind)];
        }
    }
    for (const std::size_t count : met) {
        EXPECT_GT(count, 100U);
    }
}

// A turbine: a fan of triangles surrounded by blades. For each edge between two blades, the point
// is on the side of the next blade, so a simple walk would go around for ever.
TEST(Locate, DoesNotGoInCircles) {
    for (const double side : {1.0, -1.0}) {
        constexpr std::uint32_t blades = 7;
        std::vector<Point<double>> points;
        std::vector<test::Indices> turbine;
        for (std::uint32_t i = 0; i < blades; ++i) {
            const double angle = 2 * 3.14159265358979323846 * i / blades;
            points.emplace_back(side * std::cos(angle), std::sin(angle));
            points.emplace_back(side * 4 * std::cos(angle + 0.6), 4 * std::sin(angle + 0.6));
            const std::uint32_t inner = 2 * i;
            const std::uint32_t next_inner = 2 * ((i + 1) % blades);
            turbine.push_back({inner, inner + 1, next_inner + 1});
            turbine.push_back({inner, next_inner + 1, next_inner});
            turbine.push_back({2 * blades, inner, next_inner});
        }
        points.emplace_back(0, 0);
        const auto complex = test::build<double>(points, turbine, std::vector<Phase>(21, 0));
        const Point<double> p(side * 0.02, 0.01);
        for (const Triangle start : triangles(complex)) {
            const WalkEnd end =
                walk(complex, start, p, 100, [&](Corner c) { return !is_border(complex.twin(c)); });
            EXPECT_EQ(end.kind, WalkEnd::Kind::triangle) << "from triangle " << start.id;
            EXPECT_EQ(triangle_of(end.corner), 3U);
        }
    }
}

} // namespace
} // namespace dsc::locate_test
