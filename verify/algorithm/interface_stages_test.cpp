// SPDX-License-Identifier: MIT
// What a flow that sees the interface is shown in the stages of an integrator, and what becomes of
// vertices that stay, velocities that are not finite, and errors.
#include "support/interface_view_testing.h"
#include "support/simulation_testing.h"

#include "dsc/parallel/parallel.h"

#include "replay/mesh_hash.h"
#include "scenes/integrator_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <thread>

namespace dsc::interface_stages_test {
namespace {

using test::coarse;
using test::expect_sound;
using test::options_for;

constexpr double stiffness = 60;
constexpr int corners = 60;
constexpr int waves = 6;
constexpr double radius = 0.3;
constexpr double amplitude = 0.02;

// Each vertex is drawn to the middle of its neighbours: linear in the positions of all, so that an
// order above one needs the neighbours at the stage.
const InterfaceFlow<double> springs =
    vertex_flow<double>([](const auto& view, std::size_t i, double) -> Point<double> {
        return stiffness * (view.positions[view.previous[i]] + view.positions[view.next[i]] -
                            2 * view.positions[i]);
    });

// Where these springs bring a corner of a regular polygon, on which waves of a second kind stand:
// both decay by themselves.
Point<double> drawn_by_springs(int corner, double time) {
    const double angle = 2 * std::numbers::pi * corner / corners;
    const auto decay = [&](int number) {
        const double rate = 2 * stiffness * (std::cos(2 * std::numbers::pi * number / corners) - 1);
        return std::exp(rate * time);
    };
    return Point<double>(0.5, 0.5) +
           radius * decay(1) * Point<double>(std::cos(angle), std::sin(angle)) +
           amplitude * decay(waves) * Point<double>(std::sin(waves * angle), 0);
}

// The polygon above, and options by which no vertex of it is inserted or removed.
struct Wobbly {
    explicit Wobbly(Integrator integrator) : options(options_for<double>(coarse)) {
        std::vector<Point<double>> points;
        for (int i = 0; i < corners; ++i) {
            points.push_back(drawn_by_springs(i, 0));
        }
        complex =
            initial_complex<double>({}, std::vector<Shape>{{points, 1}}, {.edge_length = coarse});
        options.integrator = integrator;
        options.interface.coarsening = Coarsening::never;
        options.interface.longest = 3;
        options.interface.grading = 0;
        simulation = std::make_unique<Simulation<double>>(complex, options);
        list = simulation->interface();
    }
    [[nodiscard]] std::vector<Point<double>> positions() const {
        std::vector<Point<double>> result;
        for (const std::uint32_t v : list) {
            result.push_back(complex.position(Vertex{v}));
        }
        return result;
    }

    Complex<double> complex;
    Options<double> options;
    std::unique_ptr<Simulation<double>> simulation;
    std::vector<std::uint32_t> list;
};

double error_after(Integrator integrator, int steps) {
    constexpr double duration = 0.1;
    Wobbly wobbly(integrator);
    const auto first = wobbly.positions();
    for (int step = 0; step < steps; ++step) {
        const StepReport report = wobbly.simulation->step(springs, 0, duration / steps);
        EXPECT_EQ(report.unreached, 0U);
        EXPECT_EQ(report.sub_steps, 1U);
    }
    EXPECT_EQ(wobbly.simulation->interface(), wobbly.list);
    const auto last = wobbly.positions();
    double worst = 0;
    for (int corner = 0; corner < corners; ++corner) {
        const auto at = std::ranges::find(first, drawn_by_springs(corner, 0)) - first.begin();
        const Point<double>& end = last.at(static_cast<std::size_t>(at));
        worst = std::max(worst, (end - drawn_by_springs(corner, duration)).norm());
    }
    return worst;
}

struct Order {
    Integrator integrator;
    int steps;
    double order;
};
class InterfaceOrders : public testing::TestWithParam<Order> {};

TEST_P(InterfaceOrders, NeighboursAreAtTheStage) {
    const auto [integrator, steps, order] = GetParam();
    const double coarser = error_after(integrator, steps);
    const double finer = error_after(integrator, 2 * steps);
    EXPECT_GT(coarser, 1e-11);
    EXPECT_NEAR(std::log2(coarser / finer), order, 0.2) << coarser << ", " << finer;
}

INSTANTIATE_TEST_SUITE_P(Integrator, InterfaceOrders,
                         testing::Values(Order{Integrator::euler, 40, 1},
                                         Order{Integrator::midpoint, 40, 2},
                                         Order{Integrator::rk4, 20, 4}),
                         [](const auto& one) {
                             return std::string(to_string(one.param.integrator));
                         });

// Four calls a sub-step where there are four stages, whatever the number of submeshes.
TEST(InterfaceStages, AVelocityForAllAtOnceMovesTheSameBitsInOneCallAStage) {
    const Velocity<double> turn = test::pointwise<double>([](const Point<double>& p, double time) {
        return Point<double>(std::sin(3 * p.y()) + time, std::cos(4 * p.x()));
    });
    const auto caller = std::this_thread::get_id();
    int calls = 0;
    const VelocityAtOnce<double> at_once{
        [&](std::span<const Point<double>> positions, double time, auto velocities) {
            EXPECT_EQ(std::this_thread::get_id(), caller);
            ++calls;
            turn(positions, time, velocities);
        }};
    constexpr Parallel in_four{.threads = 2, .submeshes = 4, .always_all_threads = true};
    for (const auto& [integrator, name] : scenes::integrator_choice_names) {
        for (const bool is_advected : {false, true}) {
            auto one = test::disc_complex<double>(coarse);
            auto other = test::disc_complex<double>(coarse);
            auto options = options_for<double>(coarse);
            scenes::choose_integrator(options, integrator);
            options.advected_phases.assign(is_advected ? 1 : 0, Phase{1});
            Simulation<double> in_parts(one, options, in_four);
            Simulation<double> together(other, options, in_four);
            for (int step = 0; step < 8; ++step) {
                calls = 0;
                const auto first = in_parts.step(turn, 0.02 * step, 0.02);
                const auto second = together.step(at_once, 0.02 * step, 0.02);
                EXPECT_EQ(first.sub_steps, second.sub_steps);
                EXPECT_EQ(first.error, second.error);
                if (integrator == scenes::IntegratorChoice::rk4 && first.sub_steps == 1) {
                    EXPECT_LE(calls, 2 * 4 + 1); // twice where dt had to be shorter
                }
                ASSERT_EQ(mesh_hash(one), mesh_hash(other)) << name;
            }
        }
    }
}

TEST(InterfaceStages, WhoStaysIsSeenWhereItStays) {
    Wobbly wobbly(Integrator::rk4);
    const Vertex locked{wobbly.list[5]};
    const Vertex lost{wobbly.list[20]};
    wobbly.complex.set_locked(locked, true);
    const auto first = wobbly.positions();
    int calls = 0;
    const InterfaceFlow<double> flow = [&](const auto& view, std::size_t begin, std::size_t end,
                                           double, auto velocities) {
        ++calls;
        EXPECT_EQ(test::view_fault(view), "");
        for (std::size_t i = begin; i < end; ++i) {
            EXPECT_TRUE(view.positions[i].allFinite());
            velocities[i] = Point<double>(0.01, 0);
            if (view.vertices[i] == locked || view.vertices[i] == lost) {
                EXPECT_EQ(view.positions[i], view.complex.position(view.vertices[i]));
            } else {
                EXPECT_EQ(calls > 1,
                          view.positions[i].x() > view.complex.position(view.vertices[i]).x());
            }
            if (view.vertices[i] == lost) {
                velocities[i].x() = std::numeric_limits<double>::quiet_NaN();
            }
            // The speed of a locked vertex must not cause sub-steps.
            if (view.vertices[i] == locked) {
                velocities[i].x() = 100;
            }
        }
    };
    const StepReport report = wobbly.simulation->step(flow, 0, 1);
    EXPECT_EQ(calls, 4);
    EXPECT_EQ(report.sub_steps, 1U);
    EXPECT_EQ(report.held, 1U);
    EXPECT_EQ(report.unreached, 1U);
    const auto last = wobbly.positions();
    for (std::size_t i = 0; i < last.size(); ++i) {
        const double way = i == 5 || i == 20 ? 0 : 0.01;
        EXPECT_LT((last[i] - first[i] - Point<double>(way, 0)).norm(), 1e-15) << i;
    }
}

// A failure for one vertex in an inner stage affects only that vertex.
TEST(InterfaceStages, AVelocityThatIsLostOnTheWayHoldsItsVertexOnly) {
    for (const Integrator integrator :
         {Integrator::midpoint, Integrator::rk4, Integrator::adaptive}) {
        Wobbly wobbly(integrator);
        const Vertex lost{wobbly.list[20]};
        int calls = 0;
        const InterfaceFlow<double> flow = [&](const auto& view, std::size_t begin, std::size_t end,
                                               double time, auto velocities) {
            springs(view, begin, end, time, velocities);
            ++calls;
            for (std::size_t i = begin; i < end; ++i) {
                EXPECT_TRUE(velocities[i].allFinite());
                if (calls == 2 && view.vertices[i] == lost) {
                    velocities[i].setConstant(std::numeric_limits<double>::infinity());
                }
            }
        };
        const StepReport report = wobbly.simulation->step(flow, 0, 2e-4);
        EXPECT_EQ(report.held, 1U) << to_string(integrator);
        EXPECT_EQ(report.unreached, 1U);
        EXPECT_EQ(report.sub_steps, 1U);
        expect_sound(wobbly.complex, *wobbly.simulation);
    }
}

// A velocity of places is not asked for one that no number describes.
TEST(InterfaceStages, AVertexThatIsHeldStaysWhereItIsInInnerStages) {
    Wobbly wobbly(Integrator::rk4);
    int calls = 0;
    const Velocity<double> velocity = [&](std::span<const Point<double>> positions, double,
                                          std::span<Point<double>> velocities) {
        ++calls;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            EXPECT_TRUE(positions[i].allFinite()) << "call " << calls;
            velocities[i] = Point<double>(0.01, 0);
        }
        if (calls == 1) {
            velocities[20].x() = std::numeric_limits<double>::quiet_NaN();
        }
    };
    EXPECT_EQ(wobbly.simulation->step(velocity, 0, 0.1).held, 1U);
    EXPECT_EQ(calls, 4);
}

TEST(InterfaceStages, WithoutAnInterfaceNothingIsAsked) {
    auto complex = initial_complex<double>({}, {}, {.edge_length = 0.2});
    const auto options = options_for<double>(0.2);
    Simulation<double> simulation(complex, options);
    const InterfaceFlow<double> flow = [](const auto&, std::size_t, std::size_t, double, auto) {
        ADD_FAILURE() << "called";
    };
    EXPECT_EQ(simulation.step(flow, 0, 1).sub_steps, 1U);
}

} // namespace
} // namespace dsc::interface_stages_test
