// SPDX-License-Identifier: MIT
// A step tells the truth: what it did before something of the application threw, how far it came,
// what it could not do, and where; a step that is refused changes nothing.
#include "support/courses.h"
#include "support/refusal.h"

#include "dsc/algorithm/stage.h"
#include "dsc/base/archive.h"
#include "dsc/base/error.h"
#include "dsc/base/verdict.h"
#include "dsc/operations/edge_split.h"
#include "dsc/passes/mesh/size_update.h"
#include "replay/replay.h"
#include "thesis/divisions/slabs.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace dsc::failed_steps_test {
namespace {

using test::disc;
using test::disc_h;

class FailedSteps : public testing::TestWithParam<test::Course> {};
const std::vector<test::Course> in_place{
    {"sequential", {}}, {"active", &active_division, 2}, {"cells", &cells_division, 2}};
INSTANTIATE_TEST_SUITE_P(Ways, FailedSteps, testing::ValuesIn(in_place), test::course_name);

// The replica of a listener is the complex, also after what the application did in between.
TEST_P(FailedSteps, AreReportedBeforeWhatTheApplicationDoesNext) {
    Complex<double> complex = disc();
    Complex<double> replica = complex;
    auto simulation = test::make_simulation(complex, {.edge_length = disc_h}, GetParam());
    simulation->add_listener([&](std::span<const Edit> edits) {
        EXPECT_EQ(replay<double>(replica, edits).skipped, 0U);
    });
    for (int step = 0; step < 6; ++step) {
        int calls = 0;
        const Velocity<double> breaks = [&](auto positions, double time, auto velocities) {
            test::swirl(positions, time, velocities);
            if (GetParam().division == nullptr ? ++calls == 9 : time > 0.02) {
                throw std::domain_error("as seeded");
            }
        };
        EXPECT_THROW((void)simulation->step(breaks, 0, 0.1), std::domain_error);
        EXPECT_EQ(mesh_hash(replica), mesh_hash(complex));
        test::expect_sound(complex, *simulation);
        const Edge edge = complex.edge(next(complex.vertices[simulation->interface()[0]].corner));
        EXPECT_EQ(edge_split(complex, edge).verdict, Verdict::legal);
        (void)simulation->step(test::swirl, 0.1 * step, 0.01);
        EXPECT_EQ(mesh_hash(replica), mesh_hash(complex));
    }
}

// A pass whose functions throw leaves a list of the whole interface.
TEST_P(FailedSteps, LeaveAListOfTheInterface) {
    Complex<double> complex = disc();
    Options<double> options{.edge_length = disc_h};
    bool is_broken = false;
    options.insertion_function = [&](const CurveNeighbours<double>& curve) {
        if (is_broken) {
            throw std::domain_error("as seeded");
        }
        return insertion_point(Insertion::cubic, curve);
    };
    auto simulation = test::make_simulation(complex, options, GetParam());
    int thrown = 0;
    for (int step = 0; step < 60; ++step) {
        is_broken = step % 2 == 1;
        try {
            (void)simulation->step(test::swirl, 0.02 * step, 0.02);
        } catch (const std::domain_error&) {
            ++thrown;
        }
        test::expect_sound(complex, *simulation);
    }
    EXPECT_GT(thrown, 3);
}

// So does an attribute that throws, in whichever submesh: the edits of the sub-step happen whole.
TEST_P(FailedSteps, OfAttributesThatThrowLeaveTheComplexWhole) {
    Complex<double> complex = disc();
    std::atomic<bool> is_broken = false;
    complex.attributes.add<Vertex, double>("fragile", 1, [&](double a, double, double) {
        if (is_broken) {
            throw std::domain_error("as seeded");
        }
        return a;
    });
    Complex<double> replica = disc();
    auto simulation = test::make_simulation(complex, {.edge_length = disc_h}, GetParam());
    simulation->add_listener([&](std::span<const Edit> edits) {
        EXPECT_EQ(replay<double>(replica, edits).skipped, 0U);
    });
    int thrown = 0;
    for (int step = 0; step < 40; ++step) {
        is_broken = step % 2 == 1;
        try {
            (void)simulation->step(test::swirl, 0.02 * step, 0.02);
        } catch (const std::domain_error&) {
            ++thrown;
        }
        test::expect_sound(complex, *simulation);
        EXPECT_EQ(mesh_hash(replica), mesh_hash(complex));
    }
    EXPECT_GT(thrown, 3);
}

TEST(Steps, EndWhereTheyWereAskedTo) {
    Complex<double> complex = disc();
    Simulation<double> simulation(complex, {.edge_length = disc_h});
    for (int step = 0; step < 20; ++step) {
        const double time = 0.1 * step;
        const double dt = 0.07 + 0.003 * step;
        const StepReport report = simulation.step(test::swirl, time, dt);
        EXPECT_GT(report.sub_steps, 2U);
        EXPECT_EQ(report.reached, time + dt);
    }
    EXPECT_EQ(simulation.step(test::swirl, 0.3, 0).reached, 0.3);
}

TEST(Steps, ThatAreRefusedSayWhichValueIsWrongAndChangeNothing) {
    Complex<double> complex = disc();
    Simulation<double> simulation(complex, {.edge_length = disc_h});
    (void)simulation.step(test::swirl, 0, 0.02);
    const auto state = [&] {
        Archive archive;
        simulation.archive(archive);
        return archive.bytes();
    };
    const std::string before = state();
    const auto refused = [&](double time, double dt) {
        try {
            (void)simulation.step(test::swirl, time, dt);
        } catch (const InputError& error) {
            EXPECT_EQ(state(), before);
            return error.value();
        }
        return std::string("not refused");
    };
    const double infinity = std::numeric_limits<double>::infinity();
    const double largest = std::numeric_limits<double>::max();
    EXPECT_EQ(refused(std::nan(""), 0.25), "time nan, dt 0.25");
    EXPECT_EQ(refused(-infinity, 0.25), "time -inf, dt 0.25");
    EXPECT_EQ(refused(0.25, std::nan("")), "time 0.25, dt nan");
    EXPECT_EQ(refused(0.25, -1), "time 0.25, dt -1");
    EXPECT_EQ(refused(largest, largest), "time " + to_text(largest) + ", dt " + to_text(largest));
}

// Vertices run to and fro across the jump: no step is short enough for the tolerance to hold.
TEST(AdaptiveSteps, SayWhereTheVelocityJumps) {
    for (const double tolerance : {1e-3, 1e-4, 1e-6}) {
        Complex<double> complex = disc();
        Simulation<double> simulation(
            complex,
            {.edge_length = disc_h, .integrator = Integrator::adaptive, .tolerance = tolerance});
        const auto onto = [](double x) {
            return test::pointwise<double>([x](const Point<double>& p, double) {
                return Point<double>(p.x() < x ? 0.5 : -0.5, 0);
            });
        };
        const StepReport report = simulation.step(onto(0.5), 0, 0.1);
        EXPECT_EQ(report.gave_up, GiveUp::velocity_jumps);
        EXPECT_LT(report.sub_steps, 500U);
        EXPECT_LT(report.reached, 0.1);
        ASSERT_TRUE(complex.is_alive(report.where));
        EXPECT_NEAR(complex.position(report.where).x(), 0.5, 0.1 * disc_h);
        EXPECT_EQ(report.speed, 0.5);
        test::expect_sound(complex, simulation);
        // Jumps that the interface crosses, rather than runs along, end no step.
        EXPECT_EQ(simulation.step(test::swirl, 0.1, 0.1).gave_up, GiveUp::none);
    }
}

// A strict tolerance of a smooth flow needs as many, and shorter ones.
TEST(AdaptiveSteps, OfSmoothFlowsMayBeShort) {
    Complex<double> complex = disc();
    Simulation<double> simulation(
        complex, {.edge_length = disc_h, .integrator = Integrator::adaptive, .tolerance = 1e-13});
    const StepReport report = simulation.step(test::swirl, 0, 0.1);
    EXPECT_EQ(report.gave_up, GiveUp::none);
    EXPECT_GT(report.sub_steps, 200U);
}

// A mesh that is to become much finer needs more visits than one pass has room for.
class Refinement : public testing::TestWithParam<test::Course> {};
INSTANTIATE_TEST_SUITE_P(Ways, Refinement, testing::ValuesIn(test::all_courses), test::course_name);

TEST_P(Refinement, GoesOnUntilNoEdgeIsFarTooLong) {
    constexpr double coarse = 0.1;
    constexpr double fine = 0.015;
    Complex<double> complex = test::disc_complex<double>(coarse);
    Options<double> options{.edge_length = coarse, .sizes = {.growth = 1.3}};
    auto simulation = test::make_simulation(complex, options, GetParam());
    options.edge_length = fine;
    options.sizes = {};
    simulation->set_options(options);
    for (int step = 0; step < 40; ++step) {
        (void)simulation->step(test::constant<double>(1e-9, 0), 0, 1);
    }
    test::expect_sound(complex, *simulation);
    std::size_t too_long = 0;
    for (const Triangle t : triangles(complex)) {
        const auto [a, b, c] = complex.positions_of(t);
        too_long += std::max({(a - b).norm(), (b - c).norm(), (c - a).norm()}) > 3 * fine ? 1U : 0U;
    }
    EXPECT_LT(too_long, complex.triangle_count() / 30);
}

// The edits that the application and the sub-steps make reach all listeners once, whatever a
// listener throws.
TEST_P(FailedSteps, OfAListenerLeaveNoGapInTheEditsOfAnother) {
    Complex<double> complex = disc();
    Complex<double> replica = complex;
    auto simulation = test::make_simulation(complex, {.edge_length = disc_h}, GetParam());
    bool breaks = false;
    simulation->add_listener([&](std::span<const Edit> /*edits*/) {
        if (breaks) {
            throw std::domain_error("as seeded");
        }
    });
    simulation->add_listener([&](std::span<const Edit> edits) {
        EXPECT_EQ(replay<double>(replica, edits).skipped, 0U);
    });
    for (int step = 0; step < 6; ++step) {
        const Edge edge = complex.edge(next(complex.vertices[simulation->interface()[0]].corner));
        EXPECT_EQ(edge_split(complex, edge).verdict, Verdict::legal);
        breaks = step % 2 == 0;
        if (breaks) {
            EXPECT_THROW((void)simulation->step(test::swirl, 0, 0.02), std::domain_error);
        } else {
            (void)simulation->step(test::swirl, 0, 0.02);
        }
        EXPECT_EQ(mesh_hash(replica), mesh_hash(complex)) << "step " << step;
    }
}

// What a listener edits while it is told of edits is told later, to all listeners.
TEST(Listeners, ThatEditTheComplexDoNotDisturbWhatTheyAreTold) {
    Complex<double> complex = disc();
    Simulation<double> simulation(complex, {.edge_length = disc_h});
    const auto touch_all = [&] {
        for (const Vertex v : vertices(complex)) {
            complex.set_position(v, complex.position(v));
        }
    };
    int calls = 0;
    std::vector<std::size_t> told;
    simulation.add_listener([&](std::span<const Edit> /*edits*/) {
        const int times = ++calls == 1 ? 10 : 0; // so that the journal needs more room
        for (int i = 0; i < times; ++i) {
            touch_all();
        }
    });
    simulation.add_listener([&](std::span<const Edit> edits) {
        for (const Edit& edit : edits) {
            ASSERT_EQ(edit.kind, EditKind::move);
        }
        told.push_back(edits.size());
    });
    touch_all();
    (void)simulation.step(test::swirl, 0, 0);
    (void)simulation.step(test::swirl, 0, 0);
    const std::size_t once = complex.vertex_count();
    EXPECT_EQ(told, (std::vector<std::size_t>{once, 10 * once}));
    test::expect_sound(complex, simulation);
}

TEST(Options, AreTheOldOnesWhereAFunctionOfNewOnesFails) {
    Complex<double> complex = disc();
    Simulation<double> simulation(complex, {.edge_length = disc_h});
    Options<double> wrong{.edge_length = disc_h, .sizes = {.growth = 1.3}, .tolerance = 1e-3};
    wrong.sizes.by_place = [](const Point<double>& /*place*/, double, Phase) { return -1.0; };
    EXPECT_THROW(simulation.set_options(wrong), InputError);
    EXPECT_TRUE(simulation.options().sizes.is_uniform());
    EXPECT_NE(simulation.options().tolerance, wrong.tolerance);
    EXPECT_NO_THROW((void)simulation.step(test::swirl, 0, 0.02));
    test::expect_sound(complex, simulation);
}

class Standing final : public Stage<double> {
public:
    void run(const Between<double>& /*between*/) override {}
};

// What would change a step while it runs is refused, whoever calls it from there.
TEST(Steps, RefuseWhatBelongsBetweenThem) {
    Complex<double> complex = disc();
    Options<double> options{.edge_length = disc_h};
    Simulation<double> simulation(complex, options);
    Archive archive;
    simulation.archive(archive);
    int refused = 0;
    const auto try_all = [&] {
        EXPECT_THROW((void)simulation.step(test::swirl, 0, 0.01), InputError);
        EXPECT_THROW(simulation.set_options(options), InputError);
        EXPECT_THROW(simulation.add_listener([](auto) {}), InputError);
        EXPECT_THROW(simulation.add_stage(std::make_shared<Standing>()), InputError);
        Archive again(archive.bytes(), "what was written before the step");
        EXPECT_THROW(simulation.archive(again), InputError);
        ++refused;
    };
    simulation.add_listener([&](std::span<const Edit> /*edits*/) { try_all(); });
    const Velocity<double> asks = [&](auto positions, double time, auto velocities) {
        try_all();
        test::swirl(positions, time, velocities);
    };
    (void)simulation.step(asks, 0, 0.02);
    EXPECT_GE(refused, 2);
    EXPECT_NO_THROW(simulation.set_options(options)) << "between two steps";
    EXPECT_THROW((void)simulation.step(asks, 0, -1), InputError);
    EXPECT_NO_THROW(simulation.set_options(options)) << "after one that was refused";
}

} // namespace
} // namespace dsc::failed_steps_test
