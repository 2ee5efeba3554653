// SPDX-License-Identifier: MIT
// Dividing the mesh makes no work: submeshes split and collapse about as often as the whole mesh
// does. What a boundary keeps from being done for a while looks like a fault of the mesh; vertices
// that are made for it have to go again.
#include "scenes/catalogue/catalogue.h"
#include "scenes/run/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace dsc::scenes::effort_test {
namespace {

constexpr double most_of_sequential = 1.1;

std::uint64_t splits_and_collapses(const std::string& scene, Strategy strategy) {
    RunOptions options;
    options.strategy = strategy;
    options.measure_shape = false;
    const Scene& found = find_scene(scene);
    const RunResult result = run_scene(found, found.defaults, options);
    return result.operations.at("splits") + result.operations.at("collapses");
}

class Effort : public testing::TestWithParam<std::string> {};

// Scenes that stretch and fold the interface: many short edges, many of them at boundaries.
TEST_P(Effort, IsAboutTheSameInSubmeshes) {
    const std::uint64_t whole = splits_and_collapses(GetParam(), Strategy::sequential);
    ASSERT_GT(whole, 10'000U);
    for (const Strategy strategy : all_strategies()) {
        if (is_parallel(strategy)) {
            EXPECT_LT(static_cast<double>(splits_and_collapses(GetParam(), strategy)),
                      most_of_sequential * static_cast<double>(whole))
                << to_string(strategy);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Effort, testing::Values("swirl", "single-vortex", "swirl-zalesak"),
                         [](const auto& one) {
                             std::string name = one.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

} // namespace
} // namespace dsc::scenes::effort_test
