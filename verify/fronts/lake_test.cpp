// SPDX-License-Identifier: MIT
// Fronts whose ends run along a shore: past corners that turn by a few degrees, either way, and
// round an island, behind which a front meets itself.
#include "dsc/algorithm/simulation.h"
#include "dsc/complex/ranges.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"
#include "geometric_flows/growth.h"
#include "geometric_flows/growth_features.h"
#include "topology/stage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <vector>

namespace dsc::fronts::lake_test {
namespace {

using P = Point<double>;

constexpr double two_pi = 2 * std::numbers::pi;

std::vector<P> circle(const P& centre, double radius, int corners) {
    std::vector<P> points;
    for (int k = 0; k < corners; ++k) {
        const double angle = two_pi * k / corners;
        points.push_back(centre + radius * P(std::cos(angle), std::sin(angle)));
    }
    return points;
}

// Five bays, in sixty straight pieces.
Polygon lake() {
    std::vector<P> shore;
    for (int k = 0; k < 60; ++k) {
        const double angle = two_pi * k / 60;
        const double radius = 0.36 * (1 + 0.25 * std::cos(5 * angle));
        shore.push_back(P(0.5, 0.5) + radius * P(std::cos(angle), std::sin(angle)));
    }
    return {shore, {circle({0.5, 0.5}, 0.08, 16)}};
}

struct Filled {
    std::uint64_t unreached = 0;
    bool is_full = false;
    bool is_valid = false;
};

std::vector<Shape> discs(const std::vector<P>& places, double radius) {
    std::vector<Shape> shapes;
    for (const P& place : places) {
        shapes.push_back({circle(place, radius, 24), static_cast<Phase>(shapes.size() + 1)});
    }
    return shapes;
}

Filled fill(const Polygon& domain, const std::vector<Shape>& shapes, double h) {
    GrowthOptions<double> growing;
    for (const Shape& shape : shapes) {
        growing.speeds.push_back({shape.phase, 0, 1.0});
    }
    auto complex = initial_complex<double>(domain, shapes, {.edge_length = h});
    const Options<double> options{.edge_length = h};
    Simulation<double> simulation(
        complex, options,
        make_executor(complex, options, Parallel{}, growth_algorithm(complex, growing)));
    simulation.add_stage(
        std::make_shared<TopologyStage<double>>(TopologyOptions<double>{.rule = Topology::change}));
    const InterfaceFlow<double> flow = growth(growing);
    const double dt = h / 2;
    Filled filled;
    for (int step = 0; step * dt < 1.2 && !filled.is_full; ++step) {
        filled.unreached += simulation.step(flow, step * dt, dt).unreached;
        filled.is_full = phase_area(complex, 0) == 0;
    }
    filled.is_valid = validate(complex).ok();
    return filled;
}

// Nothing else may happen in the sub-step in which an end comes to a corner: it goes on round the
// corner all the same.
TEST(FrontsInALake, RunRoundTheCornersOfItsShore) {
    const std::vector<P> bays = circle({0.5, 0.5}, 0.3, 5);
    const std::vector<P> capes = circle({0.5, 0.5}, 0.2, 7);
    for (const std::vector<P>& places : {{bays[1], bays[3]}, bays, capes}) {
        SCOPED_TRACE(testing::Message() << places.size() << " discs");
        const Filled filled = fill(lake(), discs(places, 0.03), 0.015);
        EXPECT_TRUE(filled.is_full);
        EXPECT_TRUE(filled.is_valid);
        EXPECT_EQ(filled.unreached, 0U);
    }
}

// Both ends of the film between the two parts of the front are on the shore, and it is thin over
// many edges at once: it opens there, although the way from one part to the other along the shore
// is short. Both parts then close like a zip, from a notch between them whose sides come to lie on
// each other.
TEST(FrontsInALake, MeetThemselvesBehindAnIsland) {
    struct Island {
        int corners;
        double turn; // in radians
        double h = 0.02;
    };
    for (const auto& [corners, turn, h] : {Island{12, 0},
                                           {16, 0.13},
                                           {16, 0.13, 0.01},
                                           {24, 0.26},
                                           {5, 0.39},
                                           {7, 0.52},
                                           {4, 0.65}}) {
        SCOPED_TRACE(testing::Message() << "an island of " << corners << " corners, h = " << h);
        std::vector<P> island;
        for (int k = 0; k < corners; ++k) {
            const double angle = turn + two_pi * k / corners;
            island.push_back(P(0.55, 0.5) + P(0.15 * std::cos(angle), -0.12 * std::sin(angle)));
        }
        const Polygon square{{P(0, 0), P(1, 0), P(1, 1), P(0, 1)}, {island}};
        const Filled filled = fill(square, discs({P(0.2, 0.47)}, 0.08), h);
        EXPECT_TRUE(filled.is_full);
        EXPECT_TRUE(filled.is_valid);
        EXPECT_EQ(filled.unreached, 0U);
    }
}

} // namespace
} // namespace dsc::fronts::lake_test
