// SPDX-License-Identifier: MIT
// The area at which pieces of a phase vanish, for any shape and number of vertices.
#include "support/topology/growing_discs.h"

#include "topology/notes.h"

#include <cmath>
#include <numbers>

namespace dsc::remnants_test {
namespace {

using namespace test::growing_discs;

using P = Point<double>;

// Shrinks everything towards the point by one factor.
Velocity<double> shrink_to(P place) {
    return test::pointwise([place](const P& p) { return P(place - p); });
}

// Phase 1 shrinks by two per cent of its area in each step; it must vanish at the given area, up to
// a few steps.
void expect_vanishes_below(double min_area, Complex<double> complex, P place, double length) {
    test::ChangingOptions<double> shrinking;
    shrinking.edge_length = length;
    shrinking.topology = {.rule = Topology::change, .min_area = min_area};
    test::ChangingSimulation<double> simulation(complex, shrinking);
    for (int step = 0; step < 600; ++step) {
        const test::ChangingReport report = simulation.step(shrink_to(place), 0, 0.01);
        if (!report.events.empty()) {
            EXPECT_EQ(validate(complex).problem, "");
            ASSERT_EQ(report.events.size(), 1U);
            EXPECT_EQ(report.events[0].kind, EventKind::remove);
            EXPECT_EQ(phase_area(complex, 1), 0);
            const double asked = min_area > 0 ? min_area : length * length;
            EXPECT_LE(report.events[0].area, asked);
            EXPECT_GE(report.events[0].area, 0.9 * asked);
            return;
        }
    }
    ADD_FAILURE() << "it does not vanish";
}

// A whole disc inside, half a disc on the domain boundary, and a quarter in a corner of the domain.
TEST(Remnants, VanishBelowTheLeastAreaWhateverTheirShape) {
    for (const double length : {0.04, 0.02}) {
        for (const double squares : {0.0, 1.0, 5.0, 20.0, 50.0}) {
            for (const int quarters : {1, 2, 4}) {
                SCOPED_TRACE(testing::Message() << squares << " squares of " << length << ", "
                                                << quarters << " quarters");
                const P place(quarters == 1 ? 0.0 : 0.5, quarters == 4 ? 0.5 : 0.0);
                const double radius =
                    length * (2 + (quarters == 4 ? 1 : 2) * std::sqrt(squares / 2));
                const int edges = quarters * static_cast<int>(std::ceil(2.3 * radius / length));
                std::vector<P> arc;
                for (int i = 0; i <= edges; ++i) {
                    const double angle = i * quarters * std::numbers::pi / 2 / edges;
                    arc.push_back(place + radius * P(std::cos(angle), std::sin(angle)));
                }
                const P back = place + radius * P(quarters == 1 ? 0 : -1, quarters == 1 ? 1 : 0);
                arc.back() = quarters == 4 ? arc.front() : back; // it is, but for rounding
                const std::vector<Curve> curves{{arc, 1, 0}};
                expect_vanishes_below(squares * length * length,
                                      initial_complex<double>({}, curves, {.edge_length = length}),
                                      place, length);
            }
        }
    }
}

} // namespace
} // namespace dsc::remnants_test
