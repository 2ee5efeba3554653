// SPDX-License-Identifier: MIT
// Grains in domains that are no rectangles: their ends slide along oblique and curved sides.
#include "dsc/dsc.h"
#include "geometric_flows/geometric_flows.h"
#include "shapes/shapes.h"
#include "shapes/voronoi.h"
#include "shapes/voronoi_diagram.h"
#include "topology/topology.h"

#include "support/curve_testing.h"

#include <gtest/gtest.h>

namespace dsc::domains_test {
namespace {

using Points = std::vector<Point<double>>;

scenes::Outline circle(double radius, double edge_length) {
    return scenes::circle({0, 0}, radius, edge_length);
}

struct Case {
    const char* name;
    Polygon domain;
    double kept;      // allowed change of an area, relative to the domain's
    double min_angle; // degrees, at the end of every step
};

constexpr double h = 0.03;

Complex<double> grains(const Polygon& domain, const Rectangle& around, std::size_t count,
                       std::uint64_t seed) {
    const Points sites = scenes::random_sites(around, count, seed);
    const auto diagram = scenes::voronoi_diagram(around, sites);
    std::vector<Shape> cells;
    for (std::uint32_t i = 0; i < sites.size(); ++i) {
        cells.push_back({diagram.corners_of(diagram.cells[i]), i + 1});
    }
    return initial_complex<double>(domain, cells, {.edge_length = h});
}

void let_phases_vanish(Simulation<double>& simulation) {
    simulation.add_stage(
        std::make_shared<TopologyStage<double>>(TopologyOptions<double>{.rule = Topology::change}));
}

Options<double> without_features() {
    Options<double> options;
    options.edge_length = h;
    options.interface.feature_degrees = 180;
    return options;
}

class Grains : public testing::TestWithParam<Case> {};

TEST_P(Grains, Coarsen) {
    const Rectangle around{{-1.3, -1.3}, {2.3, 2.3}};
    for (std::uint64_t seed = 1; seed <= 15; ++seed) {
        SCOPED_TRACE(seed);
        auto complex = grains(GetParam().domain, around, 120, seed);
        double area = 0;
        for (const Phase phase : phases(complex)) {
            area += phase_area(complex, phase);
        }
        Simulation<double> simulation(complex, without_features());
        let_phases_vanish(simulation);
        const std::size_t before = phases(complex).size();
        for (int step = 0; step < 40; ++step) {
            EXPECT_EQ(simulation.step(curvature_flow<double>(), 0.001 * step, 0.001).unreached, 0U);
            EXPECT_GT(test::smallest_angle(complex), GetParam().min_angle) << step;
        }
        EXPECT_EQ(validate(complex).problem, "");
        EXPECT_LT(phases(complex).size(), before);
        for (const Phase phase : phases(complex)) {
            area -= phase_area(complex, phase);
        }
        EXPECT_NEAR(area, 0, GetParam().kept);
    }
}

INSTANTIATE_TEST_SUITE_P(
    InDomains, Grains,
    testing::Values(Case{"ring", {circle(1, h), {circle(0.4, h)}}, 5e-3, 5},
                    Case{"l", {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}, 1e-12, 5},
                    Case{"turned", {{{0, 0}, {1.9, 0.6}, {1.6, 1.55}, {-0.3, 0.95}}}, 1e-12, 4.5}),
    [](const auto& each) { return each.param.name; });

// In these two, a grain vanishes in a corner of the domain. It leaves three vertices there, of
// which each is so close to the others that a collapse of one alone leaves a needle.
TEST(Corners, KeepNoNeedleOfAPhaseThatVanishedThere) {
    const Polygon l{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, {}};
    Polygon turned{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {}};
    for (Point<double>& p : turned.outline) {
        const double c = std::cos(0.3);
        const double s = std::sin(0.3);
        p = {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
    }
    for (auto complex : {grains(l, {{-0.1, -0.1}, {2.1, 2.1}}, 60, 7),
                         grains(turned, {{-0.5, -0.1}, {2.1, 1.7}}, 60, 13)}) {
        Simulation<double> simulation(complex, without_features());
        let_phases_vanish(simulation);
        for (int step = 0; step < 5; ++step) {
            EXPECT_EQ(simulation.step(curvature_flow<double>(), 0.001 * step, 0.001).unreached, 0U);
        }
        EXPECT_GT(test::smallest_angle(complex), 5);
    }
}

// A grain meets the side of the domain behind a notch. The curve is then drawn into the notch, and
// its next vertex is blocked for a second time in the same sub-step: it lands, as it would have
// landed for the first time.
TEST(Corners, VerticesThatAnEventLeavesBlockedLand) {
    auto complex = grains({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, {}},
                          {{-1.3, -1.3}, {2.3, 2.3}}, 120, 16);
    Simulation<double> simulation(complex, without_features());
    let_phases_vanish(simulation);
    for (int step = 0; step < 10; ++step) {
        EXPECT_EQ(simulation.step(curvature_flow<double>(), 0.001 * step, 0.001).unreached, 0U);
    }
    EXPECT_EQ(validate(complex).problem, "");
}

} // namespace
} // namespace dsc::domains_test
