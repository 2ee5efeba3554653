// SPDX-License-Identifier: MIT
// Every scene by several ranks, to the bit as by one: the mesh, the counts and the events. The
// ranks compare all that they hold after each sub-step.
//
//   DSC_RANKS=long   more steps, every number of ranks and of threads, every division
#include "scenes/catalogue/catalogue.h"
#include "scenes/run/run.h"
#include "support/thread_ranks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace dsc::scenes::ranks_scenes_test {
namespace {

bool is_long() {
    const char* asked = std::getenv("DSC_RANKS");
    return asked != nullptr && std::string(asked) == "long";
}

// The first steps of a coarse run.
Parameters shortened(const Scene& scene) {
    Parameters parameters = scene.defaults;
    const int steps = is_long() ? 24 : 4;
    parameters.dt = scene.prepare(parameters).dt;
    parameters.steps = scene.counts_steps_each_way ? steps / 2 : steps;
    return parameters;
}

RunOptions options_for(Strategy strategy, std::uint32_t threads, Ranks* ranks) {
    RunOptions options;
    options.strategy = strategy;
    options.submeshing.threads = threads;
    options.submeshing.submeshes = strategy == Strategy::cells ? 6 : 0; // coarse runs have few
    options.submeshing.always_all_threads = threads > 1;
    options.submeshing.ranks = ranks;
    options.submeshing.checks_ranks = true;
    options.measure_shape = false;
    options.measures.clear();
    return options;
}

void expect_same(const RunResult& one, const RunResult& other, const std::string& what) {
    EXPECT_EQ(one.mesh_hash, other.mesh_hash) << what;
    EXPECT_EQ(one.operations, other.operations) << what;
    EXPECT_EQ(one.unreached, other.unreached) << what;
    EXPECT_EQ(one.sub_steps, other.sub_steps) << what;
    ASSERT_EQ(one.events.size(), other.events.size()) << what;
    for (std::size_t i = 0; i < one.events.size(); ++i) {
        EXPECT_EQ(one.events[i].kind, other.events[i].kind) << what;
        EXPECT_EQ(one.events[i].time, other.events[i].time) << what;
        EXPECT_EQ(one.events[i].area, other.events[i].area) << what;
    }
}

void expect_same_by_ranks(const Scene& scene, const Parameters& parameters, Strategy strategy,
                          std::uint32_t size, std::uint32_t threads, const RunResult& alone) {
    std::vector<RunResult> results(size);
    run_all_ranks(size, [&](Ranks& ranks) {
        results[ranks.rank()] =
            run_scene(scene, parameters, options_for(strategy, threads, &ranks));
    });
    const std::string what = scene.name + ", " + to_string(strategy) + ", " + std::to_string(size) +
                             " ranks, " + std::to_string(threads) + " threads";
    for (const RunResult& result : results) {
        expect_same(result, alone, what);
    }
}

class RanksScenes : public testing::TestWithParam<std::string> {};

TEST_P(RanksScenes, EndWithTheSameBits) {
    const Scene& scene = find_scene(GetParam());
    const Parameters parameters = shortened(scene);
    for (const Strategy strategy : {Strategy::cells, Strategy::active, Strategy::blocks}) {
        // One of the other two, by the length of the name.
        if (!is_long() && strategy != Strategy::cells &&
            (strategy == Strategy::active) != (scene.name.size() % 2 == 0)) {
            continue;
        }
        const RunResult alone = run_scene(scene, parameters, options_for(strategy, 1, nullptr));
        if (!is_long()) {
            const std::uint32_t size = strategy == Strategy::cells ? 2 : 3;
            expect_same_by_ranks(scene, parameters, strategy, size, 1, alone);
            continue;
        }
        for (const std::uint32_t size : {1U, 2U, 3U, 4U, 8U}) {
            for (const std::uint32_t threads : {1U, 2U}) {
                expect_same_by_ranks(scene, parameters, strategy, size, threads, alone);
            }
        }
    }
}

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (const Scene& scene : catalogue()) {
        names.push_back(scene.name);
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(Scenes, RanksScenes, testing::ValuesIn(scene_names()),
                         [](const auto& one) {
                             std::string name = one.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

} // namespace
} // namespace dsc::scenes::ranks_scenes_test
