// SPDX-License-Identifier: MIT
// At which area pieces of a phase vanish, whatever their shape and the number of their vertices.
#include "support/topology/growing_discs.h"

#include "topology/notes.h"

#include <cmath>
#include <numbers>

namespace dsc::remnants_test {
namespace {

using namespace test::growing_discs;

using P = Point<double>;

// Towards the place, by the same factor everywhere.
Velocity<double> shrink_to(P place) {
    return test::pointwise([place](const P& p) { return P(place - p); });
}

// Phase 1 shrinks, by two percent of its area in a step, until it vanishes: that is at the area
// asked for, but for a few steps.
void expect_vanishes_below(double least_area, Complex<double> complex, P place, double length) {
    test::ChangingOptions<double> shrinking;
    shrinking.edge_length = length;
    shrinking.topology = {.rule = Topology::change, .least_area = least_area};
    test::ChangingSimulation<double> simulation(complex, shrinking);
    for (int step = 0; step < 600; ++step) {
        const test::ChangingReport report = simulation.step(shrink_to(place), 0, 0.01);
        if (!report.events.empty()) {
            EXPECT_EQ(validate(complex).problem, "");
            ASSERT_EQ(report.events.size(), 1U);
            EXPECT_EQ(report.events[0].kind, EventKind::remove);
            EXPECT_EQ(phase_area(complex, 1), 0);
            const double asked = least_area > 0 ? least_area : length * length;
            EXPECT_LE(report.events[0].area, asked);
            EXPECT_GE(report.events[0].area, 0.9 * asked);
            return;
        }
    }
    ADD_FAILURE() << "it does not vanish";
}

TEST(Remnants, VanishBelowTheLeastAreaWhateverTheirShape) {
    for (const double length : {0.04, 0.02}) {
        for (const double squares : {0.0, 1.0, 5.0, 20.0, 50.0}) {
            SCOPED_TRACE(testing::Message() << squares << " squares of " << length);
            const double least_area = squares * length * length;
            const double radius = length * (2 + std::sqrt(squares / 2));
            const int vertices = static_cast<int>(9 * radius / length);
            const P centre(0.5, 0.5);
            for (const auto& shape :
                 {test::circle_points(centre, radius, vertices),
                  std::vector<P>{centre + P(-radius, -radius), centre + P(radius, -radius),
                                 centre + P(radius, radius), centre + P(-radius, radius)}}) {
                const std::vector<Shape> shapes{{shape, 1}};
                expect_vanishes_below(least_area,
                                      initial_complex<double>({}, shapes, {.edge_length = length}),
                                      centre, length);
            }
        }
    }
}

// A quarter of a disc, in a corner of the domain, and the half of one, on a wall.
TEST(Remnants, VanishAtTheWallBelowTheLeastArea) {
    for (const double squares : {1.0, 20.0}) {
        for (const int quarters : {1, 2}) {
            SCOPED_TRACE(testing::Message() << squares << " squares, " << quarters << " quarters");
            const P place(quarters == 1 ? 0.0 : 0.5, 0.0);
            const double radius = h * (2 + 2 * std::sqrt(squares / 2));
            std::vector<P> arc;
            for (int i = 0; i <= 24 * quarters; ++i) {
                const double angle = i * std::numbers::pi / 48;
                arc.push_back(place + radius * P(std::cos(angle), std::sin(angle)));
            }
            (quarters == 1 ? arc.back().x() : arc.back().y()) = 0; // it is, but for rounding
            const std::vector<Curve> curves{{arc, 1, 0}};
            expect_vanishes_below(
                squares * h * h, initial_complex<double>({}, curves, {.edge_length = h}), place, h);
        }
    }
}

} // namespace
} // namespace dsc::remnants_test
