// SPDX-License-Identifier: MIT
// Shapes that touch each other, lie inside each other and reach beyond the domain: areas of phases,
// and the phases on both sides of the interface.
#include "dsc/initial/initial_complex.h"
#include "shapes/outline.h"
#include "shapes/voronoi_diagram.h"
#include "support/curve_testing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

namespace dsc::shape_network_test {
namespace {

using Ring = std::vector<Point<double>>;

Ring box(double x, double y, double width, double height) {
    return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

std::map<Phase, double> areas(const std::vector<Shape>& shapes, InputReport* report = nullptr,
                              double tolerance = 1e-3, double edge_length = 0.05,
                              Coverage coverage = Coverage::open) {
    const auto complex = initial_complex<double>(
        {}, std::span<const Shape>(shapes),
        {.edge_length = edge_length, .border_tolerance = tolerance, .coverage = coverage}, report);
    EXPECT_TRUE(validate(complex).ok());
    std::map<Phase, double> found = test::areas_by_phase(complex);
    found.erase(exterior_phase);
    return found;
}

void expect_areas(const std::vector<Shape>& shapes, const std::map<Phase, double>& expected,
                  double error = 1e-13) {
    const std::map<Phase, double> found = areas(shapes);
    ASSERT_EQ(found.size(), expected.size());
    for (const auto& [phase, area] : expected) {
        EXPECT_NEAR(found.at(phase), area, error) << phase;
    }
}

TEST(ShapeNetwork, HolesByTheEvenOddRule) {
    const Ring outer = box(0.2, 0.2, 0.6, 0.6);
    const Ring hole = box(0.4, 0.4, 0.2, 0.2);
    Ring closed = outer;
    closed.push_back(closed.front());
    std::reverse(closed.begin(), closed.end());
    expect_areas({{closed, 1}}, {{1, 0.36}});
    expect_areas({{outer, 1}, {hole, 1}}, {{1, 0.32}});
    expect_areas({{outer, 1, {hole}}}, {{1, 0.32}});
    expect_areas({{outer, 1, {box(0.3, 0.3, 0.4, 0.4), box(0.45, 0.45, 0.1, 0.1)}}}, {{1, 0.21}});
    expect_areas({{outer, 1}, {box(0.3, 0.3, 0.4, 0.4), 1}, {box(0.45, 0.45, 0.1, 0.1), 1}},
                 {{1, 0.21}});
    // A hole has the phase that surrounds the shape, or that of a shape in the hole.
    expect_areas({{box(0.1, 0.1, 0.8, 0.8), 2}, {outer, 1, {hole}}}, {{1, 0.32}, {2, 0.32}});
    expect_areas({{outer, 1, {hole}}, {hole, 2}}, {{1, 0.32}, {2, 0.04}});
    expect_areas({{outer, 1}, {hole, 1}, {hole, 2}}, {{1, 0.32}, {2, 0.04}});
    expect_areas({{hole, 2}, {hole, 1}, {outer, 1}}, {{1, 0.32}, {2, 0.04}});
    expect_areas({{outer, 1}, {hole, 0}, {box(0.45, 0.45, 0.1, 0.1), 0}}, {{1, 0.33}});
}

TEST(ShapeNetwork, RingsThatTouch) {
    const Ring outer = box(0.2, 0.2, 0.6, 0.6);
    expect_areas({{outer, 1}, {{{0.2, 0.5}, {0.4, 0.4}, {0.4, 0.6}}, 1}}, {{1, 0.34}});
    expect_areas({{outer, 1}, {{{0.5, 0.2}, {0.6, 0.4}, {0.4, 0.4}}, 1}}, {{1, 0.34}});
    expect_areas({{outer, 1}, {box(0.2, 0.4, 0.2, 0.2), 1}}, {{1, 0.32}});
    expect_areas({{outer, 1}, {box(0.3, 0.3, 0.2, 0.2), 1}, {box(0.5, 0.5, 0.2, 0.2), 1}},
                 {{1, 0.28}});
    expect_areas({{outer, 1}, {box(0.3, 0.4, 0.2, 0.2), 1}, {box(0.5, 0.4, 0.2, 0.2), 1}},
                 {{1, 0.28}});
    expect_areas({{box(0.2, 0.2, 0.3, 0.3), 1}, {box(0.5, 0.5, 0.3, 0.3), 1}}, {{1, 0.18}});
    const Ring spike{{0.2, 0.2}, {0.8, 0.2}, {0.8, 0.5}, {0.9, 0.5},
                     {0.8, 0.5}, {0.8, 0.8}, {0.2, 0.8}};
    expect_areas({{spike, 1}}, {{1, 0.36}});
}

TEST(ShapeNetwork, TheSidesOfTheDomain) {
    expect_areas({{box(0, 0, 1, 0.5), 1}}, {{1, 0.5}});
    expect_areas({{box(0.8, -0.5, 0.7, 2), 1}}, {{1, 0.2}});
    expect_areas({{box(-1, -1, 3, 3), 1}}, {{1, 1}});
    expect_areas({{box(-1, -1, 3, 3), 2}, {box(0.5, 0.5, 1e-3, 1e-3), 1}}, {{2, 1}});
    expect_areas({{{{0, 0.5}, {0.5, 0.3}, {0.5, 0.7}}, 1}}, {{1, 0.1}});
    // The edges of two shapes along a shared border are clipped at the same point.
    expect_areas(
        {{{{0.4, 0.5}, {1.3, 0.9}, {0.4, 0.9}}, 1}, {{{0.4, 0.5}, {1.3, 0.9}, {1.3, 0.5}}, 2}},
        {{1, 0.16}, {2, 0.08}});
    InputReport report;
    (void)areas({{box(0.8, 0.2, 0.4, 0.4), 1}, {box(0.1, 0.1, 0.2, 0.2), 1}}, &report);
    EXPECT_EQ(report.clipped, 1U);
}

TEST(ShapeNetwork, BordersThatAreShared) {
    expect_areas({{box(0.2, 0.2, 0.3, 0.4), 1}, {box(0.5, 0.2, 0.3, 0.4), 2}},
                 {{1, 0.12}, {2, 0.12}});
    expect_areas({{box(0.2, 0.2, 0.3, 0.4), 1}, {box(0.5, 0.2, 0.3, 0.4), 1}}, {{1, 0.24}});
    expect_areas(
        {{box(0.2, 0.2, 0.6, 0.2), 1}, {box(0.2, 0.4, 0.3, 0.2), 2}, {box(0.5, 0.4, 0.3, 0.2), 3}},
        {{1, 0.12}, {2, 0.06}, {3, 0.06}});
    expect_areas({{box(0, 0, 0.5, 1), 1}, {box(0.5, 0, 0.5, 1), 2}}, {{1, 0.5}, {2, 0.5}});
    for (const double gap : {1e-15, 1e-9, 1e-5, -1e-15, -1e-9, -1e-5}) {
        expect_areas({{box(0.2, 0.2, 0.3, 0.4), 1}, {box(0.5 + gap, 0.2, 0.3 - gap, 0.4), 2}},
                     {{1, 0.12}, {2, 0.12}}, 1e-13 + 0.4 * std::abs(gap));
    }
    const std::vector<Shape> apart{{box(0.2, 0.2, 0.3, 0.4), 1}, {box(0.504, 0.2, 0.296, 0.4), 2}};
    EXPECT_NEAR(areas(apart, nullptr, 0.1).at(2), 0.12, 1e-13);
}

TEST(ShapeNetwork, CellsOfAVoronoiDiagram) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> place(0, 1);
    std::vector<Point<double>> seeds(60);
    for (auto& seed : seeds) {
        seed = {place(random), place(random)};
    }
    const auto diagram = scenes::voronoi_diagram({}, seeds);
    std::vector<Shape> cells;
    std::map<Phase, double> expected;
    for (const auto& cell : diagram.cells) {
        Ring corners;
        for (const Point<double>& p : diagram.corners_of(cell)) {
            corners.emplace_back(std::round(p.x() * 1e9) / 1e9, std::round(p.y() * 1e9) / 1e9);
        }
        const auto phase = static_cast<Phase>(cells.size() + 1);
        expected[phase] = std::abs(scenes::signed_area(corners));
        cells.push_back({corners, phase});
    }
    // Cells keep their areas, unless junctions become one.
    InputReport report;
    const std::map<Phase, double> found = areas(cells, &report, 1e-3, 0.01);
    ASSERT_EQ(found.size(), expected.size());
    std::size_t kept = 0;
    double sum = 0;
    for (const auto& [phase, area] : expected) {
        EXPECT_NEAR(found.at(phase), area, 1e-13 + report.area_changed) << phase;
        kept += std::abs(found.at(phase) - area) < 1e-13 ? 1U : 0U;
        sum += found.at(phase);
    }
    EXPECT_NEAR(sum, 1, 1e-8); // corners are rounded to nine digits
    EXPECT_GE(kept + 4 * report.thinned, cells.size());
}

// Gaps and overlaps of a tenth of an edge length between two halves of the domain: along straight
// borders, and along wavy borders that cross, so that gaps and overlaps alternate.
TEST(ShapeNetwork, GapsAndOverlapsGoToTheNeighbourThatIsNamed) {
    constexpr double h = 0.05;
    const auto halves = [](double gap) {
        return std::vector<Shape>{{box(0, 0, 0.5, 1), 1}, {box(0.5 + gap, 0, 0.5 - gap, 1), 2}};
    };
    for (const double gap : {0.1 * h, -0.1 * h}) {
        for (const Coverage coverage : {Coverage::first, Coverage::longest_border}) {
            const auto found = areas(halves(gap), nullptr, 1e-3, h, coverage);
            EXPECT_NEAR(found.at(1), gap > 0 ? 0.5 + gap : 0.5, 1e-13);
            EXPECT_NEAR(found.at(1) + found.at(2), 1, 1e-13);
        }
        EXPECT_THROW((void)areas(halves(gap), nullptr, 1e-3, h, Coverage::whole), InputError);
    }
    EXPECT_NEAR(areas(halves(0), nullptr, 1e-3, h, Coverage::whole).at(1), 0.5, 1e-13);
    // Neither a hole nor the surroundings of an island count as gaps.
    const std::vector<Shape> island{{box(0.2, 0.2, 0.6, 0.6), 1, {box(0.4, 0.4, 0.2, 0.2)}}};
    EXPECT_NEAR(areas(island, nullptr, 1e-3, h, Coverage::whole).at(1), 0.32, 1e-13);

    Ring left{{0, 0}};
    Ring right{{1, 1}, {1, 0}};
    constexpr int waves = 20;
    for (int i = 0; i <= waves; ++i) {
        const double y = static_cast<double>(i) / waves;
        left.emplace_back(0.5 + (i % 2 == 0 ? 0.2 : -0.2) * h, y);
        right.emplace_back(0.5 - (i % 2 == 0 ? 0.2 : -0.2) * h, y);
    }
    left.emplace_back(0, 1);
    const std::vector<Shape> crossing{{left, 1}, {right, 2}};
    EXPECT_THROW((void)areas(crossing), InputError);
    EXPECT_THROW((void)areas(crossing, nullptr, 1e-3, h, Coverage::whole), InputError);
    InputReport report;
    const auto found = areas(crossing, &report, 1e-3, h, Coverage::first);
    EXPECT_NEAR(found.at(1) + found.at(2), 1, 1e-12);
    EXPECT_NEAR(found.at(1), 0.5 + 0.1 * h, 1e-3 + report.area_changed);
}

TEST(ShapeNetwork, PartsThatTouchNothingKeepTheirBits) {
    const Shape disc{{{0.3, 0.3}, {0.5, 0.25}, {0.6, 0.5}, {0.35, 0.6}}, 1};
    Shape named = disc;
    named.outline.push_back(named.outline.front());
    named.name = "disc";
    const InitialOptions options{.edge_length = 0.05};
    const auto one = initial_complex<double>({}, {disc}, options);
    const auto other = initial_complex<double>({}, {named}, options);
    ASSERT_EQ(one.vertex_bound(), other.vertex_bound());
    for (std::uint32_t v = 0; v < one.vertex_bound(); ++v) {
        EXPECT_EQ(one.position(Vertex{v}), other.position(Vertex{v}));
    }
}

// Four cells that nearly meet in a point, with a border of a tenth of an edge length between two of
// them; and a cell of that size where three others meet.
TEST(ShapeNetwork, JunctionsTooCloseForTheMeshBecomeOne) {
    constexpr double e = 0.0025;
    const Point<double> low(0.5, 0.5 - e);
    const Point<double> high(0.5, 0.5 + e);
    const Ring left{{0, 0}, low, high, {0, 1}};
    const Ring right{{1, 0}, {1, 1}, high, low};
    InputReport report;
    const std::vector<Shape> four{
        {left, 1}, {right, 2}, {{{0, 0}, {1, 0}, low}, 3}, {{{0, 1}, high, {1, 1}}, 4}};
    for (const auto& [phase, area] : areas(four, &report)) {
        EXPECT_NEAR(area, 0.25, 1e-12) << phase; // as if all four met in the middle
    }
    EXPECT_EQ(report.thinned, 1U);
    EXPECT_EQ(report.dropped, 0U);
    EXPECT_NEAR(report.deviation, e, 1e-15);
    EXPECT_NEAR(report.area_changed, 4 * e / 4, 1e-12);

    const Point<double> side(0.5 + e, 0.5);
    const std::vector<Shape> speck{{left, 1},
                                   {{low, side, high}, 2},
                                   {{{0, 0}, {1, 0}, {1, 0.5}, side, low}, 3},
                                   {{{0, 1}, high, side, {1, 0.5}, {1, 1}}, 4}};
    report = {};
    EXPECT_EQ(areas(speck, &report).size(), 3U);
    EXPECT_EQ(report.dropped, 1U);
}

// One of the two borders of a corner that reaches into the domain is too short for the mesh. The
// other one then runs along the side.
TEST(ShapeNetwork, ACornerThatHardlyReachesIntoTheDomainVanishes) {
    const Point<double> tip(0.5, 0.005);
    const std::vector<Shape> three{{{{0, -0.095}, {0.45, -0.095}, tip, {0.5, 1}, {0, 1}}, 1},
                                   {{tip, {2.5, -0.095}, {2.5, 1}, {0.5, 1}}, 2},
                                   {{tip, {0.45, -0.095}, {2.5, -0.095}}, 3}};
    InputReport report;
    const std::map<Phase, double> found = areas(three, &report);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found.at(1) + found.at(2), 1, 1e-13);
    EXPECT_NEAR(found.at(1), 0.5, 0.0025);
    EXPECT_EQ(report.dropped, 1U);
}

} // namespace
} // namespace dsc::shape_network_test
