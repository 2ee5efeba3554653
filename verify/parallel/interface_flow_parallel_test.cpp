// SPDX-License-Identifier: MIT
// Flows that see the interface, in submeshes and in copies: the whole interface is visible from
// each of them, whichever thread runs it; the same bits for any number of threads.
#include "support/interface_view_testing.h"
#include "support/random/scene.h"
#include "support/submesh_executor_testing.h"

#include "dsc/queries/validate.h"
#include "scenes/integrator_choice.h"
#include "thesis/copy_executor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>

namespace dsc::interface_flow_parallel_test {
namespace {

using scenes::IntegratorChoice;

constexpr double h = 0.02;
const int course = test::steps_or_fewer(12); // in steps

// Grows, is smoothed, and turns: the motion of a vertex depends on its neighbours. The smoothing is
// weak enough for these steps to be stable.
const InterfaceFlow<double> mixed =
    vertex_flow<double>([](const auto& view, std::size_t i, double time) -> Point<double> {
        const Point<double> p = view.positions[i] - Point<double>(0.5, 0.5);
        const double speed = 0.3 * std::cos(3 * time) - 0.0002 * curvature(view, i);
        return speed * normal(view, i) + Point<double>(-p.y(), p.x());
    });

using MakeExecutor = std::function<std::unique_ptr<Executor<double>>(
    Complex<double>&, const Options<double>&, std::uint32_t threads)>;
struct Strategy {
    std::string name;
    MakeExecutor make;
};

std::vector<Strategy> strategies() {
    std::vector<Strategy> list;
    for (const test::NamedPartitioner& way : test::ways_to_divide(4)) {
        list.push_back({way.name, [way](auto& complex, const auto& options, auto threads) {
                            return std::make_unique<SubmeshExecutor<double>>(
                                complex, options, default_algorithm<double>(), way.make(),
                                SubmeshOptions{.threads = threads, .vertices_per_thread = 1});
                        }});
    }
    list.push_back({"copies", [](auto& complex, const auto& options, auto threads) {
                        return std::make_unique<CopyExecutor<double>>(
                            complex, options, default_algorithm<double>(),
                            CopyOptions{.submeshes = 4, .threads = threads});
                    }});
    return list;
}

// Two discs of different phases, one with a hole.
Complex<double> two_discs() {
    const std::vector<Shape> shapes{{test::circle_points({0.25, 0.5}, 0.16, 60), 1},
                                    {test::circle_points({0.25, 0.5}, 0.1, 40), exterior_phase},
                                    {test::circle_points({0.75, 0.5}, 0.16, 60), 2}};
    return initial_complex<double>({}, shapes, {.edge_length = h});
}

struct Outcome {
    std::vector<std::uint64_t> hashes; ///< after each step
    std::uint64_t unreached = 0;
    double area = 0;
};

template <class AnyFlow>
Outcome run(const MakeExecutor& make, const AnyFlow& flow, const Options<double>& options,
            std::uint32_t threads, int steps) {
    Complex<double> complex = two_discs();
    Outcome result;
    {
        Simulation<double> simulation(complex, options, make(complex, options, threads));
        for (int step = 0; step < steps; ++step) {
            result.unreached += simulation.step(flow, 0.02 * step, 0.02).unreached;
            result.hashes.push_back(mesh_hash(complex));
        }
        EXPECT_EQ(test::interface_fault(complex, simulation.interface()), "");
    }
    EXPECT_EQ(validate(complex).problem, "");
    result.area = phase_area(complex, 1);
    return result;
}

const MakeExecutor sequential = [](auto& complex, const auto& options, std::uint32_t) {
    return std::make_unique<Executor<double>>(complex, options, default_algorithm<double>());
};

TEST(InterfaceFlowParallel, TheSameBitsForAnyNumberOfThreads) {
    for (const IntegratorChoice integrator :
         {IntegratorChoice::rk4, IntegratorChoice::adaptive, IntegratorChoice::centred}) {
        Options<double> options;
        options.edge_length = h;
        scenes::choose_integrator(options, integrator);
        const Outcome alone = run(sequential, mixed, options, 1, course);
        EXPECT_EQ(alone.unreached, 0U);
        for (const Strategy& strategy : strategies()) {
            SCOPED_TRACE(strategy.name + ", " + std::string(to_string(integrator)));
            const Outcome one = run(strategy.make, mixed, options, 1, course);
            EXPECT_EQ(one.unreached, 0U);
            EXPECT_NEAR(one.area, alone.area, 2e-4 * alone.area);
            EXPECT_EQ(run(strategy.make, mixed, options, 2, course).hashes, one.hashes);
            EXPECT_EQ(run(strategy.make, mixed, options, 3, course).hashes, one.hashes);
        }
    }
}

// Vertices that change their submesh, or are new to one, end up where a velocity would take them.
TEST(InterfaceFlowParallel, AFlowOfPositionsMovesTheSameBitsEitherWay) {
    const Velocity<double> turn = [](std::span<const Point<double>> positions, double time,
                                     std::span<Point<double>> velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const Point<double> p = positions[i] - Point<double>(0.5, 0.5);
            velocities[i] = (1 + time) * Point<double>(-p.y(), p.x()) + 0.2 * p;
        }
    };
    const InterfaceFlow<double> the_same = [&](const auto& view, std::size_t begin, std::size_t end,
                                               double time, auto velocities) {
        turn(view.positions.subspan(begin, end - begin), time,
             velocities.subspan(begin, end - begin));
    };
    for (const IntegratorChoice integrator :
         {IntegratorChoice::euler, IntegratorChoice::rk4, IntegratorChoice::adaptive,
          IntegratorChoice::centred}) {
        Options<double> options;
        options.edge_length = h;
        scenes::choose_integrator(options, integrator);
        for (const Strategy& strategy : strategies()) {
            SCOPED_TRACE(strategy.name + ", " + std::string(to_string(integrator)));
            EXPECT_EQ(run(strategy.make, the_same, options, 2, course).hashes,
                      run(strategy.make, turn, options, 2, course).hashes);
        }
    }
}

// For any phases: junctions, holes, the domain boundary.
TEST(InterfaceFlowParallel, EverySubmeshSeesTheWholeInterface) {
    for (std::uint64_t seed = 1; seed <= test::seeds_or_fewer(6); ++seed) {
        for (const Strategy& strategy : strategies()) {
            for (const auto coarsening : {Coarsening::deviation, Coarsening::length}) {
                SCOPED_TRACE(strategy.name + ", seed " + std::to_string(seed));
                test::Dice dice(seed);
                Complex<double> complex = seed % 2 == 0
                                              ? test::random_shapes<double>(dice, 0.04)
                                              : test::random_patches<double>(dice, 0.05, 6);
                const auto velocity =
                    test::RandomFlow(dice, 0.4, test::Wildness::none).velocity<double>();
                Options<double> options;
                options.edge_length = 0.04;
                options.interface.coarsening = coarsening;
                Simulation<double> simulation(complex, options, strategy.make(complex, options, 2));
                std::atomic<int> looks = 0;
                const InterfaceFlow<double> flow = [&](const auto& view, std::size_t begin,
                                                       std::size_t end, double time,
                                                       auto velocities) {
                    if (begin == 0) {
                        EXPECT_EQ(test::view_fault(view), "");
                        ++looks;
                    }
                    velocity(view.positions.subspan(begin, end - begin), time,
                             velocities.subspan(begin, end - begin));
                };
                for (int step = 0; step < 8; ++step) {
                    (void)simulation.step(flow, 0.03 * step, 0.03);
                    ASSERT_EQ(validate(complex).problem, "");
                    ASSERT_EQ(test::interface_fault(complex, simulation.interface()), "");
                }
                EXPECT_GE(looks, 8);
            }
        }
    }
}

TEST(InterfaceFlowParallel, BothKindsOfFlowTakeTurns) {
    const Velocity<double> aside = test::everywhere(0.5, 0);
    for (const Strategy& strategy : strategies()) {
        SCOPED_TRACE(strategy.name);
        Complex<double> complex = two_discs();
        Options<double> options;
        options.edge_length = h;
        Simulation<double> simulation(complex, options, strategy.make(complex, options, 2));
        for (int step = 0; step < 6; ++step) {
            EXPECT_EQ(simulation.step(mixed, 0.02 * step, 0.02).unreached, 0U);
            EXPECT_EQ(simulation.step(aside, 0.02 * step, 0.01).unreached, 0U);
            EXPECT_EQ(test::interface_fault(complex, simulation.interface()), "");
        }
        EXPECT_EQ(validate(complex).problem, "");
    }
}

TEST(InterfaceFlowParallel, WhatAFlowThrowsComesOut) {
    for (const Strategy& strategy : strategies()) {
        for (const int good_steps : {0, 3}) {
            SCOPED_TRACE(strategy.name + ", after " + std::to_string(good_steps));
            Complex<double> complex = two_discs();
            Options<double> options;
            options.edge_length = h;
            Simulation<double> simulation(complex, options, strategy.make(complex, options, 2));
            for (int step = 0; step < good_steps; ++step) {
                (void)simulation.step(mixed, 0, 0.02);
            }
            const InterfaceFlow<double> faulty = [](const auto& view, std::size_t begin,
                                                    std::size_t end, double time, auto velocities) {
                mixed(view, begin, end, time, velocities);
                for (std::size_t i = begin; i < end; ++i) {
                    if (view.left[i] == 2) {
                        throw std::runtime_error("no velocity here");
                    }
                }
            };
            EXPECT_THROW((void)simulation.step(faulty, 0, 0.02), std::runtime_error);
            EXPECT_EQ(validate(complex).problem, "");
            for (int step = 0; step < 4; ++step) {
                EXPECT_EQ(simulation.step(mixed, 0, 0.02).unreached, 0U);
                EXPECT_EQ(validate(complex).problem, "");
                EXPECT_EQ(test::interface_fault(complex, simulation.interface()), "");
            }
        }
    }
}

TEST(InterfaceFlowParallel, AVelocityThatIsNotFiniteHoldsItsVertex) {
    const InterfaceFlow<double> flow =
        vertex_flow<double>([](const auto& view, std::size_t i, double time) -> Point<double> {
            const bool is_lost = view.positions[i].y() > 0.6;
            return is_lost ? Point<double>(std::nan(""), time) : Point<double>(normal(view, i));
        });
    for (const Strategy& strategy : strategies()) {
        SCOPED_TRACE(strategy.name);
        Complex<double> complex = two_discs();
        Options<double> options;
        options.edge_length = h;
        Simulation<double> simulation(complex, options, strategy.make(complex, options, 2));
        std::uint64_t expected = 0;
        for (const std::uint32_t v : simulation.interface()) {
            expected += complex.position(Vertex{v}).y() > 0.6 ? 1U : 0U;
        }
        const StepReport report = simulation.step(flow, 0, 0.2 * h);
        EXPECT_EQ(report.held, expected);
        EXPECT_EQ(report.unreached, expected);
        EXPECT_GT(report.operations.moves, 0U);
        EXPECT_EQ(validate(complex).problem, "");
    }
}

} // namespace
} // namespace dsc::interface_flow_parallel_test
