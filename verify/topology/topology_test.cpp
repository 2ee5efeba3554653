// SPDX-License-Identifier: MIT
// Phases that meet, merge and split: events, places and times are the same in every division of the
// mesh and for any number of threads, and each event is reported once.

#include "support/topology/growing_discs.h"
#include "support/ways.h"

#include "dsc/algorithm/executor.h"
#include "dsc/algorithm/simulation.h"
#include "dsc/base/names.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/ranges.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>
#include <vector>

namespace dsc::topology_test {
namespace {

using namespace test::growing_discs;
using std::numbers::pi;

class EveryWay : public testing::TestWithParam<const Division*> {};

TEST_P(EveryWay, TwoDiscsMergeOnce) {
    std::uint64_t hash = 0;
    for (const std::uint32_t threads : {1U, 3U}) {
        auto complex = discs_nearby();
        test::ChangingSimulation<double> simulation(
            complex, options(),
            Parallel{.threads = threads, .division = GetParam(), .always_all_threads = true});
        const Grown grown = run(complex, simulation);
        ASSERT_EQ(count(grown.events, EventKind::merge), 1U);
        EXPECT_EQ(count(grown.events, EventKind::split), 0U);
        EXPECT_EQ(count(grown.events, EventKind::fill), 0U);
        EXPECT_EQ(count(grown.events, EventKind::remove), 0U);
        const Event& merge = grown.events.front();
        EXPECT_EQ(merge.kind, EventKind::merge);
        // The discs touch at the time 0.025; the film opens earlier, by half the contact distance
        // over the speed, up to a step.
        EXPECT_NEAR(merge.time, 0.025, default_contact * h / 2 + 0.3 * h);
        EXPECT_NEAR(merge.x, 0.5, h);
        EXPECT_EQ(merge.lost, exterior_phase);
        EXPECT_EQ(merge.taken[0], 1U);
        EXPECT_EQ(grown.outlines, 1U);
        hash = hash == 0 ? grown.hash : hash;
        EXPECT_EQ(grown.hash, hash) << "the number of threads makes a difference";
    }
}

TEST_P(EveryWay, WhatTheTopologyDoesIsCounted) {
    auto complex = discs_nearby();
    test::ChangingSimulation<double> simulation(complex, options(),
                                                Parallel{.division = GetParam()});
    std::ptrdiff_t relabelled = 0;
    simulation.add_listener([&](std::span<const Edit> edits) {
        relabelled += std::ranges::count(edits, EditKind::relabel, &Edit::kind);
    });
    OperationCounts counts;
    for (int step = 0; step < 8; ++step) {
        complex.set_phase(Triangle{1}, complex.phase(Triangle{1})); // not of the step
        --relabelled;
        counts += simulation.step(grow(), 0.3 * h * step, 0.3 * h).operations;
    }
    EXPECT_GT(counts.relabelled, 0U);
    EXPECT_EQ(counts.relabelled, static_cast<std::uint64_t>(relabelled));
}

// The second disc blocks the first. Then the second one is removed, as by a change of topology at
// the end of a sub-step: now all vertices of the first one must arrive.
void expect_arrival_once_free(Complex<double>& complex, Executor<double>& executor) {
    const auto to_the_right = test::pointwise(
        [](const Point<double>& p) { return Point<double>(p.x() < 0.5 ? 1 : 0, 0); });
    const double area_before = phase_area(complex, 1);
    complex.journal.readers = 1;
    constexpr double way = 2 * h;
    executor.begin_step();
    (void)executor.compute_targets(to_the_right, 0, way);
    const MoveReport moved = executor.move();
    ASSERT_GT(moved.unreached, 0U);
    for (const Triangle t : triangles(complex)) {
        if (complex.phase(t) == 2) {
            complex.set_phase(t, exterior_phase);
        }
    }
    executor.absorb(complex.journal.records);
    EXPECT_EQ(executor.move_missed({}), moved.unreached);
    executor.end_step();
    EXPECT_EQ(validate(complex).problem, "");
    EXPECT_NEAR(phase_area(complex, 1), area_before, 1e-12);
}

// With one stage, the velocity is the one at the position where a vertex starts.
test::ChangingOptions<double> options_of_one_stage() {
    test::ChangingOptions<double> result = options();
    result.integrator = Integrator::euler;
    return result;
}

Complex<double> discs_that_nearly_meet() {
    auto complex = discs_nearby(2);
    test::ChangingSimulation<double> simulation(complex, options(Topology::keep));
    (void)run(complex, simulation, 0.02);
    return complex;
}

TEST_P(EveryWay, WhatIsSetFreeStillArrives) {
    auto complex = discs_that_nearly_meet();
    const auto executor =
        make_executor(complex, options_of_one_stage(),
                      Parallel{.division = GetParam(), .always_all_threads = true});
    expect_arrival_once_free(complex, *executor);
}

INSTANTIATE_TEST_SUITE_P(Topology, EveryWay, testing::ValuesIn(all_divisions),
                         [](const auto& one) { return test::name_of(one.param); });

// Two squares, joined by a neck with five waists, whose sheets approach each other along its whole
// length.
Complex<double> squares_with_a_neck() {
    std::vector<Point<double>> upper;
    for (double x = 0.62; x > 0.379; x -= h) {
        upper.emplace_back(x, 0.5 + 0.0095 - 0.002 * std::cos((x - 0.5) * 2 * pi / 0.06));
    }
    std::vector<Point<double>> outline{{0.62, 0.42}, {0.78, 0.42}, {0.78, 0.58}, {0.62, 0.58}};
    outline.insert(outline.end(), upper.begin(), upper.end());
    outline.insert(outline.end(), {{0.38, 0.58}, {0.22, 0.58}, {0.22, 0.42}, {0.38, 0.42}});
    for (auto p = upper.rbegin(); p != upper.rend(); ++p) {
        outline.emplace_back(p->x(), 1 - p->y());
    }
    return initial_complex<double>({}, std::vector<Shape>{{outline, 1}}, {.edge_length = h});
}

Velocity<double> squeeze() {
    return test::pointwise([](const Point<double>& p) {
        const double share = std::clamp((0.13 - std::abs(p.x() - 0.5)) / 0.02, 0.0, 1.0);
        return Point<double>(0, p.y() > 0.5 ? -share : share);
    });
}

// The neck opens at all its waists in the same sub-step, which is one event, not five: the parts
// between the waists are thin as well, so the seam extends over them.
TEST_P(EveryWay, ANeckThatClosesInManyPlacesSplitsOnce) {
    for (const std::uint32_t threads : {1U, 3U}) {
        auto complex = squares_with_a_neck();
        test::ChangingSimulation<double> simulation(
            complex, options(),
            Parallel{.threads = threads, .division = GetParam(), .always_all_threads = true});
        const std::vector<Event> events = run_on(complex, simulation, squeeze(), 0.001, 8);
        ASSERT_EQ(count(events, EventKind::split), 1U);
        EXPECT_EQ(events.front().kind, EventKind::split);
        std::ptrdiff_t at_once = 0;
        for (const Event& event : events) {
            at_once = std::max(at_once, std::ranges::count(events, event.time, &Event::time));
        }
        EXPECT_GE(at_once, 3) << "the neck is to open in several places";
        EXPECT_EQ(count(events, EventKind::merge), 0U);
        EXPECT_EQ(outlines(complex, 1).size(), 2U);
    }
}

TEST(Topology, TwoPhasesMeetWithoutMixing) {
    for (const double contact : {0.0, 2 * h}) {
        auto complex = discs_nearby(2);
        test::ChangingSimulation<double> simulation(complex, wide(contact));
        const Grown grown = run(complex, simulation);
        EXPECT_EQ(count(grown.events, EventKind::meet), 1U);
        EXPECT_EQ(count(grown.events, EventKind::merge), 0U);
        for (const Phase phase : {0U, 1U, 2U}) {
            EXPECT_EQ(pieces(complex, phase), 1) << phase;
        }
        if (contact > 0) {
            EXPECT_NEAR(grown.events.front().time, (nearby - contact) / 2, step_dt);
            const auto [one, other] =
                std::minmax(grown.events.front().taken[0], grown.events.front().taken[1]);
            EXPECT_TRUE(one == 1 && other == 2);
            EXPECT_EQ(count(grown.events, EventKind::widen) + 1, grown.events.size());
        }
        const double tolerated = contact > 0 ? 0.03 : 0.02; // one phase may get a whole film
        EXPECT_NEAR(phase_area(complex, 1) / phase_area(complex, 2), 1, tolerated);
    }
}

// Two fronts of one speed meet half-way between the discs, and no triangle changes its phase.
TEST(Topology, FrontsMeetHalfWay) {
    auto complex = discs_nearby(2);
    test::ChangingSimulation<double> simulation(complex, options());
    std::size_t relabelled = 0;
    simulation.add_listener([&](std::span<const Edit> edits) {
        relabelled +=
            static_cast<std::size_t>(std::ranges::count(edits, EditKind::relabel, &Edit::kind));
    });
    std::vector<Event> events;
    for (double time = 0; events.empty() && time < 0.05; time += 0.3 * h) {
        events = simulation.step(grow(), time, 0.3 * h).events;
    }
    ASSERT_FALSE(events.empty());
    EXPECT_NE(events.front().taken[0], events.front().taken[1]);
    EXPECT_EQ(relabelled, 0U);
    int met = 0;
    for (const Vertex v : vertices(complex)) {
        std::set<Phase> phases;
        for_each_corner(complex, v, [&](Corner c) { phases.insert(complex.phase_at(c)); });
        if (phases.contains(1) && phases.contains(2)) {
            EXPECT_NEAR(complex.position(v).x(), 0.5, 0.05 * h);
            ++met;
        }
    }
    EXPECT_GE(met, 1);
}

// A flow that keeps areas makes a filament thin without squeezing it, so the filament is not cut,
// except by the rule that opens all thin films.
TEST(Topology, AFilamentIsDrawnOutWithoutEnd) {
    const std::vector<Shape> shapes{{test::circle_points({0.5, 0.5}, 0.12, 50), 1}};
    const auto strain = test::pointwise(
        [](const Point<double>& p) { return Point<double>(p.x() - 0.5, 0.5 - p.y()); });
    for (const Opening opening : {Opening::squeezed, Opening::thin}) {
        auto complex = initial_complex<double>({{-6, 0}, {7, 1}}, shapes, {.edge_length = 0.06});
        test::ChangingOptions<double> stretching = options();
        stretching.edge_length = 0.06;
        stretching.topology.opening = opening;
        test::ChangingSimulation<double> simulation(complex, stretching);
        const std::vector<Event> events = run_on(complex, simulation, strain, 0.025, 120);
        EXPECT_EQ(events.empty(), opening == Opening::squeezed)
            << name_in(opening_names, opening) << ": the filament is a tenth of an edge thick";
    }
}

// All vertices of a small disc have their mirror images as targets, which they cannot reach. As the
// disc vanishes in the same sub-step, none of them counts as unreached.
TEST(Topology, WhatVanishesIsNotLeftBehind) {
    for (const Topology rule : {Topology::keep, Topology::change}) {
        const Point<double> centre(0.5, 0.5);
        const std::vector<Shape> shapes{{test::circle_points(centre, 0.58 * h, 6), 1}};
        auto complex = initial_complex<double>({}, shapes, {.edge_length = h});
        test::ChangingOptions<double> in_one = options(rule);
        in_one.sub_step = 2;
        in_one.integrator = Integrator::euler;
        test::ChangingSimulation<double> simulation(complex, in_one);
        constexpr double dt = 0.1;
        const auto mirrored = test::pointwise([&](const Point<double>& p) {
            return Point<double>(2 * (centre.x() - p.x()) / dt, 0);
        });
        const test::ChangingReport report = simulation.step(mirrored, 0, dt);
        EXPECT_EQ(validate(complex).problem, "");
        if (rule == Topology::keep) {
            EXPECT_GT(report.unreached, 0U);
        } else {
            EXPECT_EQ(count(report.events, EventKind::remove), 1U);
            EXPECT_EQ(report.unreached, 0U);
        }
    }
}

} // namespace
} // namespace dsc::topology_test
