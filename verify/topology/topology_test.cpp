// SPDX-License-Identifier: MIT
// Phases that meet, merge and part: what happens, where and when, is the same in every division of
// the mesh and for any number of threads, and each event is told once.
#include "dsc/topology/change.h"

#include "support/random_scene.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/parallel/parallel.h"
#include "dsc/quality/measures.h"
#include "dsc/queries/hash.h"
#include "dsc/queries/outlines.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace dsc {
namespace {

constexpr double h = 0.02;
using std::numbers::pi;

// Two discs of radius 0.1, 0.05 apart, the second of phase `second`.
Complex<double> two_discs(Phase second = 1) {
    const std::vector<Shape> shapes{{test::circle_points({0.375, 0.5}, 0.1, 45), 1},
                                    {test::circle_points({0.625, 0.5}, 0.1, 45), second}};
    return initial_complex<double>({}, shapes, {.edge_length = h});
}

// Each disc grows about its own centre at speed 1.
Velocity<double> grow() {
    return
        [](std::span<const Point<double>> positions, double, std::span<Point<double>> velocities) {
            for (std::size_t i = 0; i < positions.size(); ++i) {
                const Point<double> centre(positions[i].x() < 0.5 ? 0.375 : 0.625, 0.5);
                velocities[i] = (positions[i] - centre).normalized();
            }
        };
}

Options<double> options(Topology rule = Topology::change) {
    Options<double> result;
    result.edge_length = h;
    result.topology.rule = rule;
    return result;
}

double area_of(const Complex<double>& complex, Phase phase) {
    double sum = 0;
    for (const Triangle t : triangles(complex)) {
        sum += complex.phase(t) == phase ? area(complex, t) : 0.0;
    }
    return sum;
}

struct Grown {
    std::vector<Event> events;
    std::size_t outlines = 0;
    double area = 0;
    std::uint64_t hash = 0;
};

Grown run(Complex<double>& complex, Simulation<double>& simulation, double duration = 0.05) {
    Grown grown;
    constexpr double dt = 0.3 * h;
    for (double time = 0; time < duration; time += dt) {
        const StepReport report = simulation.step(grow(), time, dt);
        grown.events.insert(grown.events.end(), report.events.begin(), report.events.end());
        EXPECT_EQ(validate(complex).problem, "");
    }
    grown.outlines = outlines(complex, 1).size();
    grown.area = area_of(complex, 1);
    grown.hash = mesh_hash(complex);
    return grown;
}

std::size_t count(const std::vector<Event>& events, EventKind kind) {
    return static_cast<std::size_t>(std::ranges::count(events, kind, &Event::kind));
}

double area_that_changed_hands(const std::vector<Event>& events) {
    double sum = 0;
    for (const Event& event : events) {
        sum += event.area;
    }
    return sum;
}

class EveryWay : public testing::TestWithParam<Division> {};

TEST_P(EveryWay, TwoDiscsMergeOnce) {
    std::uint64_t hash = 0;
    for (const std::uint32_t threads : {1U, 3U}) {
        auto complex = two_discs();
        Simulation<double> simulation(
            complex, options(),
            Parallel{.threads = threads, .division = GetParam(), .always_all_threads = true});
        const Grown grown = run(complex, simulation);
        ASSERT_EQ(count(grown.events, EventKind::merge), 1U);
        EXPECT_EQ(count(grown.events, EventKind::split), 0U);
        EXPECT_EQ(count(grown.events, EventKind::fill), 0U);
        EXPECT_EQ(count(grown.events, EventKind::remove), 0U);
        const Event& merge = grown.events.front();
        EXPECT_EQ(merge.kind, EventKind::merge);
        // They touch at 0.025; half the contact distance over the speed, and a step.
        EXPECT_NEAR(merge.time, 0.025, default_contact * h / 2 + 0.3 * h);
        EXPECT_NEAR(merge.x, 0.5, h);
        EXPECT_EQ(merge.lost, exterior_phase);
        EXPECT_EQ(merge.taken[0], 1U);
        EXPECT_EQ(grown.outlines, 1U);
        hash = hash == 0 ? grown.hash : hash;
        EXPECT_EQ(grown.hash, hash) << "the number of threads makes a difference";
    }
}

// A sub-step that gives up has noted suspects, whose ids may mean anything in the next step.
void expect_no_old_suspects(Complex<double>& complex, Executor<double>& executor) {
    const Velocity<double> velocity = grow();
    std::vector<Suspect<double>> suspects;
    for (const bool is_second : {false, true}) {
        executor.begin_step();
        if (is_second) {
            executor.take_suspects(suspects);
            EXPECT_TRUE(suspects.empty()) << suspects.size() << " of the step before";
        }
        (void)executor.aim(velocity, 0, 0.3 * h);
        if (is_second) {
            executor.take_suspects(suspects);
            EXPECT_FALSE(suspects.empty());
        }
        executor.end_step(); // without a move
    }
    EXPECT_EQ(validate(complex).problem, "");
}

Complex<double> discs_that_nearly_touch() {
    auto complex = two_discs();
    Simulation<double> simulation(complex, options());
    (void)run(complex, simulation, 0.02);
    return complex;
}

TEST_P(EveryWay, SuspectsDoNotOutliveTheirStep) {
    auto complex = discs_that_nearly_touch();
    const auto executor = make_executor(
        complex, options(), Parallel{.division = GetParam(), .always_all_threads = true});
    expect_no_old_suspects(complex, *executor);
}

TEST(Topology, SuspectsDoNotOutliveTheirStep) {
    auto complex = discs_that_nearly_touch();
    SequentialExecutor<double> executor(complex, options(), default_algorithm<double>());
    expect_no_old_suspects(complex, executor);
}

INSTANTIATE_TEST_SUITE_P(Topology, EveryWay,
                         testing::Values(Division::fixed, Division::counting, Division::active,
                                         Division::blocks, Division::cells, Division::copy),
                         [](const auto& one) {
                             return std::string(
                                 divisions().at(static_cast<std::size_t>(one.param)).name);
                         });

// Two squares, joined by a neck with five waists, of which the sheets come closer all along.
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
    return
        [](std::span<const Point<double>> positions, double, std::span<Point<double>> velocities) {
            for (std::size_t i = 0; i < positions.size(); ++i) {
                const Point<double> p = positions[i] - Point<double>(0.5, 0.5);
                const double share = std::clamp((0.13 - std::abs(p.x())) / 0.02, 0.0, 1.0);
                velocities[i] = {0, p.y() > 0 ? -share : share};
            }
        };
}

// The neck opens at its waists, in one and the same sub-step: one event, not five. What is between
// two of them is thin all along, and the seam goes on over it.
TEST_P(EveryWay, ANeckThatClosesInManyPlacesSplitsOnce) {
    for (const std::uint32_t threads : {1U, 3U}) {
        auto complex = squares_with_a_neck();
        Simulation<double> simulation(
            complex, options(),
            Parallel{.threads = threads, .division = GetParam(), .always_all_threads = true});
        std::vector<Event> events;
        for (int step = 0; step < 8; ++step) {
            const StepReport report = simulation.step(squeeze(), 0.001 * step, 0.001);
            events.insert(events.end(), report.events.begin(), report.events.end());
            EXPECT_EQ(validate(complex).problem, "");
        }
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

TEST(Topology, IsKeptUnlessAskedFor) {
    auto complex = two_discs();
    Simulation<double> simulation(complex, options(Topology::keep));
    const Grown grown = run(complex, simulation);
    EXPECT_TRUE(grown.events.empty());
    EXPECT_EQ(grown.outlines, 2U);
}

TEST(Topology, EveryAreaThatChangesHandsIsTold) {
    auto complex = two_discs();
    Simulation<double> simulation(complex, options());
    std::vector<Event> heard;
    simulation.add_event_listener([&](std::span<const Event> events) {
        heard.insert(heard.end(), events.begin(), events.end());
    });
    double relabelled = 0;
    simulation.add_listener([&](std::span<const Edit> edits) {
        for (const Edit& edit : edits) {
            if (edit.kind == EditKind::relabel) {
                relabelled += area(complex, Triangle{triangle_of(edit.corner)});
            }
        }
    });
    const Grown grown = run(complex, simulation);
    ASSERT_EQ(heard.size(), grown.events.size());
    EXPECT_NEAR(area_that_changed_hands(heard), relabelled, 1e-15);
    EXPECT_GT(relabelled, 1e-5);
}

TEST(Topology, TwoPhasesMeetWithoutMixing) {
    auto complex = two_discs(2);
    Simulation<double> simulation(complex, options());
    const Grown grown = run(complex, simulation);
    EXPECT_EQ(count(grown.events, EventKind::meet), 1U);
    EXPECT_EQ(count(grown.events, EventKind::merge), 0U);
    EXPECT_EQ(outlines(complex, 2).size(), 1U);
    EXPECT_EQ(grown.outlines, 1U);
    EXPECT_NEAR(area_of(complex, 1), area_of(complex, 2), 0.02 * area_of(complex, 1));
}

TEST(Topology, EachPairOfPhasesHasItsOwnRule) {
    Options<double> own = options(Topology::keep);
    own.topology.pairs = {{.one = 0, .other = 1, .rule = Topology::change}};
    auto complex = two_discs();
    Simulation<double> simulation(complex, own);
    EXPECT_EQ(count(run(complex, simulation).events, EventKind::merge), 1U);

    own = options(Topology::change);
    own.topology.pairs = {{.one = 1, .other = 0, .rule = Topology::keep}};
    auto kept = two_discs();
    Simulation<double> keeping(kept, own);
    EXPECT_TRUE(run(kept, keeping).events.empty());
}

TEST(Topology, TheApplicationMaySayNo) {
    Options<double> asked = options();
    int times = 0;
    Contact seen;
    asked.topology.may_change = [&](const Contact& contact) {
        ++times;
        seen = contact;
        return false;
    };
    auto complex = two_discs();
    Simulation<double> simulation(complex, asked);
    const Grown grown = run(complex, simulation);
    EXPECT_TRUE(grown.events.empty());
    EXPECT_EQ(grown.outlines, 2U);
    EXPECT_GT(times, 0);
    EXPECT_EQ(seen.film, exterior_phase);
    EXPECT_EQ(seen.sides, (std::array<Phase, 2>{1, 1}));
    EXPECT_LE(seen.thickness, default_contact * h);
    EXPECT_NEAR(seen.x, 0.5, h);
}

TEST(Topology, WhatTheApplicationThrowsComesOut) {
    Options<double> asked = options();
    asked.topology.may_change = [](const Contact&) -> bool { throw std::runtime_error("no"); };
    auto complex = two_discs();
    Simulation<double> simulation(complex, asked);
    EXPECT_THROW((void)run(complex, simulation), std::runtime_error);
    EXPECT_EQ(validate(complex).problem, "");
    asked.topology.may_change = {};
    simulation.set_options(asked);
    EXPECT_EQ(count(run(complex, simulation).events, EventKind::merge), 1U) << "it goes on";
}

// In a flow that keeps areas what becomes thin is a filament, and is not cut.
TEST(Topology, AFilamentIsDrawnOutWithoutEnd) {
    const std::vector<Shape> shapes{{test::circle_points({0.5, 0.5}, 0.12, 50), 1}};
    const Velocity<double> strain = [](std::span<const Point<double>> positions, double,
                                       std::span<Point<double>> velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const Point<double> p = positions[i] - Point<double>(0.5, 0.5);
            velocities[i] = Point<double>(p.x(), -p.y());
        }
    };
    for (const Opening opening : {Opening::squeezed, Opening::thin}) {
        auto complex = initial_complex<double>({{-6, 0}, {7, 1}}, shapes, {.edge_length = 0.06});
        Options<double> stretching = options();
        stretching.edge_length = 0.06;
        stretching.topology.opening = opening;
        Simulation<double> simulation(complex, stretching);
        std::vector<Event> events;
        for (int step = 0; step < 120; ++step) {
            const StepReport report = simulation.step(strain, 0, 0.025);
            events.insert(events.end(), report.events.begin(), report.events.end());
        }
        EXPECT_EQ(events.empty(), opening == Opening::squeezed)
            << name_in(opening_names, opening) << ": the filament is a tenth of an edge thick";
    }
}

TEST(Topology, SmallPiecesVanish) {
    const std::vector<Shape> shapes{{test::circle_points({0.5, 0.5}, 0.1, 40), 1}};
    auto complex = initial_complex<double>({}, shapes, {.edge_length = h});
    const Velocity<double> shrink = [](std::span<const Point<double>> positions, double,
                                       std::span<Point<double>> velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = (Point<double>(0.5, 0.5) - positions[i]).normalized();
        }
    };
    Simulation<double> simulation(complex, options());
    std::vector<Event> events;
    for (double time = 0; time < 0.1; time += 0.002) {
        const StepReport report = simulation.step(shrink, time, 0.002);
        events.insert(events.end(), report.events.begin(), report.events.end());
    }
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].kind, EventKind::remove);
    EXPECT_LE(events[0].area, h * h);
    EXPECT_EQ(area_of(complex, 1), 0);
    EXPECT_EQ(simulation.interface_size(), 0U);
    EXPECT_EQ(validate(complex).problem, "");
}

// All vertices of a small disc are sent to their mirror images, which they cannot reach. As the
// disc vanishes in the same sub-step, none of them is left behind.
TEST(Topology, WhatVanishesIsNotLeftBehind) {
    for (const Topology rule : {Topology::keep, Topology::change}) {
        const Point<double> centre(0.5, 0.5);
        const std::vector<Shape> shapes{{test::circle_points(centre, 0.58 * h, 6), 1}};
        auto complex = initial_complex<double>({}, shapes, {.edge_length = h});
        Options<double> in_one = options(rule);
        in_one.sub_step = 2;
        in_one.integrator = Integrator::euler;
        Simulation<double> simulation(complex, in_one);
        constexpr double dt = 0.1;
        const Velocity<double> mirrored = [&](std::span<const Point<double>> positions, double,
                                              std::span<Point<double>> velocities) {
            for (std::size_t i = 0; i < positions.size(); ++i) {
                velocities[i] = {2 * (centre.x() - positions[i].x()) / dt, 0.0};
            }
        };
        const StepReport report = simulation.step(mirrored, 0, dt);
        EXPECT_EQ(validate(complex).problem, "");
        if (rule == Topology::keep) {
            EXPECT_GT(report.unreached, 0U);
        } else {
            EXPECT_EQ(count(report.events, EventKind::remove), 1U);
            EXPECT_EQ(report.unreached, 0U);
        }
    }
}

TEST(TopologyOptions, BadOnesAreRefused) {
    const auto refused = [](auto change) {
        auto complex = two_discs();
        Options<double> bad = options();
        change(bad.topology);
        EXPECT_THROW(Simulation<double>(complex, bad), InputError);
    };
    refused([](auto& t) { t.contact = -1; });
    refused([](auto& t) { t.contact = 0.3; }); // wider than the discs
    refused([](auto& t) { t.contact = std::numeric_limits<double>::quiet_NaN(); });
    refused([](auto& t) { t.least_area = -1; });
    refused([](auto& t) { t.pairs = {{.one = 1, .other = 1}}; });
    refused([](auto& t) { t.pairs = {{.one = 1, .other = 0}, {.one = 0, .other = 1}}; });
    refused([](auto& t) { t.pairs = {{.one = 1, .other = 0, .contact = -1}}; });
}

} // namespace
} // namespace dsc
