// SPDX-License-Identifier: MIT
// Every scene of the catalogue, written as a scene file by `describe`, gives the same scene.
#include "scenes/file/describe.h"

#include "scenes/file/scene_file.h"
#include "scenes/run/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dsc::scenes::describe_test {
namespace {

class Described : public testing::TestWithParam<std::string> {};

TEST_P(Described, IsTheSceneWithAllItsOptions) {
    const Scene& scene = find_scene(GetParam());
    Parameters parameters = scene.defaults;
    parameters.h = 2 * scene.defaults.h;
    parameters.seed = UINT64_MAX;
    parameters.tolerance = 1.0 / 3;
    const Scene read = read_scene_text(describe(scene, parameters), "described.toml").scene;
    EXPECT_EQ(read.name, scene.name);
    EXPECT_EQ(read.keys, scene.keys);
    for (const Key& key : parameter_keys()) {
        EXPECT_EQ(key.value(read.defaults), key.value(parameters)) << key.name;
    }
    const scenes::Setup there = scene.prepare(parameters);
    const scenes::Setup here = read.prepare(read.defaults);
    EXPECT_EQ(here.dt, there.dt);
    EXPECT_EQ(here.steps, there.steps);
    EXPECT_EQ(here.outlines, there.outlines);
    EXPECT_EQ(static_cast<bool>(here.exact), static_cast<bool>(there.exact));
}

std::vector<std::string> names_of_scenes() {
    std::vector<std::string> names;
    for (const Scene& scene : catalogue()) {
        names.push_back(scene.name);
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Described, testing::ValuesIn(names_of_scenes()),
                         [](const auto& one) {
                             std::string name = one.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

TEST(Describe, RunsToTheSameBits) {
    const Scene& scene = find_scene("swirl");
    Parameters parameters = scene.defaults;
    parameters.h = 0.05;
    parameters.steps = 4;
    const Scene read = read_scene_text(describe(scene, parameters), "described.toml").scene;
    const RunResult one = run_scene(scene, parameters, {});
    const RunResult other = run_scene(read, read.defaults, {});
    EXPECT_EQ(one.mesh_hash, other.mesh_hash);
    EXPECT_EQ(number(one.last, "sd_rel"), number(other.last, "sd_rel"));
    EXPECT_TRUE(std::isfinite(number(other.last, "sd_rel")));
}

} // namespace
} // namespace dsc::scenes::describe_test
