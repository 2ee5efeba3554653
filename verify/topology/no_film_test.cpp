// SPDX-License-Identifier: MIT
// Regions that must not count as films, at a contact distance of several edge lengths: round ends,
// tips, wider shapes, and sheets that move apart.
#include "support/topology/growing_discs.h"

#include <cmath>
#include <numbers>

namespace dsc::no_film_test {
namespace {

using namespace test::growing_discs;

// Moves everything towards the centre, or away from it.
Velocity<double> scale(double rate) {
    return test::pointwise([rate](const Point<double>& p) {
        return Point<double>(rate * (p - Point<double>(0.5, 0.5)));
    });
}

void expect_nothing(const std::vector<Shape>& shapes, double contact,
                    const Velocity<double>& velocity, double step, int steps,
                    Opening opening = Opening::squeezed) {
    auto complex = initial_complex<double>({}, shapes, {.edge_length = h});
    test::ChangingOptions<double> options = wide(contact, h);
    options.topology.opening = opening;
    test::ChangingSimulation<double> simulation(complex, options);
    const std::vector<Event> events = run_on(complex, simulation, velocity, step, steps);
    for (const Event& event : events) {
        ADD_FAILURE() << to_string(event.kind) << " of phase " << event.lost << " at " << event.x
                      << ", " << event.y << ", time " << event.time;
    }
}

// Even a disc smaller than the contact distance is no film.
TEST(NoFilm, ADisc) {
    const std::vector<Shape> disc{{test::circle_points({0.5, 0.5}, 0.12, 40), 1}};
    expect_nothing(disc, 4 * h, scale(-1), 0.05, 20);
    expect_nothing(disc, 4 * h, scale(1), 0.05, 20);
    expect_nothing(disc, 4 * h, scale(-1), 0.05, 20, Opening::thin);
}

std::vector<Point<double>> star(int tips, double inner, double outer) {
    std::vector<Point<double>> points;
    for (int i = 0; i < 2 * tips; ++i) {
        const double angle = std::numbers::pi * i / tips;
        points.emplace_back(0.5 + (i % 2 == 0 ? outer : inner) * std::cos(angle),
                            0.5 + (i % 2 == 0 ? outer : inner) * std::sin(angle));
    }
    return points;
}

TEST(NoFilm, AStarWithSharpTips) {
    for (const int tips : {3, 5, 8}) {
        const std::vector<Shape> shapes{{star(tips, 0.14, 0.4), 1}};
        expect_nothing(shapes, 2 * h, scale(-1), 0.05, 10);
        expect_nothing(shapes, 4 * h, scale(-1), 0.05, 10);
        expect_nothing(shapes, 4 * h, scale(0.5), 0.05, 4);
    }
}

// Tips so long that their two sheets are far from each other along the outline.
TEST(NoFilm, ALongThinTip) {
    const std::vector<Shape> shapes{{{{0.05, 0.4}, {0.95, 0.5}, {0.05, 0.6}}, 1}};
    expect_nothing(shapes, 1.5 * h, scale(-1), 0.05, 10);
    const std::vector<Shape> rhombus{{{{0.02, 0.5}, {0.5, 0.4}, {0.98, 0.5}, {0.5, 0.6}}, 1}};
    expect_nothing(rhombus, 1.5 * h, scale(-1), 0.05, 10);
}

TEST(NoFilm, SheetsThatMoveApart) {
    auto complex = discs_apart(2 * h, h);
    test::ChangingSimulation<double> simulation(complex, wide(4 * h, h));
    EXPECT_TRUE(run_on(complex, simulation, grow(2 * h, -1), step_dt, 8).empty());
    EXPECT_EQ(pieces(complex, 1), 2);
    // If films open without being squeezed, the discs merge at once, in a single event.
    auto another = discs_apart(2 * h, h);
    test::ChangingOptions<double> thin = wide(4 * h, h);
    thin.topology.opening = Opening::thin;
    test::ChangingSimulation<double> thinning(another, thin);
    const std::vector<Event> events = run_on(another, thinning, grow(2 * h, -0.1), step_dt, 8);
    EXPECT_EQ(count(events, EventKind::merge), 1U);
    EXPECT_EQ(count(events, EventKind::split), 0U);
    EXPECT_EQ(pieces(another, 1), 1);
}

// The neck that an opened film leaves is as thin as the film was, and must not close again.
TEST(NoFilm, ANeckThatAFilmHasLeft) {
    constexpr double gap = 3.7 * h;
    auto complex = discs_apart(gap, h);
    test::ChangingOptions<double> thin = wide(4 * h, h);
    thin.topology.opening = Opening::thin;
    test::ChangingSimulation<double> simulation(complex, thin);
    const std::vector<Event> events = run_on(complex, simulation, grow(gap, 0.02), step_dt, 12);
    EXPECT_EQ(count(events, EventKind::merge), 1U);
    EXPECT_EQ(count(events, EventKind::split), 0U);
    EXPECT_EQ(pieces(complex, 1), 1);
}

} // namespace
} // namespace dsc::no_film_test
