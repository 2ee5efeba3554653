// SPDX-License-Identifier: MIT
// Angles at junctions by pairs of tensions, while the junctions move: the law of cosines of the
// triangle whose sides are the three tensions (Herring 1951, after Young).
#include "dsc/dsc.h"
#include "geometric_flows/geometric_flows.h"
#include "measures/junctions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dsc::young_test {
namespace {

constexpr double h = 0.01;

struct Case {
    const char* name;
    std::vector<std::pair<std::vector<Point<double>>, Phase>> shapes; // in the unit square
    std::array<double, 3> tensions; // of phases 1 and 2, 1 and 3, 2 and 3
};

// The angle of a phase between its interfaces with the two others.
double angle_deg(double one, double other, double opposite) {
    return std::acos((opposite * opposite - one * one - other * other) / (2 * one * other)) * 180 /
           std::numbers::pi;
}

class Young : public testing::TestWithParam<Case> {};

TEST_P(Young, HoldsAtJunctionsThatMove) {
    std::vector<Shape> shapes;
    for (const auto& [points, phase] : GetParam().shapes) {
        shapes.push_back({points, phase});
    }
    auto complex = initial_complex<double>({{0, 0}, {1, 1}}, shapes, {.edge_length = h});
    const auto [s12, s13, s23] = GetParam().tensions;
    const auto flow = curvature_flow<double>({.pairs = {{.one = 1, .other = 2, .tension = s12},
                                                        {.one = 1, .other = 3, .tension = s13},
                                                        {.one = 2, .other = 3, .tension = s23}}});
    Options<double> options;
    options.edge_length = h;
    options.interface.feature_degrees = 180;
    Simulation<double> simulation(complex, options);
    for (int step = 0; step < 20; ++step) {
        ASSERT_EQ(simulation.step(flow, 0.001 * step, 0.001).unreached, 0U);
    }
    std::array young{angle_deg(s12, s13, s23), angle_deg(s12, s23, s13), angle_deg(s13, s23, s12)};
    std::ranges::sort(young);
    const auto junctions = scenes::measure_junctions(complex);
    ASSERT_EQ(junctions.size(), 1U);
    EXPECT_EQ(junctions[0].sectors, 3U);
    EXPECT_NEAR(junctions[0].min_deg, young.front(), 0.1);
    EXPECT_NEAR(junctions[0].max_deg, young.back(), 0.1);
}

const std::vector<std::pair<std::vector<Point<double>>, Phase>> t_shapes{
    {{{0, 0}, {0.5, 0}, {0.5, 0.6}, {0, 0.6}}, 1},
    {{{0.5, 0}, {1, 0}, {1, 0.6}, {0.5, 0.6}}, 2},
    {{{0, 0.6}, {0.5, 0.6}, {1, 0.6}, {1, 1}, {0, 1}}, 3}};
const std::vector<std::pair<std::vector<Point<double>>, Phase>> y_shapes{
    {{{0, 0}, {0.5, 0}, {0.5, 0.45}, {0, 0.75}}, 1},
    {{{0.5, 0}, {1, 0}, {1, 0.75}, {0.5, 0.45}}, 2},
    {{{0, 0.75}, {0.5, 0.45}, {1, 0.75}, {1, 1}, {0, 1}}, 3}};

INSTANTIATE_TEST_SUITE_P(Angles, Young,
                         testing::Values(Case{"t", t_shapes, {1, 1, 1}},
                                         Case{"t_of_pairs", t_shapes, {0.7, 1, 1.3}},
                                         Case{"y", y_shapes, {1, 1, 1}},
                                         Case{"y_of_pairs", y_shapes, {1.4, 1, 0.8}}),
                         [](const auto& each) { return each.param.name; });

} // namespace
} // namespace dsc::young_test
