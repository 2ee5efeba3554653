// SPDX-License-Identifier: MIT
// Films that open at a contact distance of several edge lengths: each as one event, at the time
// when it is that thin, without holes. What is no film stays: round ends, tips, shapes wider than
// that, sheets that move apart.
#include "support/pointwise.h"
#include "support/random/scene.h"
#include "support/small_meshes.h"
#include "support/topology/changing.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/base/error.h"
#include "dsc/geometry/predicates.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/quality/measures.h"
#include "dsc/queries/locate.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"
#include "topology/films/film_region.h"
#include "topology/region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace dsc::wide_contact_test {
namespace {

using test::circle_points;

using Events = std::vector<Event>;

test::ChangingOptions<double> wide_options(double contact, double edge_length) {
    test::ChangingOptions<double> result;
    result.edge_length = edge_length;
    result.topology.rule = Topology::change;
    result.topology.contact = contact;
    return result;
}

// Two discs of radius 0.1, `gap` apart, side by side in the middle of the unit square.
Complex<double> two_discs_apart(double gap, double edge_length, Phase second = 1) {
    const int n = static_cast<int>(std::ceil(0.2 * std::numbers::pi / edge_length));
    const std::vector<Shape> shapes{{circle_points({0.4 - gap / 2, 0.5}, 0.1, n), 1},
                                    {circle_points({0.6 + gap / 2, 0.5}, 0.1, n), second}};
    return initial_complex<double>({}, shapes, {.edge_length = edge_length});
}

// Each disc grows about its own centre, or shrinks.
Velocity<double> grow_apart(double gap, double speed = 1) {
    return test::pointwise([=](const Point<double>& p) {
        const double side = p.x() < 0.5 ? -1 : 1;
        const Point<double> centre(0.5 + side * (0.1 + gap / 2), 0.5);
        return Point<double>(speed * (p - centre).normalized());
    });
}

// The number of pieces of a phase.
std::ptrdiff_t pieces(const Complex<double>& complex, Phase phase) {
    const Components all = components(complex);
    return std::ranges::count(all.list, phase, &Component::phase);
}

std::size_t count(const Events& events, EventKind kind) {
    return static_cast<std::size_t>(std::ranges::count(events, kind, &Event::kind));
}

// Steps on, with `after(events of the step)` after each, and returns all events. The complex is
// validated after every step.
template <class After>
Events run_on(Complex<double>& complex, test::ChangingSimulation<double>& simulation,
              const Velocity<double>& velocity, double dt, int steps, After after) {
    Events events;
    for (int step = 0; step < steps; ++step) {
        const test::ChangingReport report = simulation.step(velocity, step * dt, dt);
        events.insert(events.end(), report.events.begin(), report.events.end());
        EXPECT_EQ(validate(complex).problem, "") << "step " << step;
        after(report.events);
    }
    return events;
}
Events run_on(Complex<double>& complex, test::ChangingSimulation<double>& simulation,
              const Velocity<double>& velocity, double dt, int steps) {
    return run_on(complex, simulation, velocity, dt, steps, [](const Events&) {});
}

constexpr double h = 0.02;
constexpr double dt = 0.3 * h;

// From the sub-step in which the film opens on, there is one piece and no hole.
TEST(WideContactOf, DiscsLeaveNoHole) {
    for (const double contact : {1.0, 1.5, 2.5, 3.5, 5.0, 7.0}) {
        constexpr double gap = 0.16;
        auto complex = two_discs_apart(gap, h);
        auto options = wide_options(contact * h, h);
        options.topology.may_change = [](const Contact& film) { // the widest reaches the walls
            return film.sides[1] != border_phase;
        };
        test::ChangingSimulation<double> simulation(complex, options);
        bool has_merged = false;
        const auto after = [&](const Events& events) {
            has_merged = has_merged || count(events, EventKind::merge) > 0;
            EXPECT_EQ(pieces(complex, 1), has_merged ? 1 : 2) << contact;
            EXPECT_EQ(pieces(complex, exterior_phase), 1) << contact;
        };
        (void)run_on(complex, simulation, grow_apart(gap), dt, 20, after);
        EXPECT_TRUE(has_merged) << contact;
    }
}

// Where the film of two discs is as thick as the contact distance, the seam ends, and the interface
// crosses the film nearly straight.
TEST(WideContactOf, TheSeamEndsWhereTheFilmIsThicker) {
    constexpr double gap = 0.12;
    constexpr double contact = 4 * h;
    auto complex = two_discs_apart(gap, h);
    test::ChangingSimulation<double> simulation(complex, wide_options(contact, h));
    for (int step = 0; step < 9; ++step) {
        (void)simulation.step(grow_apart(gap), step * dt, dt);
        const double radius = 0.1 + (step + 1) * dt;
        const double to_sheet = 0.1 + gap / 2 - contact / 2;
        if (radius < to_sheet + 0.5 * h) {
            continue;
        }
        const double end = std::sqrt(radius * radius - to_sheet * to_sheet);
        for (const double side : {-1.0, 1.0}) {
            const auto is_closed = [&](double y) {
                return complex.phase(locate<double>(complex, {0.5, 0.5 + side * y}).triangle) == 1;
            };
            EXPECT_TRUE(is_closed(end - 1.5 * h)) << "step " << step << ", side " << side;
            EXPECT_FALSE(is_closed(end + 1.5 * h)) << "step " << step << ", side " << side;
        }
        double length = 0;
        for (const Triangle t : triangles(complex)) {
            for (std::uint32_t i = 0; i < 3; ++i) {
                const Corner c = corner_of(t.id, i);
                const Point<double> middle =
                    midpoint<double>(complex.position(Vertex{complex.vertex(next(c))}),
                                     complex.position(Vertex{complex.vertex(prev(c))}));
                length += complex.phase(t) == 1 && is_sheet(complex, c) &&
                                  std::abs(middle.x() - 0.5) < contact / 4
                              ? direction(complex, c).norm()
                              : 0.0;
            }
        }
        EXPECT_LT(length, 1.25 * contact) << "step " << step;
    }
}

// The physical contact distance stays, and the edges become shorter.
TEST(WideContactConvergence, OfAFixedLength) {
    constexpr double contact = 0.02;
    constexpr double gap = 0.06;
    constexpr double expected = (gap - contact) / 2;
    double before = 1;
    for (const double edge_length : {0.02, 0.01, 0.005}) {
        auto complex = two_discs_apart(gap, edge_length);
        test::ChangingSimulation<double> simulation(complex, wide_options(contact, edge_length));
        const double step = edge_length / 20;
        const Events events = run_on(complex, simulation, grow_apart(gap), step,
                                     static_cast<int>(1.2 * expected / step));
        ASSERT_EQ(count(events, EventKind::merge), 1U) << edge_length;
        const double error = std::abs(events.front().time - expected);
        EXPECT_LE(error, edge_length / 20 + 1e-12) << edge_length;
        EXPECT_LT(error, before) << edge_length;
        before = error;
    }
}

TEST(WideContactOf, TwoPhasesMeetWithoutMixing) {
    constexpr double gap = 0.12;
    auto complex = two_discs_apart(gap, h, 2);
    test::ChangingSimulation<double> simulation(complex, wide_options(3 * h, h));
    const Events events = run_on(complex, simulation, grow_apart(gap), dt, 10);
    EXPECT_EQ(count(events, EventKind::meet), 1U);
    EXPECT_EQ(count(events, EventKind::widen) + 1, events.size());
    EXPECT_NEAR(events.front().time, (gap - 3 * h) / 2, dt);
    EXPECT_EQ(events.front().taken, (std::array<Phase, 2>{1, 2}));
    EXPECT_EQ(pieces(complex, 1), 1);
    EXPECT_EQ(pieces(complex, 2), 1);
    EXPECT_EQ(pieces(complex, exterior_phase), 1);
    EXPECT_NEAR(phase_area(complex, 1), phase_area(complex, 2), 0.03 * phase_area(complex, 1));
}

TEST(WideContactOf, EachPairIsItsOwn) {
    constexpr double gap = 0.12;
    test::ChangingOptions<double> options = wide_options(0, h);
    options.topology.pairs = {{.one = 0, .other = 1, .rule = Topology::change, .contact = 4 * h}};
    auto complex = two_discs_apart(gap, h);
    test::ChangingSimulation<double> simulation(complex, options);
    const Events events = run_on(complex, simulation, grow_apart(gap), dt, 6);
    EXPECT_EQ(count(events, EventKind::merge), 1U);

    // A film opens at the smaller distance of its two sheets.
    auto different = two_discs_apart(gap, h, 2);
    test::ChangingSimulation<double> other(different, options);
    EXPECT_TRUE(run_on(different, other, grow_apart(gap), dt, 8).empty());
}

TEST(WideContactOf, EveryAreaThatChangesHandsIsTold) {
    constexpr double gap = 0.12;
    auto complex = two_discs_apart(gap, h);
    test::ChangingSimulation<double> simulation(complex, wide_options(4 * h, h));
    double relabelled = 0;
    simulation.add_listener([&](std::span<const Edit> edits) {
        for (const Edit& edit : edits) {
            if (edit.kind == EditKind::relabel) {
                relabelled += area(complex, Triangle{triangle_of(edit.corner)});
            }
        }
    });
    const Events events = run_on(complex, simulation, grow_apart(gap), dt, 10);
    double told = 0;
    for (const Event& event : events) {
        told += event.area;
    }
    EXPECT_NEAR(told, relabelled, 1e-15);
    EXPECT_GT(told, 10 * h * h);
}

// A slot closes from end to end: the block does not fall apart, and neither does the exterior.
TEST(WideContactOf, ASlotIsFilled) {
    const std::vector<Point<double>> outline{{0.2, 0.2},   {0.8, 0.2},   {0.8, 0.8},  {0.53, 0.8},
                                             {0.53, 0.35}, {0.47, 0.35}, {0.47, 0.8}, {0.2, 0.8}};
    auto complex =
        initial_complex<double>({}, std::vector<Shape>{{outline, 1}}, {.edge_length = h});
    const Velocity<double> press = test::pointwise([](const Point<double>& p) {
        return Point<double>(std::abs(p.x() - 0.5) > 0.1 ? 0.0 : (p.x() < 0.5 ? 1.0 : -1.0), 0);
    });
    test::ChangingSimulation<double> simulation(complex, wide_options(2.5 * h, h));
    const Events events = run_on(complex, simulation, press, dt, 3);
    EXPECT_EQ(count(events, EventKind::fill), 1U);
    EXPECT_EQ(count(events, EventKind::split), 0U);
    EXPECT_EQ(pieces(complex, 1), 1);
    EXPECT_EQ(pieces(complex, exterior_phase), 1);
    EXPECT_NEAR(phase_area(complex, 1), 0.36, 0.02 * 0.36);
}

TEST(WideContactOf, AThinBarVanishesAtOnce) {
    const std::vector<Point<double>> outline{{0.1, 0.46}, {0.9, 0.46}, {0.9, 0.54}, {0.1, 0.54}};
    auto complex =
        initial_complex<double>({}, std::vector<Shape>{{outline, 1}}, {.edge_length = h});
    const Velocity<double> press = test::pointwise(
        [](const Point<double>& p) { return Point<double>(0, p.y() < 0.5 ? 1 : -1); });
    test::ChangingSimulation<double> simulation(complex, wide_options(3 * h, h));
    const Events events = run_on(complex, simulation, press, dt, 4);
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].kind, EventKind::remove);
    EXPECT_EQ(pieces(complex, 1), 0);
}

// Wider than a phase: refused with all that is needed to correct it.
TEST(WideContactOf, MoreThanAPhaseIsRefused) {
    auto complex = two_discs_apart(0.1, h);
    EXPECT_NO_THROW(
        test::ChangingSimulation<double>(complex, wide_options(0.27, h))); // of both discs together
    try {
        test::ChangingSimulation<double> simulation(complex, wide_options(0.3, h));
        ADD_FAILURE() << "not refused";
    } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("wider than phase 1"), std::string::npos) << error.what();
        EXPECT_EQ(error.value(), "0.3");
        EXPECT_NE(error.allowed().find("0.28"), std::string::npos) << error.what();
    }
    test::ChangingOptions<double> kept = wide_options(0.1, h);
    kept.topology.pairs = {{.one = 0, .other = 1, .rule = Topology::keep, .contact = 0.3}};
    EXPECT_NO_THROW(test::ChangingSimulation<double>(complex, kept))
        << "nothing opens at this distance";
    test::ChangingSimulation<double> simulation(complex, wide_options(0.1, h));
    EXPECT_THROW(simulation.set_options(wide_options(0.3, h)), InputError);
    EXPECT_EQ(simulation.topology().options().contact, 0.1);
}

// A phase that has shrunk since is no mistake of the options.
TEST(WideContactOf, AShrunkenPhaseIsNotRefused) {
    auto complex = two_discs_apart(0.1, h);
    test::ChangingOptions<double> options = wide_options(0.1, h);
    test::ChangingSimulation<double> simulation(complex, options);
    (void)run_on(complex, simulation, grow_apart(0.1, -1), dt, 12);
    EXPECT_LT(phase_area(complex, 1), 0.0078) << "of a disc of that diameter";
    options.insertion = Insertion::linear;
    EXPECT_NO_THROW(simulation.set_options(options));
    EXPECT_THROW(test::ChangingSimulation<double>(complex, options), InputError);
}

// Vertex 0 lies on the left of the line from vertex 1 to vertex 2, by less than the rounding of a
// product; the middle between these two lies on its right, where the sign of the product says left.
TEST(WideContactOf, AFilmIsStraightenedOnlyToWhereNoTriangleIsTurnedOver) {
    const std::vector<Point<double>> points{{0x1.d244a038274dcp-2, 0x1.d30c0e5967d9bp-2},
                                            {0x1.2785a781dd289p-3, 0x1.2f23ee84f2e01p-3},
                                            {0x1.88633657b0033p-1, 0x1.874312b82b214p-1},
                                            {0.3, 0.61},
                                            {0.64, 0.27},
                                            {0.58, 0.95},
                                            {-0.04, 0.33}};
    auto complex = test::build<double>(
        points, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 4, 2}, {2, 5, 3}, {3, 6, 1}},
        {exterior_phase, exterior_phase, exterior_phase, 2, 1, 1});
    ASSERT_EQ(validate(complex).problem, "");
    const Point<double> middle = (points[1] + points[2]) / 2;
    ASSERT_LT(orientation<double>(middle, points[1], points[2]), 0);
    ASSERT_GT(cross<double>(points[1] - middle, points[2] - middle), 0);
    const TopologyOptions<double> options{.rule = Topology::change, .contact = 4};
    Events events;
    TopologyWork<double> work{
        .complex = complex, .options = options, .edge_length = 1, .time = 0, .events = events};
    FilmRegion<double> region(work, exterior_phase, 4);
    for (const Triangle t : triangles(complex, exterior_phase)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t.id, i);
            if (complex.phase_at(complex.twin(c)) == 1) {
                region.add_ray(c);
            }
        }
    }
    region.smooth();
    EXPECT_EQ(complex.position(Vertex{0}), points[0]);
    EXPECT_EQ(validate(complex).problem, "");
}

// --- what is no film -----------------------------------------------------------------------------

// Everything comes closer to the middle, or goes away from it.
Velocity<double> scale(double rate) {
    return test::pointwise([rate](const Point<double>& p) {
        return Point<double>(rate * (p - Point<double>(0.5, 0.5)));
    });
}

void expect_nothing(const std::vector<Shape>& shapes, double contact,
                    const Velocity<double>& velocity, double step, int steps,
                    Opening opening = Opening::squeezed) {
    auto complex = initial_complex<double>({}, shapes, {.edge_length = h});
    test::ChangingOptions<double> options = wide_options(contact, h);
    options.topology.opening = opening;
    test::ChangingSimulation<double> simulation(complex, options);
    const Events events = run_on(complex, simulation, velocity, step, steps);
    for (const Event& event : events) {
        ADD_FAILURE() << to_string(event.kind) << " of phase " << event.lost << " at " << event.x
                      << ", " << event.y << ", time " << event.time;
    }
}

// Also one that has become smaller than the contact distance.
TEST(WideContactOfNone, ADisc) {
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

TEST(WideContactOfNone, AStarWithSharpTips) {
    for (const int tips : {3, 5, 8}) {
        const std::vector<Shape> shapes{{star(tips, 0.14, 0.4), 1}};
        expect_nothing(shapes, 2 * h, scale(-1), 0.05, 10);
        expect_nothing(shapes, 4 * h, scale(-1), 0.05, 10);
        expect_nothing(shapes, 4 * h, scale(0.5), 0.05, 4);
    }
}

// Tips so long that their sheets are far from each other along the outline.
TEST(WideContactOfNone, ALongThinTip) {
    const std::vector<Shape> shapes{{{{0.05, 0.4}, {0.95, 0.5}, {0.05, 0.6}}, 1}};
    expect_nothing(shapes, 1.5 * h, scale(-1), 0.05, 10);
    const std::vector<Shape> rhombus{{{{0.02, 0.5}, {0.5, 0.4}, {0.98, 0.5}, {0.5, 0.6}}, 1}};
    expect_nothing(rhombus, 1.5 * h, scale(-1), 0.05, 10);
}

TEST(WideContactOfNone, SheetsThatMoveApart) {
    auto complex = two_discs_apart(2 * h, h);
    test::ChangingSimulation<double> simulation(complex, wide_options(4 * h, h));
    EXPECT_TRUE(run_on(complex, simulation, grow_apart(2 * h, -1), dt, 8).empty());
    EXPECT_EQ(pieces(complex, 1), 2);
    // If thinness is enough, they merge at once and once.
    auto another = two_discs_apart(2 * h, h);
    test::ChangingOptions<double> thin = wide_options(4 * h, h);
    thin.topology.opening = Opening::thin;
    test::ChangingSimulation<double> thinning(another, thin);
    const Events events = run_on(another, thinning, grow_apart(2 * h, -0.1), dt, 8);
    EXPECT_EQ(count(events, EventKind::merge), 1U);
    EXPECT_EQ(count(events, EventKind::split), 0U);
    EXPECT_EQ(pieces(another, 1), 1);
}

// The neck that a film leaves is as thin as the film was, and does not close again.
TEST(WideContactOfNone, ANeckThatAFilmHasLeft) {
    constexpr double gap = 3.7 * h;
    auto complex = two_discs_apart(gap, h);
    test::ChangingOptions<double> thin = wide_options(4 * h, h);
    thin.topology.opening = Opening::thin;
    test::ChangingSimulation<double> simulation(complex, thin);
    const Events events = run_on(complex, simulation, grow_apart(gap, 0.02), dt, 12);
    EXPECT_EQ(count(events, EventKind::merge), 1U);
    EXPECT_EQ(count(events, EventKind::split), 0U);
    EXPECT_EQ(pieces(complex, 1), 1);
}

} // namespace
} // namespace dsc::wide_contact_test
