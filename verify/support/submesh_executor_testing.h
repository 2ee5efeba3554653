// SPDX-License-Identifier: MIT
// Common parts of the tests of the executor of submeshes: a growing disc, and divisions of it.
#pragma once

#include "support/random/scene.h"
#include "support/random/submeshes.h"
#include "support/simulation_testing.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/parallel/in_place/submesh_executor.h"
#include "dsc/passes/algorithm.h"
#include "dsc/queries/validate.h"
#include "thesis/divisions/blocks.h"
#include "thesis/divisions/slabs.h"
#include "thesis/divisions/voronoi.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace dsc::test {

// A growing disc in submeshes of a partitioner; `seen` receives the partition. `prepare` is called
// before the executor is made.
struct Growing {
    static constexpr double h = 0.02;

    explicit Growing(std::unique_ptr<Partitioner<double>> partitioner, std::uint32_t threads,
                     Algorithm<double> algorithm = default_algorithm<double>(),
                     const std::function<void(Complex<double>&)>& prepare = {})
        : complex(disc_complex<double>(h)) {
        options.edge_length = h;
        if (prepare) {
            prepare(complex);
        }
        auto made = std::make_unique<SubmeshExecutor<double>>(
            complex, options, std::move(algorithm), std::move(partitioner),
            Parallel{.threads = threads, .always_all_threads = true});
        seen = made.get();
        simulation = std::make_unique<Simulation<double>>(complex, options, std::move(made));
    }

    void expect_good() { expect_sound(complex, *simulation); }
    // Vertices that were moving when a step failed must not arrive in a later step.
    void expect_to_go_on() {
        expect_good();
        EXPECT_EQ(simulation->step(constant<double>(0, 0), 0, 1).operations.moves, 0U);
        for (int step = 0; step < steps_or_fewer(6); ++step) {
            EXPECT_EQ(simulation->step(grow, 0, h).unreached, 0U);
            expect_good();
        }
    }

    Velocity<double> grow = pointwise([](const Point<double>& p) {
        return Point<double>((p - Point<double>(0.5, 0.5)).normalized());
    });
    Complex<double> complex;
    Options<double> options;
    const SubmeshExecutor<double>* seen = nullptr;
    std::unique_ptr<Simulation<double>> simulation;
};

struct NamedPartitioner {
    const char* name;
    std::function<std::unique_ptr<Partitioner<double>>()> make;
};

// Partitioners that divide into small submeshes.
inline std::vector<NamedPartitioner> ways_to_divide(std::uint32_t recut) {
    return {
        {"slabs",
         [=] {
             return std::make_unique<SlabPartitioner<double>>(
                 SlabOptions{.slabbing = Slabbing::active,
                             .submeshes = 4,
                             .degrees = 20,
                             .min_width = 3,
                             .recut = recut});
         }},
        {"blocks",
         [=] {
             return std::make_unique<BlockPartitioner<double>>(
                 BlockOptions{.submeshes = 9, .min_width = 4, .recut = recut});
         }},
        {"cells",
         [=] {
             return std::make_unique<CellPartitioner<double>>(
                 CellOptions{.submeshes = 4, .min_vertices = 8, .recut = recut, .recut_later = 1});
         }},
        {"Voronoi regions",
         [=] {
             return std::make_unique<PlacePartitioner<double>>(
                 [](const PartitionInput<double>& input) { return voronoi_colours(input, 5); },
                 recut);
         }},
    };
}

} // namespace dsc::test
