// SPDX-License-Identifier: MIT
// The application's choices: rules for all phases or for a pair, its own decision on each event,
// and the reports of events.
#include "support/topology/growing_discs.h"

#include "dsc/base/error.h"
#include "replay/edits.h"

#include <array>
#include <stdexcept>

namespace dsc::rules_test {
namespace {

using namespace test::growing_discs;

double area_that_changed_hands(const std::vector<Event>& events) {
    double sum = 0;
    for (const Event& event : events) {
        sum += event.area;
    }
    return sum;
}

TEST(Topology, EveryAreaThatChangesHandsIsTold) {
    for (const bool is_wide : {false, true}) {
        const double gap = is_wide ? 0.12 : nearby;
        auto complex = is_wide ? discs_apart(gap) : discs_nearby();
        Complex<double> replayed = complex;
        test::ChangingSimulation<double> simulation(complex, wide(is_wide ? 4 * h : 0));
        std::vector<Event> heard;
        simulation.topology().add_listener([&](std::span<const Event> events) {
            heard.insert(heard.end(), events.begin(), events.end());
        });
        // The triangles as they are when they change their phase: they may be mended afterwards.
        double relabelled = 0;
        simulation.add_listener([&](std::span<const Edit> edits) {
            for (const Edit& edit : edits) {
                if (edit.kind == EditKind::relabel) {
                    relabelled += area(replayed, Triangle{triangle_of(edit.corner)});
                }
                EXPECT_EQ(replay<double>(replayed, std::span(&edit, 1)).skipped, 0U);
            }
        });
        const std::vector<Event> events = run_on(complex, simulation, grow(gap), step_dt, 9);
        ASSERT_EQ(heard.size(), events.size());
        EXPECT_NEAR(area_that_changed_hands(heard), relabelled, 1e-15);
        EXPECT_GT(relabelled, is_wide ? 10 * h * h : 1e-5);
    }
}

TEST(Topology, ASeamDoesNotGoOnWhereItIsNotToBeFollowed) {
    const auto events_of = [](bool follows_seams) {
        test::ChangingOptions<double> own = options();
        own.topology.follows_seams = follows_seams;
        auto complex = discs_nearby();
        test::ChangingSimulation<double> simulation(complex, own);
        return run(complex, simulation).events;
    };
    const std::vector<Event> followed = events_of(true);
    const std::vector<Event> left = events_of(false);
    ASSERT_FALSE(left.empty());
    EXPECT_EQ(left.front().kind, EventKind::merge);
    EXPECT_EQ(left.front().time, followed.front().time);
    EXPECT_LT(left.front().area, followed.front().area);
    EXPECT_GT(count(followed, EventKind::widen), 0U);
    EXPECT_EQ(count(left, EventKind::widen), 0U);
}

TEST(Topology, EachPairOfPhasesHasItsOwnRule) {
    test::ChangingOptions<double> own = options(Topology::keep);
    own.topology.pairs = {{.one = 0, .other = 1, .rule = Topology::change}};
    auto complex = discs_nearby();
    test::ChangingSimulation<double> simulation(complex, own);
    EXPECT_EQ(count(run(complex, simulation).events, EventKind::merge), 1U);

    own = options(Topology::change);
    own.topology.pairs = {{.one = 1, .other = 0, .rule = Topology::keep}};
    auto kept = discs_nearby();
    test::ChangingSimulation<double> keeping(kept, own);
    EXPECT_TRUE(run(kept, keeping).events.empty());
}

// Films are found by their triangles, or, at a contact distance of several edges, by rays across
// them.
TEST(Topology, TheApplicationMaySayNo) {
    for (const double contact : {0.0, 2 * h}) {
        test::ChangingOptions<double> asked = options();
        asked.topology.contact = contact;
        int times = 0;
        Contact seen;
        asked.topology.may_change = [&](const Contact& film) {
            ++times;
            seen = film;
            return false;
        };
        auto complex = discs_nearby();
        test::ChangingSimulation<double> simulation(complex, asked);
        const Grown grown = run(complex, simulation);
        EXPECT_TRUE(grown.events.empty());
        EXPECT_EQ(grown.outlines, 2U);
        EXPECT_GT(times, 0);
        EXPECT_EQ(seen.film, exterior_phase);
        EXPECT_EQ(seen.sides, (std::array<Phase, 2>{1, 1}));
        EXPECT_LE(seen.thickness, contact == 0 ? default_contact * h : contact);
        EXPECT_NEAR(seen.x, 0.5, h);
    }
}

TEST(Topology, WhatTheApplicationThrowsComesOut) {
    test::ChangingOptions<double> asked = options();
    asked.topology.may_change = [](const Contact&) -> bool { throw std::runtime_error("no"); };
    auto complex = discs_nearby();
    test::ChangingSimulation<double> simulation(complex, asked);
    EXPECT_THROW((void)run(complex, simulation), std::runtime_error);
    EXPECT_EQ(validate(complex).problem, "");
    asked.topology.may_change = {};
    simulation.set_options(asked);
    EXPECT_EQ(count(run(complex, simulation).events, EventKind::merge), 1U) << "it goes on";
}

// The complex is replaced during the run by another one without the stage's attributes, which only
// one of the submeshes must create.
TEST(Topology, GoesOnWhereTheComplexIsReplaced) {
    for (const std::uint32_t submeshes : {1U, 6U}) {
        auto complex = discs_nearby();
        test::ChangingSimulation<double> simulation(
            complex, options(),
            Parallel{.threads = 2, .submeshes = submeshes, .always_all_threads = true});
        (void)simulation.step(grow(), 0, 0.3 * h);
        complex = discs_nearby(2);
        const Grown grown = run(complex, simulation);
        EXPECT_EQ(count(grown.events, EventKind::meet), 1U);
        complex = discs_nearby();
        EXPECT_EQ(count(run(complex, simulation).events, EventKind::merge), 1U);
    }
}

// A stage that was used in one simulation examines the complex of the next one anew.
TEST(Topology, AStageServesOneSimulationAfterAnother) {
    auto complex = discs_nearby();
    const auto stage = std::make_shared<TopologyStage<double>>(
        TopologyOptions<double>{.rule = Topology::change, .contact = 2 * h});
    for (const int turn : {0, 1}) {
        complex = discs_nearby();
        Simulation<double> simulation(complex, options());
        EXPECT_THROW(simulation.add_stage(nullptr), InputError);
        simulation.add_stage(stage);
        for (int step = 0; step < 8; ++step) {
            (void)simulation.step(grow(), 0, 0.3 * h);
        }
        EXPECT_EQ(count(stage->take_events(), EventKind::merge), 1U) << turn;
    }
    auto small = initial_complex<double>(
        {}, std::vector<Shape>{{test::circle_points({0.5, 0.5}, h / 2, 12), 1}},
        {.edge_length = h});
    Simulation<double> simulation(small, options());
    EXPECT_THROW(simulation.add_stage(stage), InputError) << "wider than the disc";
}

TEST(TopologyOptions, BadOnesAreRefused) {
    const auto refused = [](auto change) {
        auto complex = discs_nearby();
        test::ChangingOptions<double> bad = options();
        change(bad.topology);
        EXPECT_THROW(test::ChangingSimulation<double>(complex, bad), InputError);
    };
    refused([](auto& t) { t.contact = -1; });
    refused([](auto& t) { t.contact = 0.3; }); // wider than the discs
    refused([](auto& t) { t.contact = std::numeric_limits<double>::quiet_NaN(); });
    refused([](auto& t) { t.min_area = -1; });
    refused([](auto& t) { t.pairs = {{.one = 1, .other = 1}}; });
    refused([](auto& t) { t.pairs = {{.one = 1, .other = 0}, {.one = 0, .other = 1}}; });
    refused([](auto& t) { t.pairs = {{.one = 1, .other = 0, .contact = -1}}; });
    const auto of_pair = [](Phase other) -> PairTopology<double> {
        return {.one = 1, .other = other, .rule = Topology::change, .contact = 100};
    };
    refused([&](auto& t) { t.pairs = {of_pair(0)}; });
    auto complex = discs_nearby();
    test::ChangingOptions<double> of_others = options();
    of_others.topology.pairs = {of_pair(77)};
    EXPECT_NO_THROW(test::ChangingSimulation<double>(complex, of_others));
}

} // namespace
} // namespace dsc::rules_test
