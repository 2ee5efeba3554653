// SPDX-License-Identifier: MIT
// Parallel DSC as printed (thesis, algorithm 6.3), in copied submeshes: a step is as good as a
// sequential one, with the same bits for any number of threads; nothing that a boundary holds up is
// lost; an exception in a submesh is passed on and leaves a complex that can continue.
#include "dsc/complex/gather.h"
#include "thesis/centred_difference.h"
#include "thesis/copy_executor.h"

#include "support/copy_testing.h"
#include "support/random/scene.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/quality/measures.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <tuple>

namespace dsc::copy_test {
namespace {

using test::Dice;
using test::everywhere;
using test::in_copies;
using test::RandomFlow;
using test::Wildness;

auto counts_of(const OperationCounts& c) {
    return std::tuple(c.moves, c.flips, c.interface_splits, c.interface_collapses, c.splits,
                      c.collapses, c.smoothed, c.subdivisions, c.retriangulations, c.examined);
}

template <class Real>
std::map<Phase, double> areas_of(const Complex<Real>& complex) {
    std::map<Phase, double> areas;
    for (const Triangle t : triangles(complex)) {
        areas[complex.phase(t)] += static_cast<double>(area(complex, t));
    }
    return areas;
}

struct Outcome {
    std::vector<std::uint64_t> hashes; ///< after each step
    OperationCounts counts;
    std::uint64_t unreached = 0;
    std::vector<std::uint32_t> interface;
    std::map<Phase, double> areas;
    std::uint64_t sub_steps = 0;
    CopyCosts costs;
};

const int steps = test::steps_or_fewer(12);

template <class Real>
Outcome simulate(std::uint64_t seed, const CopyOptions* copy,
                 std::shared_ptr<const CustomIntegrator<Real>> integrator = nullptr) {
    constexpr double h = 0.025;
    Dice dice(seed);
    auto complex = seed % 3 == 0 ? test::random_patches<Real>(dice, h, 12)
                                 : test::random_shapes<Real>(dice, h);
    const RandomFlow flow(dice, 1, seed % 5 == 4 ? Wildness::not_a_number : Wildness::none);
    const Velocity<Real> velocity = flow.velocity<Real>();
    Options<Real> options;
    options.edge_length = static_cast<Real>(h);
    options.custom_integrator = std::move(integrator);
    std::unique_ptr<CopyExecutor<Real>> executor;
    const CopyExecutor<Real>* seen = nullptr;
    if (copy != nullptr) {
        executor = std::make_unique<CopyExecutor<Real>>(complex, options, default_algorithm<Real>(),
                                                        *copy);
        seen = executor.get();
    }
    Simulation<Real> simulation(complex, options, std::move(executor));
    Outcome outcome;
    for (int step = 0; step < steps; ++step) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step));
        const auto report =
            simulation.step(velocity, static_cast<Real>(step) * Real(0.01), Real(0.01));
        outcome.counts += report.operations;
        outcome.unreached += report.unreached;
        outcome.sub_steps += report.sub_steps;
        outcome.hashes.push_back(mesh_hash(complex));
        EXPECT_EQ(test::interface_fault(complex, simulation.interface()), "");
        EXPECT_EQ(validate(complex).problem, "");
    }
    outcome.interface = simulation.interface();
    outcome.areas = areas_of(complex);
    outcome.costs = seen != nullptr ? seen->costs() : CopyCosts{};
    return outcome;
}

TEST(CopyExecutor, GivesTheSameBitsForAnyNumberOfThreads) {
    for (std::uint64_t seed = 1; seed <= test::seeds_or_fewer(6); ++seed) {
        CopyOptions copy{.submeshes = static_cast<std::uint32_t>(2 + 2 * seed)};
        if (seed % 2 == 0) {
            copy.normal_x = 0.6;
            copy.normal_y = 0.8;
        }
        const Outcome one = simulate<double>(seed, &copy);
        EXPECT_EQ(one.costs.rounds, 2 * one.sub_steps) << "black had nothing to do";
        for (const std::uint32_t threads : {2U, 3U, 5U}) {
            copy.threads = threads;
            const Outcome many = simulate<double>(seed, &copy);
            EXPECT_EQ(many.hashes, one.hashes) << "seed " << seed << ", threads " << threads;
            EXPECT_EQ(counts_of(many.counts), counts_of(one.counts)) << "seed " << seed;
            EXPECT_EQ(many.unreached, one.unreached) << "seed " << seed;
            EXPECT_EQ(many.interface, one.interface) << "seed " << seed << ": ids differ";
        }
    }
}

// What the centred difference remembers about a vertex goes with it into a submesh and back,
// whatever its id.
TEST(CopyExecutor, TakesTheMemoryOfVerticesAlong) {
    const CopyOptions one_thread{.submeshes = 4};
    const Outcome one = simulate<double>(2, &one_thread, centred_difference<double>());
    for (const std::uint32_t threads : {2U, 3U}) {
        const CopyOptions copy{.submeshes = 4, .threads = threads};
        EXPECT_EQ(simulate<double>(2, &copy, centred_difference<double>()).hashes, one.hashes);
    }

    auto complex = test::disc_complex<double>(0.05);
    Options<double> options;
    options.edge_length = 0.05;
    options.custom_integrator = centred_difference<double>();
    auto simulation = in_copies(complex, options, {.submeshes = 4, .threads = 2});
    const Point<double> centre(0.5, 0.5);
    const Velocity<double> turn = [&](std::span<const Point<double>> positions, double,
                                      std::span<Point<double>> velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const Point<double> arm = positions[i] - centre;
            velocities[i] = {-arm.y(), arm.x()};
        }
    };
    for (int step = 0; step < 8; ++step) {
        EXPECT_EQ(simulation.step(turn, 0.05 * step, 0.05).unreached, 0U);
        const auto& past = past_of(complex);
        for (const std::uint32_t v : simulation.interface()) {
            const Point<double> arm = complex.position(Vertex{v}) - centre;
            const Point<double> before(std::cos(0.05) * arm.x() + std::sin(0.05) * arm.y(),
                                       std::cos(0.05) * arm.y() - std::sin(0.05) * arm.x());
            EXPECT_EQ(past[Vertex{v}].dt, 0.05);
            EXPECT_LT((past[Vertex{v}].way - (arm - before)).norm(), 2e-5);
        }
    }
}

// A pass that reads it finds that of the submesh, however often these are made anew.
TEST(CopyExecutor, ShowsPassesTheMemoryOfTheSubmesh) {
    auto complex = test::disc_complex<double>(0.05);
    Options<double> options;
    options.edge_length = 0.05;
    options.custom_integrator = centred_difference<double>();
    int seen = 0;
    auto algorithm = default_algorithm<double>();
    algorithm.motion.push_back({"looking", [&](Work<double>& work) {
                                    const auto& past = past_of(work.complex);
                                    for (const std::uint32_t v : work.interface) {
                                        EXPECT_EQ(past[Vertex{v}].dt, 0.05);
                                    }
                                    ++seen;
                                }});
    Simulation<double> simulation(complex, options,
                                  std::make_unique<CopyExecutor<double>>(
                                      complex, options, algorithm, CopyOptions{.submeshes = 4}));
    for (int step = 0; step < 3; ++step) {
        EXPECT_EQ(simulation.step(test::everywhere(0.02, 0), 0.05 * step, 0.05).unreached, 0U);
    }
    EXPECT_GT(seen, 20);
}

TEST(CopyExecutor, IsTheSequentialMethodWhereThereIsOneSubmesh) {
    const CopyOptions copy{.submeshes = 1, .threads = 3};
    const Outcome one = simulate<double>(2, &copy);
    const Outcome sequential = simulate<double>(2, nullptr);
    EXPECT_EQ(one.unreached, sequential.unreached);
    EXPECT_EQ(one.costs.steps, static_cast<std::uint64_t>(steps));
    EXPECT_EQ(one.costs.rounds, one.sub_steps) << "something was put off";
    const auto near = [](std::uint64_t a, std::uint64_t b) {
        EXPECT_NEAR(static_cast<double>(a), static_cast<double>(b), 0.05 * static_cast<double>(b));
    };
    near(one.counts.moves, sequential.counts.moves);
    near(one.counts.examined, sequential.counts.examined);
    near(one.counts.flips, sequential.counts.flips);
    near(one.counts.smoothed, sequential.counts.smoothed);
}

// Every active vertex and every mover comes to one submesh that owns its star, in some round, with
// its own target: none is lost or handled twice, whichever boundaries it lies on.
TEST(CopyExecutor, HandsOnWhatBoundariesKeepFromBeingDone) {
    constexpr double h = 0.03;
    const Point<double> way(0.002, 0.001);
    for (const std::uint32_t n : {1U, 2U, 8U, 40U}) {
        SCOPED_TRACE("submeshes " + std::to_string(n));
        auto complex = test::disc_complex<double>(h);
        Options<double> options;
        options.edge_length = h;
        using Place = std::pair<double, double>;
        std::mutex mutex;
        std::map<Place, int> looked_at;
        std::map<Place, int> moved;
        Algorithm<double> algorithm;
        algorithm.upkeep.push_back({"activate all", [](Work<double>& work) {
                                        for (std::uint32_t v = 0; v < work.complex.vertex_bound();
                                             ++v) {
                                            work.activate(v);
                                        }
                                    }});
        algorithm.motion.push_back(
            {"note", [&](Work<double>& work) {
                 const std::lock_guard lock(mutex);
                 const auto owns_star = [&](std::uint32_t v) {
                     return gather(work.complex, work.submesh.region, v, work.ring) &&
                            work.ring.owned;
                 };
                 const auto place = [&](std::uint32_t v) {
                     return Place(work.complex.vertices[v].x, work.complex.vertices[v].y);
                 };
                 for (const std::uint32_t v : work.active) {
                     if (owns_star(v)) {
                         ++looked_at[place(v)];
                     } else {
                         work.deferred.star(v);
                     }
                 }
                 for (const auto& mover : work.movers) {
                     if (owns_star(mover.vertex)) {
                         ++moved[place(mover.vertex)];
                         const auto p = work.complex.position(Vertex{mover.vertex});
                         EXPECT_LT((p + way - Point<double>(mover.x, mover.y)).norm(), 1e-12);
                     } else {
                         work.deferred.mover(mover);
                     }
                 }
                 work.active.clear();
                 work.movers.clear();
             }});
        CopyExecutor<double> executor(complex, options, algorithm, {.submeshes = n, .threads = 2});
        (void)executor.aim(everywhere(way.x(), way.y()), 0, 1);
        EXPECT_EQ(executor.move().unreached, 0U);
        EXPECT_EQ(looked_at.size(), complex.vertex_count());
        EXPECT_EQ(moved.size(), executor.interface_size());
        for (const auto* done : {&looked_at, &moved}) {
            for (const auto& [place, times] : *done) {
                EXPECT_EQ(times, 1) << "at " << place.first << ", " << place.second;
            }
        }
        EXPECT_EQ(executor.costs().rounds, n > 1 ? 2U : 1U);
    }
}

// Data and locks are kept through steps, references to attributes stay valid, and the list of the
// interface follows the curve as before.
TEST(CopyExecutor, CarriesDataLocksAndOrderThroughSteps) {
    constexpr double h = 0.03;
    auto complex = test::disc_complex<double>(h);
    auto& place = complex.attributes.add<Vertex, double>("place");
    auto& phases = complex.attributes.add<Triangle, Phase>("phase");
    auto& edges = complex.attributes.add<Edge, std::uint8_t>("on the interface");
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        place[Vertex{v}] = 1; // and 1 between them: splits interpolate
    }
    for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
        phases[Triangle{t}] = complex.phase(Triangle{t});
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t, i);
            edges.data()[c] = is_interface(complex, complex.edge(c)) ? 1 : 0;
        }
    }
    const auto distance = [&](std::uint32_t v) {
        return (complex.position(Vertex{v}) - Point<double>(0.75, 0.5)).norm();
    };
    std::uint32_t pinned = 0;
    for (std::uint32_t v = 1; v < complex.vertex_bound(); ++v) {
        pinned = distance(v) < distance(pinned) ? v : pinned;
    }
    complex.set_locked(Vertex{pinned}, true);
    const Point<double> pin = complex.position(Vertex{pinned});
    Options<double> options;
    options.edge_length = h;
    auto simulation = in_copies(complex, options, {.submeshes = 6, .threads = 2});
    OperationCounts counts;
    for (int step = 0; step < 10; ++step) {
        const auto report = simulation.step(everywhere(0.4 * h, 0.3 * h), 0, 1);
        EXPECT_EQ(report.unreached, 0U) << "step " << step;
        counts += report.operations;
    }
    EXPECT_GT(counts.flips + counts.splits + counts.collapses, 100U);
    ASSERT_EQ(validate(complex).problem, "");
    int locked = 0;
    for (const Vertex v : vertices(complex)) {
        ASSERT_EQ(place[v], 1);
        if (complex.is_locked(v)) {
            ++locked;
            EXPECT_EQ(complex.position(v), pin);
        }
    }
    EXPECT_EQ(locked, 1);
    int marked = 0;
    for (const Triangle t : triangles(complex)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            ASSERT_EQ(phases[t], complex.phase(t));
            const Corner c = corner_of(t.id, i);
            const bool expected = is_interface(complex, complex.edge(c));
            ASSERT_EQ(edges.at_corner(c), expected ? 1 : 0) << "corner " << c;
            marked += edges.at_corner(c);
        }
    }
    EXPECT_GT(marked, 50);
    const auto list = simulation.interface();
    int apart = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::uint32_t following = list[(i + 1) % list.size()];
        apart += complex.find_edge(Vertex{list[i]}, Vertex{following}).is_valid() ? 0 : 1;
    }
    EXPECT_LE(apart, 2);
}

// More vertices than the submeshes have ids for: the rest is put off, and done later.
TEST(CopyExecutor, GoesOnWhereIdsRunOut) {
    auto complex = test::disc_complex<double>(0.05);
    Options<double> options;
    options.edge_length = 0.004;
    options.interface.longest = 20; // no vertices there, and so fewer ids for the submeshes
    std::atomic<int> ran_out{0};
    auto algorithm = default_algorithm<double>();
    algorithm.motion.push_back(
        {"look", [&](Work<double>& work) {
             ran_out += work.submesh.pool->vertices.empty() && !work.submesh.pool->may_grow ? 1 : 0;
         }});
    auto simulation = in_copies(complex, options, {.submeshes = 2}, algorithm);
    for (int step = 0; step < 6; ++step) {
        (void)simulation.step(everywhere(0.004, 0.003), 0, 1);
        EXPECT_EQ(validate(complex).problem, "");
        EXPECT_EQ(test::interface_fault(complex, simulation.interface()), "");
    }
    EXPECT_GT(ran_out, 0);
    auto alone = test::disc_complex<double>(0.05);
    Simulation<double> sequential(alone, options);
    for (int step = 0; step < 6; ++step) {
        (void)sequential.step(everywhere(0.004, 0.003), 0, 1);
    }
    EXPECT_NEAR(complex.vertex_count(), alone.vertex_count(), 0.1 * alone.vertex_count());
}

} // namespace
} // namespace dsc::copy_test
