// SPDX-License-Identifier: MIT
// Films that open at a contact distance of several edge lengths: each in one event, when it is as
// thin as that, and without holes.
#include "support/refusal.h"
#include "support/small_meshes.h"
#include "support/topology/growing_discs.h"

#include "dsc/base/error.h"
#include "dsc/geometry/predicates.h"
#include "dsc/queries/locate.h"
#include "topology/films/film_region.h"
#include "topology/region.h"

#include <cmath>
#include <string>

namespace dsc::wide_contact_test {
namespace {

using namespace test::growing_discs;

// From the sub-step in which the film opens on, there is one piece and no hole.
TEST(WideContactOf, DiscsLeaveNoHole) {
    for (const double contact : {1.0, 1.5, 2.5, 3.5, 5.0, 7.0}) {
        constexpr double gap = 0.16;
        auto complex = discs_apart(gap, h);
        auto options = wide(contact * h, h);
        options.topology.may_change =
            [](const Contact& film) { // the widest reaches the sides of the domain
                return film.sides[1] != border_phase;
            };
        test::ChangingSimulation<double> simulation(complex, options);
        bool has_merged = false;
        const auto after = [&](const std::vector<Event>& events) {
            has_merged = has_merged || count(events, EventKind::merge) > 0;
            EXPECT_EQ(pieces(complex, 1), has_merged ? 1 : 2) << contact;
            EXPECT_EQ(pieces(complex, exterior_phase), 1) << contact;
        };
        (void)run_on(complex, simulation, grow(gap), step_dt, 20, after);
        EXPECT_TRUE(has_merged) << contact;
    }
}

// The seam of two discs ends where their film is as thick as the contact distance, and the
// interface crosses the film there almost straight.
TEST(WideContactOf, TheSeamEndsWhereTheFilmIsThicker) {
    constexpr double gap = 0.12;
    constexpr double contact = 4 * h;
    auto complex = discs_apart(gap, h);
    test::ChangingSimulation<double> simulation(complex, wide(contact, h));
    for (int step = 0; step < 9; ++step) {
        (void)simulation.step(grow(gap), step * step_dt, step_dt);
        const double radius = 0.1 + (step + 1) * step_dt;
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

// The contact distance is a fixed length, while the edges become shorter.
TEST(WideContactConvergence, OfAFixedLength) {
    constexpr double contact = 0.02;
    constexpr double gap = 0.06;
    constexpr double expected = (gap - contact) / 2;
    double before = 1;
    for (const double edge_length : {0.02, 0.01, 0.005}) {
        auto complex = discs_apart(gap, edge_length);
        test::ChangingSimulation<double> simulation(complex, wide(contact, edge_length));
        const double step = edge_length / 20;
        const std::vector<Event> events =
            run_on(complex, simulation, grow(gap), step, static_cast<int>(1.2 * expected / step));
        ASSERT_EQ(count(events, EventKind::merge), 1U) << edge_length;
        const double error = std::abs(events.front().time - expected);
        EXPECT_LE(error, edge_length / 20 + 1e-12) << edge_length;
        EXPECT_LT(error, before) << edge_length;
        before = error;
    }
}

TEST(WideContactOf, EachPairIsItsOwn) {
    constexpr double gap = 0.12;
    test::ChangingOptions<double> options = wide(0, h);
    options.topology.pairs = {{.one = 0, .other = 1, .rule = Topology::change, .contact = 4 * h}};
    auto complex = discs_apart(gap, h);
    test::ChangingSimulation<double> simulation(complex, options);
    const std::vector<Event> events = run_on(complex, simulation, grow(gap), step_dt, 6);
    EXPECT_EQ(count(events, EventKind::merge), 1U);

    // If the two sheets have different contact distances, the smaller one counts.
    auto different = discs_apart(gap, h, 2);
    test::ChangingSimulation<double> other(different, options);
    EXPECT_TRUE(run_on(different, other, grow(gap), step_dt, 8).empty());
}

// A slot closes along its whole length, without splitting the block or the exterior.
TEST(WideContactOf, ASlotIsFilled) {
    const std::vector<Point<double>> outline{{0.2, 0.2},   {0.8, 0.2},   {0.8, 0.8},  {0.53, 0.8},
                                             {0.53, 0.35}, {0.47, 0.35}, {0.47, 0.8}, {0.2, 0.8}};
    auto complex =
        initial_complex<double>({}, std::vector<Shape>{{outline, 1}}, {.edge_length = h});
    const Velocity<double> press = test::pointwise([](const Point<double>& p) {
        return Point<double>(std::abs(p.x() - 0.5) > 0.1 ? 0.0 : (p.x() < 0.5 ? 1.0 : -1.0), 0);
    });
    test::ChangingSimulation<double> simulation(complex, wide(2.5 * h, h));
    const std::vector<Event> events = run_on(complex, simulation, press, step_dt, 3);
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
    test::ChangingSimulation<double> simulation(complex, wide(3 * h, h));
    const std::vector<Event> events = run_on(complex, simulation, press, step_dt, 4);
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].kind, EventKind::remove);
    EXPECT_EQ(pieces(complex, 1), 0);
}

// A contact distance wider than a phase is refused, and the error says how to correct it.
TEST(WideContactOf, MoreThanAPhaseIsRefused) {
    auto complex = discs_apart(0.1, h);
    EXPECT_NO_THROW(
        test::ChangingSimulation<double>(complex, wide(0.27, h))); // of both discs together
    const std::string sentence =
        test::refusal([&] { test::ChangingSimulation<double> simulation(complex, wide(0.3, h)); });
    for (const char* words : {"wider than phase 1", "got 0.3;", "0.28"}) {
        EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
    }
    test::ChangingOptions<double> kept = wide(0.1, h);
    kept.topology.pairs = {{.one = 0, .other = 1, .rule = Topology::keep, .contact = 0.3}};
    EXPECT_NO_THROW(test::ChangingSimulation<double>(complex, kept))
        << "nothing opens at this distance";
    test::ChangingSimulation<double> simulation(complex, wide(0.1, h));
    EXPECT_THROW(simulation.set_options(wide(0.3, h)), InputError);
    EXPECT_EQ(simulation.topology().options().contact, 0.1);
}

// A phase that has become thinner than the contact distance during the run is not refused.
TEST(WideContactOf, AShrunkenPhaseIsNotRefused) {
    auto complex = discs_apart(0.1, h);
    test::ChangingOptions<double> options = wide(0.1, h);
    test::ChangingSimulation<double> simulation(complex, options);
    (void)run_on(complex, simulation, grow(0.1, -1), step_dt, 12);
    EXPECT_LT(phase_area(complex, 1), 0.0078) << "of a disc of that diameter";
    options.insertion = Insertion::linear;
    EXPECT_NO_THROW(simulation.set_options(options));
    EXPECT_THROW(test::ChangingSimulation<double>(complex, options), InputError);
}

// Vertex 0 lies to the left of the line from vertex 1 to vertex 2, by less than the rounding error
// of a product. The midpoint of vertices 1 and 2, rounded, lies to its right, although the rounded
// product has the sign for left.
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
    std::vector<Event> events;
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

} // namespace
} // namespace dsc::wide_contact_test
