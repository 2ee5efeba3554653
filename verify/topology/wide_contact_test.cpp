// SPDX-License-Identifier: MIT
// Films that open at a contact distance of several edge lengths: each as one event, at the time
// when it is that thin, without holes, in every division of the mesh and for any number of threads.
#include "support/topology/wide_contact.h"
#include "support/ways.h"

#include "dsc/base/error.h"
#include "dsc/parallel/parallel.h"
#include "dsc/quality/measures.h"
#include "dsc/queries/locate.h"
#include "dsc/queries/validate.h"
#include "topology/region.h"

namespace dsc::wide_contact_test {
namespace {

using test::count;
using test::Events;
using test::grow_apart;
using test::pieces;
using test::run_on;
using test::two_discs_apart;
using test::velocity_of;
using test::wide_options;

constexpr double h = 0.02;
constexpr double dt = 0.3 * h;

class WideContact : public testing::TestWithParam<Division> {
protected:
    // The same events and the same mesh with one thread and with three.
    template <class Make, class Check>
    void in_threads(Make make, double contact, const Velocity<double>& velocity, double step,
                    int steps, Check check) {
        std::uint64_t hash = 0;
        for (const std::uint32_t threads : {1U, 3U}) {
            Complex<double> complex = make();
            test::ChangingSimulation<double> simulation(
                complex, wide_options(contact, h),
                Parallel{.threads = threads, .division = GetParam(), .always_all_threads = true});
            const Events events = run_on(complex, simulation, velocity, step, steps);
            check(complex, events);
            hash = hash == 0 ? mesh_hash(complex) : hash;
            EXPECT_EQ(mesh_hash(complex), hash) << "the number of threads makes a difference";
        }
    }
};

TEST_P(WideContact, TwoDiscsMergeOnce) {
    constexpr double gap = 0.12;
    for (const double contact : {2 * h, 4 * h}) {
        const auto make = [] { return two_discs_apart(gap, h); };
        const auto check = [&](const Complex<double>& complex, const Events& events) {
            ASSERT_EQ(count(events, EventKind::merge), 1U);
            EXPECT_EQ(count(events, EventKind::widen) + 1, events.size());
            const Event& merge = events.front();
            EXPECT_EQ(merge.kind, EventKind::merge);
            EXPECT_NEAR(merge.time, (gap - contact) / 2, dt);
            EXPECT_NEAR(merge.x, 0.5, h);
            EXPECT_NEAR(merge.y, 0.5, h);
            EXPECT_EQ(merge.lost, exterior_phase);
            EXPECT_EQ(merge.taken[0], 1U);
            EXPECT_EQ(pieces(complex, 1), 1);
            EXPECT_EQ(pieces(complex, exterior_phase), 1) << "a hole";
        };
        in_threads(make, contact, grow_apart(gap), dt, 12, check);
    }
}

INSTANTIATE_TEST_SUITE_P(Topology, WideContact,
                         testing::Values(Division::fixed, Division::counting, Division::active,
                                         Division::blocks, Division::cells, copy_division),
                         [](const auto& one) { return test::name_of(one.param); });

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

double area_of(const Complex<double>& complex, Phase phase) {
    double sum = 0;
    for (const Triangle t : triangles(complex)) {
        sum += complex.phase(t) == phase ? area(complex, t) : 0.0;
    }
    return sum;
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
    EXPECT_NEAR(area_of(complex, 1), area_of(complex, 2), 0.03 * area_of(complex, 1));
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

TEST(WideContactOf, TheApplicationMaySayNo) {
    constexpr double gap = 0.1;
    test::ChangingOptions<double> asked = wide_options(4 * h, h);
    int times = 0;
    Contact seen;
    asked.topology.may_change = [&](const Contact& contact) {
        ++times;
        seen = contact;
        return false;
    };
    auto complex = two_discs_apart(gap, h);
    test::ChangingSimulation<double> simulation(complex, asked);
    std::uint32_t sub_steps = 0;
    for (int step = 0; step < 5; ++step) {
        sub_steps += simulation.step(grow_apart(gap), step * dt, dt).sub_steps;
    }
    EXPECT_EQ(pieces(complex, 1), 2);
    EXPECT_GT(times, 0);
    EXPECT_LE(times, static_cast<int>(sub_steps)) << "there is one film";
    EXPECT_EQ(seen.film, exterior_phase);
    EXPECT_EQ(seen.sides, (std::array<Phase, 2>{1, 1}));
    EXPECT_NEAR(seen.thickness, gap - 2 * 5 * dt, 1e-3);
    EXPECT_NEAR(seen.x, 0.5, 0.1 * h);
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
    const Velocity<double> press = velocity_of([](const Point<double>& p) {
        return Point<double>(std::abs(p.x() - 0.5) > 0.1 ? 0.0 : (p.x() < 0.5 ? 1.0 : -1.0), 0);
    });
    test::ChangingSimulation<double> simulation(complex, wide_options(2.5 * h, h));
    const Events events = run_on(complex, simulation, press, dt, 3);
    EXPECT_EQ(count(events, EventKind::fill), 1U);
    EXPECT_EQ(count(events, EventKind::split), 0U);
    EXPECT_EQ(pieces(complex, 1), 1);
    EXPECT_EQ(pieces(complex, exterior_phase), 1);
    EXPECT_NEAR(area_of(complex, 1), 0.36, 0.02 * 0.36);
}

TEST(WideContactOf, AThinBarVanishesAtOnce) {
    const std::vector<Point<double>> outline{{0.1, 0.46}, {0.9, 0.46}, {0.9, 0.54}, {0.1, 0.54}};
    auto complex =
        initial_complex<double>({}, std::vector<Shape>{{outline, 1}}, {.edge_length = h});
    const Velocity<double> press =
        velocity_of([](const Point<double>& p) { return Point<double>(0, p.y() < 0.5 ? 1 : -1); });
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
    EXPECT_LT(area_of(complex, 1), 0.0078) << "of a disc of that diameter";
    options.insertion = Insertion::linear;
    EXPECT_NO_THROW(simulation.set_options(options));
    EXPECT_THROW(test::ChangingSimulation<double>(complex, options), InputError);
}

} // namespace
} // namespace dsc::wide_contact_test
