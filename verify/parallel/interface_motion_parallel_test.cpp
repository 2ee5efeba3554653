// SPDX-License-Identifier: MIT
// Motions of the whole interface in submeshes and in copies: the same bits for any number of
// threads.
#include "support/random/scene.h"
#include "support/submesh_executor_testing.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/parallel/parallel.h"
#include "dsc/queries/validate.h"
#include "geometric_flows/curvature_flow.h"
#include "thesis/copy_executor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <optional>

namespace dsc::interface_motion_parallel_test {
namespace {

constexpr double h = 0.02;

// Two discs of different phases, one with a hole.
Complex<double> two_discs() {
    const std::vector<Shape> shapes{{test::circle_points({0.25, 0.5}, 0.16, 60), 1},
                                    {test::circle_points({0.25, 0.5}, 0.1, 40), exterior_phase},
                                    {test::circle_points({0.75, 0.5}, 0.16, 60), 2}};
    return initial_complex<double>({}, shapes, {.edge_length = h});
}

struct Outcome {
    std::vector<std::uint64_t> hashes; ///< after each step
    double area = 0;                   ///< of the ring
    double kept = 0;                   ///< of the other disc
};

// The ring shrinks on both sides, and the other disc, whose area is kept, is pushed aside.
Outcome run(const std::optional<Parallel>& parallel) {
    Complex<double> complex = two_discs();
    Options<double> options;
    options.edge_length = h;
    const auto curvature =
        curvature_flow<double>({.mobility = 0.05, .kept_areas = {{2, phase_area(complex, 2)}}});
    std::atomic<int> inside = 0;
    const InterfaceMotion<double> motion = [&](const auto& view, double time, double dt,
                                               auto displacements) {
        EXPECT_EQ(++inside, 1); // one call at a time
        curvature(view, time, dt, displacements);
        for (std::size_t i = 0; i < view.size(); ++i) {
            if (borders_on(view, i, 2)) {
                displacements[i] += dt * Point<double>(0.5, 2);
            }
        }
        --inside;
    };
    Outcome result;
    {
        auto simulation = parallel
                              ? std::make_unique<Simulation<double>>(complex, options, *parallel)
                              : std::make_unique<Simulation<double>>(complex, options);
        for (int step = 0; step < 12; ++step) {
            // Now and then the step has to be divided, which the first speed does not tell.
            const double dt = step % 4 == 3 ? 0.01 : 0.002;
            EXPECT_EQ(simulation->step(motion, 0, step == 11 ? 0.001 : dt).unreached, 0U);
            result.hashes.push_back(mesh_hash(complex));
        }
        EXPECT_EQ(test::interface_fault(complex, simulation->interface()), "");
    }
    EXPECT_EQ(validate(complex).problem, "");
    result.area = phase_area(complex, 1);
    result.kept = phase_area(complex, 2);
    return result;
}

TEST(InterfaceMotionParallel, TheSameBitsForAnyNumberOfThreads) {
    const Outcome alone = run({});
    for (const Division division : {Division::cells, Division::counting, copy_division}) {
        SCOPED_TRACE(division->name);
        const auto with = [division](std::uint32_t threads) {
            return run(Parallel{.threads = threads,
                                .division = division,
                                .submeshes = 4,
                                .always_all_threads = true});
        };
        const Outcome one = with(1);
        EXPECT_NEAR(one.area, alone.area, 2e-4 * alone.area);
        EXPECT_NEAR(one.kept, alone.kept, 1e-12);
        EXPECT_EQ(with(2).hashes, one.hashes);
        EXPECT_EQ(with(3).hashes, one.hashes);
    }
}

} // namespace
} // namespace dsc::interface_motion_parallel_test
