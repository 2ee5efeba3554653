// SPDX-License-Identifier: MIT
// The initial complex: every shape comes out as it went in, on a valid, constrained Delaunay
// complex of good triangles of the size that was asked for.
#include "dsc/complex/ranges.h"
#include "dsc/initial/build/lattice.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/queries/validate.h"
#include "measures/symmetric_difference.h"
#include "replay/mesh_hash.h"
#include "shapes/shapes.h"
#include "support/initial_testing.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace dsc::initial_complex_test {
namespace {

using test::Scenery;
using test::Sizes;

using std::numbers::pi;

Shape circle(double x, double y, double radius, double edge_length, dsc::Phase phase = 1) {
    return {dsc::scenes::circle({x, y}, radius, edge_length), phase};
}

// Sharp and blunt corners in turn, and edges that are not cut beforehand.
Shape star(int points, double inner, double outer) {
    Shape shape;
    for (int i = 0; i < points; ++i) {
        const double radius = i % 2 == 0 ? outer : inner;
        shape.outline.push_back({0.5 + radius * std::cos(2 * pi * i / points),
                                 0.5 + radius * std::sin(2 * pi * i / points)});
    }
    return shape;
}

// Vertices of the very lattice that the shape is laid over, and edges along its rows and through
// its vertices.
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
    double worst_quality; // what the angles of the input allow, with some room
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
        {"fine_outline", {unit, {circle(0.5, 0.5, 0.25, 0.004)}, 0.05}, 0.45},
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

// Follows the interface around one shape: all vertices of the outline in order, bit for bit, each
// edge cut into the promised number of pieces, and the same region to the last few bits.
template <class Real>
std::size_t expect_outline(const Complex<Real>& complex, const Scenery& scenery,
                           const Shape& shape) {
    auto outline = shape.outline;
    if (dsc::scenes::signed_area(outline) < 0) {
        std::reverse(outline.begin(), outline.end());
    }
    const auto found = test::vertices_by_position(complex);
    const auto id_of = [&](const Point<double>& p) {
        const auto at = found.find({static_cast<Real>(p.x()), static_cast<Real>(p.y())});
        return at == found.end() ? dsc::no_id : at->second;
    };
    const std::uint32_t first = id_of(outline.front());
    if (first == dsc::no_id) {
        ADD_FAILURE() << "the first vertex is lost";
        return 0;
    }
    // The interface edge out of the first vertex that has the inside on its left.
    Corner start = dsc::no_id;
    for (const dsc::Triangle t : dsc::triangles(complex)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = dsc::corner_of(t.id, i);
            if (complex.vertex(dsc::next(c)) == first && complex.phase_at(c) == shape.phase &&
                complex.phase_at(complex.twin(c)) != shape.phase) {
                start = c;
            }
        }
    }
    if (start == dsc::no_id) {
        ADD_FAILURE() << "the first vertex is not on the interface";
        return 0;
    }
    const auto loop = test::loop_from(complex, start);
    std::size_t place = 0;
    dsc::scenes::Outline result;
    const Point<double> origin = outline.front(); // exact to subtract, and it saves digits
    for (const std::uint32_t v : loop) {
        result.push_back(complex.position(Vertex{v}).template cast<double>() - origin);
    }
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto& a = outline[i];
        const auto& b = outline[i + 1 < outline.size() ? i + 1 : 0];
        if (place >= loop.size() || loop[place] != id_of(a)) {
            ADD_FAILURE() << "vertex " << i << " of the outline is not where it should be";
            return loop.size();
        }
        place += static_cast<std::size_t>(
            std::max(1.0, std::ceil((b - a).norm() / scenery.edge_length * (1 - 1e-9))));
    }
    EXPECT_EQ(place, loop.size()) << "pieces of the outline";
    for (auto& point : outline) {
        point -= origin;
    }
    const double area = dsc::scenes::signed_area(outline);
    // As floats, each edge may be off by the rounding of its ends.
    const double step = std::numeric_limits<float>::epsilon() *
                        (origin.lpNorm<Eigen::Infinity>() + scenery.edge_length);
    const double tolerance =
        std::is_same_v<Real, double> ? 1e-12 * area : step * dsc::scenes::perimeter(outline);
    EXPECT_LE(dsc::scenes::symmetric_difference(result, outline), tolerance);
    return loop.size();
}

template <class Real>
void expect_good(const Complex<Real>& complex, const Case& test) {
    const Scenery& scenery = test.scenery;
    const auto report = dsc::validate(complex);
    ASSERT_TRUE(report.ok()) << report.problem;
    EXPECT_EQ(report.components, 1U);
    EXPECT_EQ(report.boundary_loops, 1U);
    EXPECT_EQ(report.unused_vertices, 0U);
    const Sizes sizes = test::sizes_of(complex);
    const auto& domain = scenery.domain;
    const double whole = (domain.high - domain.low).prod();
    EXPECT_NEAR(sizes.area, whole, 1e-6 * whole);
    EXPECT_EQ(sizes.not_delaunay, 0U);
    EXPECT_GE(sizes.worst_quality, test.worst_quality);
    EXPECT_LE(sizes.longest, 1.8 * scenery.edge_length);
    const auto found = test::vertices_by_position(complex);
    for (const double x : {domain.low.x(), domain.high.x()}) {
        for (const double y : {domain.low.y(), domain.high.y()}) {
            EXPECT_EQ(found.count({static_cast<Real>(x), static_cast<Real>(y)}), 1U) << x << y;
        }
    }
    std::size_t pieces = 0;
    for (const Shape& shape : scenery.shapes) {
        SCOPED_TRACE("phase " + std::to_string(shape.phase));
        pieces += expect_outline(complex, scenery, shape);
    }
    EXPECT_EQ(test::interface_edge_count(complex), pieces) << "edges of the interface";
    std::size_t wrong_phases = 0;
    for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
        const auto& v = complex.triangles[t].v;
        const Point<double> centre =
            ((complex.position(Vertex{v[0]}) + complex.position(Vertex{v[1]}) +
              complex.position(Vertex{v[2]})) /
             Real(3))
                .template cast<double>();
        wrong_phases += complex.triangles[t].phase != test::innermost_phase(scenery.shapes, centre);
        EXPECT_EQ(complex.triangles[t].mark, 0U);
    }
    EXPECT_EQ(wrong_phases, 0U);
    for (const auto& record : complex.vertices) {
        EXPECT_TRUE(record.flags == 0 && record.stamp == 0 && record.slot == dsc::no_id);
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
    for (const Shape& shape : test.scenery.shapes) {
        expect_outline(complex, test.scenery, shape);
    }
}

TEST_P(InitialComplex, ComesOutAsItWentInAsFloat) {
    Case test = GetParam();
    test.worst_quality *= 0.98;
    expect_good(build<float>(test.scenery), test);
}

INSTANTIATE_TEST_SUITE_P(Shapes, InitialComplex, ::testing::ValuesIn(cases()),
                         [](const auto& test) { return test.param.name; });

TEST(InitialComplexNumbering, IsOnlyThat) {
    const std::vector<Shape> shapes{circle(0.5, 0.5, 0.25, 0.05)};
    const auto numbered = dsc::initial_complex<double>({}, shapes, {.edge_length = 0.05});
    const auto as_made =
        dsc::initial_complex<double>({}, shapes, {.edge_length = 0.05, .renumber = false});
    EXPECT_EQ(dsc::mesh_hash(numbered), dsc::mesh_hash(as_made));
}

// The goal that the constants of the improvement were chosen for.
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

// Scale must not matter, down to where products of four lengths underflow.
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
