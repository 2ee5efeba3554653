// SPDX-License-Identifier: MIT
// The initial complex: every shape keeps its points, in a valid, constrained Delaunay complex of
// good triangles of the requested size.
#include "dsc/complex/ranges.h"
#include "dsc/initial/build/lattice.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/queries/validate.h"
#include "shapes/shapes.h"
#include "support/curve_testing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace dsc::initial_complex_test {
namespace {

using test::CurveScenery;
using test::Scenery;
using test::Sizes;

using std::numbers::pi;

Shape circle(double x, double y, double radius, double edge_length, dsc::Phase phase = 1) {
    return {dsc::scenes::circle({x, y}, radius, edge_length), phase};
}

// A star with sharp and blunt corners, whose long edges are not divided beforehand.
Shape star(int points, double inner, double outer) {
    Shape shape;
    for (int i = 0; i < points; ++i) {
        const double radius = i % 2 == 0 ? outer : inner;
        shape.outline.push_back({0.5 + radius * std::cos(2 * pi * i / points),
                                 0.5 + radius * std::sin(2 * pi * i / points)});
    }
    return shape;
}

// Shapes with vertices exactly on the lattice of the mesh, and edges along its rows and through its
// vertices.
Scenery on_the_lattice() {
    Scenery scenery;
    const auto lattice = dsc::initial::fit_lattice({0, 0}, {1, 1}, scenery.edge_length);
    const auto at = [&](std::uint32_t row, std::uint32_t column) {
        return Point<double>(lattice.x(row, column), lattice.y(row));
    };
    scenery.shapes = {{{at(4, 4), at(4, 12), at(8, 12), at(12, 12), at(12, 4)}, 1},
                      {{at(6, 6), at(6, 9), at(9, 8)}, 2}};
    return scenery;
}

Scenery moved(Scenery scenery, double x, double y) {
    const Point<double> by(x, y);
    scenery.domain.low += by;
    scenery.domain.high += by;
    for (Shape& shape : scenery.shapes) {
        for (auto& point : shape.outline) {
            point += by;
        }
    }
    return scenery;
}

struct Case {
    std::string name;
    Scenery scenery;
    double worst_quality; // bound that the angles of the input allow
};

std::vector<Case> cases() {
    const dsc::Rectangle unit{};
    const Shape square{{{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}}, 1};
    const auto disc = dsc::scenes::slotted_disc({}, 0.02);
    const auto crescent = dsc::scenes::crescent({{0.4, 0.5}, 0.3, {0.55, 0.5}, 0.28}, 0.03);
    Shape clockwise = circle(0.5, 0.5, 0.25, 0.05);
    std::reverse(clockwise.outline.begin(), clockwise.outline.end());
    const Scenery slotted{unit, {{disc, 1}}, 0.02};
    return {
        {"nothing", {unit, {}, 0.1}, 0.5},
        {"circle", {unit, {circle(0.5, 0.5, 0.25, 0.05)}, 0.05}, 0.5},
        {"clockwise", {unit, {clockwise}, 0.05}, 0.5},
        {"slotted_disc", slotted, 0.45},
        {"crescent", {unit, {{crescent, 1}}, 0.03}, 0.2},
        {"star", {unit, {star(200, 0.2, 0.45)}, 0.04}, 0.05},
        {"blunt_star", {unit, {star(10, 0.25, 0.4)}, 0.04}, 0.45},
        {"square", {unit, {square}, 0.05}, 0.5},
        {"on_the_lattice", on_the_lattice(), 0.35},
        {"nested",
         {unit,
          {circle(0.5, 0.5, 0.12, 0.04, 0), circle(0.5, 0.5, 0.42, 0.04, 1),
           circle(0.52, 0.5, 0.3, 0.04, 2), circle(0.5, 0.5, 0.06, 0.04, 1)},
          0.04},
         0.45},
        {"two_shapes",
         {unit, {circle(0.3, 0.5, 0.15, 0.03, 7), circle(0.7, 0.5, 0.15, 0.03, 3)}, 0.03},
         0.5},
        {"tiny", {unit, {{{{0.5, 0.5}, {0.55, 0.5}, {0.55, 0.55}, {0.5, 0.55}}, 1}}, 0.05}, 0.4},
        {"near_the_side", {unit, {circle(0.5, 0.5, 0.49, 0.05)}, 0.05}, 0.15},
        {"fine_outline", {unit, {circle(0.5, 0.5, 0.25, 0.0101)}, 0.05}, 0.45},
        {"close_together",
         {unit, {circle(0.3, 0.5, 0.19, 0.05, 1), circle(0.7, 0.5, 0.19, 0.05, 1)}, 0.05},
         0.4},
        {"offset", moved(slotted, 1000, -1000), 0.45},
        {"wide", {{{-3, 0}, {3, 0.5}}, {circle(1, 0.25, 0.15, 0.03)}, 0.05}, 0.5},
    };
}

class InitialComplex : public ::testing::TestWithParam<Case> {
protected:
    template <class Real>
    static Complex<Real> build(const Scenery& scenery, int rounds = 12) {
        return dsc::initial_complex<Real>(
            scenery.domain, scenery.shapes,
            {.edge_length = scenery.edge_length, .improve_rounds = rounds});
    }
};

// Each shape as a closed curve, with the surrounding phase on its right.
CurveScenery as_curves(const Scenery& scenery) {
    CurveScenery result{{}, scenery.edge_length, scenery.domain};
    for (const Shape& shape : scenery.shapes) {
        std::vector<Shape> others = scenery.shapes;
        std::erase_if(others, [&](const Shape& one) { return one.outline == shape.outline; });
        auto points = shape.outline;
        if (dsc::scenes::signed_area(points) < 0) {
            std::reverse(points.begin(), points.end());
        }
        points.push_back(points.front());
        const Phase around = test::innermost_phase(others, points.front());
        result.curves.push_back({points, shape.phase, around});
    }
    return result;
}

template <class Real>
void expect_good(const Complex<Real>& complex, const Case& test) {
    const Scenery& scenery = test.scenery;
    test::expect_sound(complex, as_curves(scenery));
    EXPECT_GE(test::sizes_of(complex).worst_quality, test.worst_quality);
    const auto& domain = scenery.domain;
    const auto found = test::vertices_by_position(complex);
    for (const double x : {domain.low.x(), domain.high.x()}) {
        for (const double y : {domain.low.y(), domain.high.y()}) {
            EXPECT_EQ(found.count({static_cast<Real>(x), static_cast<Real>(y)}), 1U) << x << y;
        }
    }
}

TEST_P(InitialComplex, ComesOutAsItWentIn) {
    expect_good(build<double>(GetParam().scenery), GetParam());
}

TEST_P(InitialComplex, IsValidWithoutImprovement) {
    Case test = GetParam();
    test.worst_quality = 0;
    const auto complex = build<double>(test.scenery, 0);
    ASSERT_TRUE(dsc::validate(complex).ok());
    EXPECT_EQ(test::sizes_of(complex).not_delaunay, 0U);
    test::expect_curves(complex, as_curves(test.scenery));
}

TEST_P(InitialComplex, ComesOutAsItWentInAsFloat) {
    Case test = GetParam();
    test.worst_quality *= 0.98;
    expect_good(build<float>(test.scenery), test);
}

INSTANTIATE_TEST_SUITE_P(Shapes, InitialComplex, ::testing::ValuesIn(cases()),
                         [](const auto& test) { return test.param.name; });

// The constants of the improvement were chosen to meet these values.
TEST(InitialComplexSizes, ACircleGetsTrianglesOfTheSizeAskedFor) {
    const double h = 0.01;
    const std::vector<Shape> shapes{circle(0.5, 0.5, 0.25, h)};
    const auto complex = dsc::initial_complex<double>({}, shapes, {.edge_length = h});
    const Sizes sizes = test::sizes_of(complex);
    EXPECT_GE(sizes.worst_quality, 0.5);
    EXPECT_GT(sizes.median_quality, 0.9);
    EXPECT_GE(sizes.shortest, 0.45 * h);
    EXPECT_LE(sizes.longest, 1.8 * h);
    EXPECT_NEAR(complex.triangle_count(), 1 / (0.4330127 * h * h), 0.02 / (0.4330127 * h * h));
}

// The scale must not matter, even where products of four lengths underflow.
TEST(InitialComplexSizes, ScaleDoesNotMatter) {
    for (const int power : {-300, -40, 300}) {
        const double scale = std::ldexp(1.0, power);
        const std::vector<Shape> unit{circle(0.5, 0.5, 0.25, 0.1)};
        std::vector<Shape> scaled = unit;
        for (auto& point : scaled.front().outline) {
            point *= scale;
        }
        const auto expected = dsc::initial_complex<double>({}, unit, {.edge_length = 0.1});
        const auto complex = dsc::initial_complex<double>({{0, 0}, {scale, scale}}, scaled,
                                                          {.edge_length = 0.1 * scale});
        ASSERT_EQ(complex.triangle_count(), expected.triangle_count()) << power;
        ASSERT_TRUE(dsc::validate(complex).ok()) << power;
        for (std::uint32_t v = 0; v < expected.vertex_bound(); ++v) {
            EXPECT_EQ(complex.vertices[v].x, expected.vertices[v].x * scale);
            EXPECT_EQ(complex.vertices[v].y, expected.vertices[v].y * scale);
        }
    }
}

} // namespace

} // namespace dsc::initial_complex_test
