// SPDX-License-Identifier: MIT
// What a flow that sees the interface is shown in the stages of an integrator, and what becomes of
// vertices that stay, velocities that are not finite, and errors.
#include "support/interface_view_testing.h"
#include "support/simulation_testing.h"

#include "replay/mesh_hash.h"
#include "scenes/integrator_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>

namespace dsc::interface_stages_test {
namespace {

using test::coarse;
using test::expect_sound;
using test::options_for;

constexpr double stiffness = 20;

// Each vertex is drawn to the middle of its neighbours: linear in the positions of all, so that an
// order above one needs the neighbours at the stage.
const InterfaceFlow<double> springs =
    vertex_flow<double>([](const auto& view, std::size_t i, double) -> Point<double> {
        return stiffness * (view.positions[view.previous[i]] + view.positions[view.next[i]] -
                            2 * view.positions[i]);
    });

// A closed curve with three arms, and options by which none of its vertices comes or goes.
struct Wobbly {
    explicit Wobbly(Integrator integrator) : options(options_for<double>(coarse)) {
        std::vector<Point<double>> points = test::circle_points({0, 0}, 1, 40);
        for (auto& p : points) {
            const double radius = 0.3 + 0.05 * std::sin(3 * std::atan2(p.y(), p.x()));
            p = Point<double>(0.5, 0.5) + radius * p;
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
    void run(const InterfaceFlow<double>& flow, double duration, int steps) {
        for (int step = 0; step < steps; ++step) {
            const StepReport report = simulation->step(flow, 0, duration / steps);
            EXPECT_EQ(report.unreached, 0U);
            EXPECT_EQ(report.sub_steps, 1U);
        }
        EXPECT_EQ(simulation->interface(), list);
    }

    Complex<double> complex;
    Options<double> options;
    std::unique_ptr<Simulation<double>> simulation;
    std::vector<std::uint32_t> list;
};

// The springs of a polygon without a mesh, in steps so small that their error does not count.
std::vector<Point<double>> integrated(std::vector<Point<double>> at,
                                      const std::vector<std::size_t>& before,
                                      const std::vector<std::size_t>& after, double duration) {
    constexpr int steps = 500; // with rk4, ten times those of the finest run
    const double dt = duration / steps;
    const auto slope = [&](const std::vector<Point<double>>& x) {
        std::vector<Point<double>> v(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            v[i] = stiffness * (x[before[i]] + x[after[i]] - 2 * x[i]);
        }
        return v;
    };
    const auto moved = [&](const std::vector<Point<double>>& v, double share) {
        std::vector<Point<double>> x = at;
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += share * dt * v[i];
        }
        return x;
    };
    for (int step = 0; step < steps; ++step) {
        const auto k1 = slope(at);
        const auto k2 = slope(moved(k1, 0.5));
        const auto k3 = slope(moved(k2, 0.5));
        const auto k4 = slope(moved(k3, 1));
        for (std::size_t i = 0; i < at.size(); ++i) {
            at[i] += dt / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
        }
    }
    return at;
}

double error_after(Integrator integrator, int steps) {
    constexpr double duration = 0.2;
    Wobbly wobbly(integrator);
    // Along the curve by nearest neighbours: the list need not be in its order.
    InterfaceGraph<double> graph;
    test::build(graph, wobbly.complex, wobbly.list);
    const auto first = wobbly.positions();
    const auto view = graph.view(wobbly.complex, first);
    const auto exact = integrated(first, {view.previous.begin(), view.previous.end()},
                                  {view.next.begin(), view.next.end()}, duration);
    wobbly.run(springs, duration, steps);
    const auto last = wobbly.positions();
    double worst = 0;
    for (std::size_t i = 0; i < last.size(); ++i) {
        worst = std::max(worst, (last[i] - exact[i]).norm());
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
                         testing::Values(Order{Integrator::euler, 20, 1},
                                         Order{Integrator::midpoint, 20, 2},
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
        for (const bool carries : {false, true}) {
            auto one = test::disc_complex<double>(coarse);
            auto other = test::disc_complex<double>(coarse);
            auto options = options_for<double>(coarse);
            scenes::choose_integrator(options, integrator);
            options.carried_phases.assign(carries ? 1 : 0, Phase{1});
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
            // The speed of one that is locked must not ask for sub-steps.
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

// What fails for one vertex in an inner stage is that vertex's trouble alone.
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
        const StepReport report = wobbly.simulation->step(flow, 0, 1e-3);
        EXPECT_EQ(report.held, 1U) << to_string(integrator);
        EXPECT_EQ(report.unreached, 1U);
        EXPECT_EQ(report.sub_steps, 1U);
        expect_sound(wobbly.complex, *wobbly.simulation);
    }
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
