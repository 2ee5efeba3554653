// SPDX-License-Identifier: MIT
// METIS as a partition that the application supplies: a whole run, the same for any number of
// threads, in submeshes whose boundaries are not straight.
#include "scenes/metis_partition.h"

#include "scenes/catalogue/catalogue.h"
#include "scenes/run/run.h"
#include "scenes/run/start.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/parallel/in_place/submesh_executor.h"
#include "dsc/passes/interface/list.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace dsc::metis_test {
namespace {

struct Outcome {
    std::uint64_t hash = 0;
    std::uint64_t unreached = 0;
    std::size_t submeshes = 0;
};

Outcome run(std::uint32_t threads) {
    const auto& scene = scenes::find_scene("swirl");
    auto parameters = scene.defaults;
    parameters.h = 0.01;
    const auto setup = scene.prepare(parameters);
    auto complex = scenes::first_complex<double>(setup, parameters);
    const auto options = scenes::scene_options<double>(parameters);
    SubmeshOptions submeshes;
    submeshes.threads = threads;
    submeshes.vertices_per_thread = 1;
    submeshes.profile = true;
    auto executor = std::make_unique<SubmeshExecutor<double>>(
        complex, options, default_algorithm<double>(),
        std::make_unique<PlacePartitioner<double>>(
            [](const PartitionInput<double>& input) { return scenes::metis_colours(input, 4); },
            16),
        submeshes);
    const auto& parallel = *executor;
    Simulation<double> simulation(complex, options, std::move(executor));
    Outcome outcome;
    for (int step = 0; step < 120; ++step) {
        const double begin = step * setup.dt;
        const auto report = simulation.step(setup.flow.front().velocity, begin, setup.dt);
        outcome.unreached += report.unreached;
        outcome.submeshes =
            std::max(outcome.submeshes, parallel.view().partition.colours.front().regions.size());
    }
    EXPECT_EQ(validate(complex).problem, "");
    outcome.hash = mesh_hash(complex);
    return outcome;
}

TEST(Metis, DividesASwirlTheSameForAnyNumberOfThreads) {
    const Outcome one = run(1);
    EXPECT_EQ(one.unreached, 0U);
    EXPECT_EQ(one.submeshes, 4U);
    for (const std::uint32_t threads : {2U, 3U}) {
        EXPECT_EQ(run(threads).hash, one.hash) << threads << " threads";
    }
}

TEST(Metis, SharesTheInterface) {
    const auto& scene = scenes::find_scene("swirl");
    auto parameters = scene.defaults;
    parameters.h = 0.005;
    const auto setup = scene.prepare(parameters);
    const auto complex = scenes::first_complex<double>(setup, parameters);
    const auto interface = collect_interface(complex);
    const std::vector<float> work(interface.size(), 1.0F);
    const auto colours = scenes::metis_colours<double>({complex, interface, work, 0.005}, 4);
    ASSERT_EQ(colours.size(), 2U);
    for (const PlaceColour& colour : colours) {
        std::vector<std::size_t> held(colour.submeshes, 0);
        for (const std::uint32_t v : interface) {
            const auto p = complex.position(Vertex{v});
            const std::uint32_t label = colour.number_of(p.x(), p.y());
            ASSERT_LT(label, colour.submeshes);
            ++held[label];
        }
        for (const std::size_t count : held) {
            EXPECT_GT(count, interface.size() / 10);
        }
        // Places far away belong to a submesh as well.
        EXPECT_LT(colour.number_of(1e9, -1e9), colour.submeshes);
    }
}

} // namespace
} // namespace dsc::metis_test
