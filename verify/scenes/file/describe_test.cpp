// SPDX-License-Identifier: MIT
// Every scene of the catalogue, written as a scene file, runs to the same bits.
#include "scenes/file/describe.h"

#include "dsc/base/error.h"
#include "scenes/file/formula/formula_flow.h"
#include "scenes/file/scene_file.h"
#include "scenes/run/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>

namespace dsc::scenes::describe_test {
namespace {

constexpr int described_steps = 4;

// Coarse, and with the time step of a whole run.
Parameters short_run(const Scene& scene) {
    Parameters parameters = scene.defaults;
    parameters.h = 2 * scene.defaults.h;
    parameters.dt = scene.prepare(parameters).dt;
    parameters.steps = scene.counts_steps_each_way ? described_steps / 2 : described_steps;
    return parameters;
}

void expect_same_bits(const RunResult& a, const RunResult& b) {
    EXPECT_EQ(a.mesh_hash, b.mesh_hash);
    EXPECT_EQ(a.steps, b.steps);
    ASSERT_EQ(a.last.size(), b.last.size());
    for (const char* figure : {"sd_rel", "area", "area_drift_exact", "hausdorff"}) {
        const double one = number(a.last, figure);
        const double other = number(b.last, figure);
        EXPECT_EQ(std::bit_cast<std::uint64_t>(one), std::bit_cast<std::uint64_t>(other))
            << figure << ": " << one << " and " << other;
    }
    EXPECT_EQ(a.half.has_value(), b.half.has_value());
}

class Described : public testing::TestWithParam<std::string> {};

TEST_P(Described, RunsToTheSameBits) {
    const Scene& scene = find_scene(GetParam());
    const Parameters parameters = short_run(scene);
    const SceneFile file = read_scene_text(describe(scene, parameters), "described.toml");
    EXPECT_EQ(file.scene.name, scene.name);
    EXPECT_EQ(file.scene.description, scene.description);
    const RunResult from_catalogue = run_scene(scene, parameters, {});
    const RunResult from_file = run_scene(file.scene, file.scene.defaults, {});
    expect_same_bits(from_catalogue, from_file);
    EXPECT_GE(from_file.steps, described_steps);
    // Nothing would be compared if nobody knew the exact shape.
    EXPECT_EQ(std::isfinite(number(from_file.last, "sd_rel")),
              static_cast<bool>(scene.prepare(parameters).exact));
}

TEST_P(Described, HasAllSettingsAndPartsOfTheScene) {
    const Scene& scene = find_scene(GetParam());
    const scenes::Setup there = scene.prepare(scene.defaults);
    const Scene read = read_scene_text(describe(scene, scene.defaults), "described.toml").scene;
    const scenes::Setup here = read.prepare(read.defaults);
    EXPECT_EQ(here.dt, there.dt);
    EXPECT_EQ(here.steps, there.steps);
    EXPECT_EQ(here.half_step, there.half_step);
    EXPECT_EQ(here.measured, there.measured);
    EXPECT_EQ(here.clamped, there.clamped);
    EXPECT_EQ(here.carried, there.carried);
    EXPECT_EQ(here.thresholds.size(), there.thresholds.size());
    EXPECT_EQ(here.insertion.has_value(), there.insertion.has_value());
    EXPECT_EQ(here.value.has_value(), there.value.has_value());
    EXPECT_EQ(here.sizes.changes_in_time, there.sizes.changes_in_time);
    EXPECT_EQ(static_cast<bool>(here.sizes.by_place), static_cast<bool>(there.sizes.by_place));
    EXPECT_EQ(static_cast<bool>(here.sizes.on_interface),
              static_cast<bool>(there.sizes.on_interface));
    EXPECT_EQ(here.outlines, there.outlines);
    EXPECT_EQ(here.curves.size(), there.curves.size());
    EXPECT_EQ(here.flow.size(), there.flow.size());
    EXPECT_EQ(here.curvature.has_value(), there.curvature.has_value());
    EXPECT_EQ(here.growth.has_value(), there.growth.has_value());
    EXPECT_EQ(here.fluid.has_value(), there.fluid.has_value());
    for (const Key& key : parameter_keys()) {
        if (key.is_common && key.name != "dt" && key.name != "steps") {
            EXPECT_EQ(key.value(read.defaults), key.value(scene.defaults)) << key.name;
        }
    }
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

TEST(Describe, RepeatsFormulasAndNumbersToTheBit) {
    const SceneFile first = read_scene_text(R"(
name = "mine"
[options]
h = 0.05
dt = 0.1
steps = 2
seed = "18446744073709551615"
[flow]
u = "a*x"
v = "-a*y"
parameters = { a = 0.1 }
[[shape]]
phase = 3
points = [[0.1, 0.2], [0.30000000000000004, 0.2], [0.3333333333333333, 0.7]]
)",
                                            "mine.toml");
    const std::string text = describe(first.scene, first.scene.defaults);
    const SceneFile second = read_scene_text(text, "mine.toml");
    EXPECT_EQ(text, describe(second.scene, second.scene.defaults));
    const scenes::Setup setup = second.scene.prepare(second.scene.defaults);
    EXPECT_EQ(setup.outlines.at(0).at(1).x(), 0.30000000000000004);
    EXPECT_EQ(setup.phases, std::vector<Phase>{3});
    EXPECT_EQ(second.scene.defaults.seed, UINT64_MAX);
    ASSERT_NE(setup.flow.at(0).velocity.target<FormulaFlow>(), nullptr);
}

// Of a file: what it says about its figures, and its exact shape.
TEST(Describe, RepeatsWhatAFileMeasures) {
    const SceneFile first = read_scene_text(R"(
name = "mine"
[options]
h = 0.05
dt = 0.1
period = 0.4
[flow]
u = '0.1*cos(pi*t/period)'
v = "0"
[[shape]]
points = [[0.3, 0.3], [0.7, 0.3], [0.5, 0.7]]
[exact]
back = true
[measure]
measures = ["hausdorff", "sd_rel", "min_quality"]
[limits]
min_quality_half.least = 0.1
area_ratio = { least = 0.99, most = 1.01 }
hausdorff_last = 0.30000000000000004
)",
                                            "mine.toml");
    const std::string text = describe(first, first.scene.defaults);
    const SceneFile second = read_scene_text(text, "mine.toml");
    EXPECT_EQ(text, describe(second, second.scene.defaults));
    ASSERT_EQ(second.limits.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(second.limits[i].figure, first.limits[i].figure);
        EXPECT_EQ(second.limits[i].least, first.limits[i].least);
        EXPECT_EQ(second.limits[i].most, first.limits[i].most);
    }
    RunOptions run;
    run.measures = first.measures;
    const RunResult a = run_scene(first.scene, first.scene.defaults, run);
    run.measures = second.measures;
    const RunResult b = run_scene(second.scene, second.scene.defaults, run);
    EXPECT_EQ(a.mesh_hash, b.mesh_hash);
    ASSERT_EQ(a.last.size(), 4U);
    ASSERT_EQ(b.last.size(), 4U);
    for (const char* figure : {"sd_rel", "hausdorff", "min_quality"}) {
        EXPECT_EQ(number(a.last, figure), number(b.last, figure)) << figure;
        EXPECT_TRUE(std::isfinite(number(a.last, figure))) << figure;
    }
}

TEST(Describe, KeepsTheExactShapeOfTheSceneAFileBeganAs) {
    const SceneFile first =
        read_scene_text("name = 'mine'\nscene = 'swirl'\n[options]\nh = 0.05\nsteps = 2\n"
                        "[measure]\nshape = false\n",
                        "mine.toml");
    const std::string text = describe(first, first.scene.defaults);
    const SceneFile second = read_scene_text(text, "mine.toml");
    EXPECT_FALSE(second.measures_shape);
    EXPECT_NE(text.find("scene = \"swirl\""), std::string::npos);
    EXPECT_EQ(run_scene(first.scene, first.scene.defaults, {}).mesh_hash,
              run_scene(second.scene, second.scene.defaults, {}).mesh_hash);
}

// Why the text is refused after a change; empty if it is not.
std::string refusal(std::string text, const std::string& old, const std::string& changed) {
    const std::size_t place = text.find(old);
    EXPECT_NE(place, std::string::npos) << old;
    text.replace(place, old.size(), changed);
    try {
        (void)read_scene_text(text, "mine.toml");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

// Nobody's edited shape is judged against the one that it was before.
TEST(Describe, KeepsTheExactShapeUntilTheShapeOrTheMotionChanges) {
    const auto described = [](const std::string& name) {
        Parameters parameters = find_scene(name).defaults;
        parameters.h = 0.05;
        return describe(find_scene(name), parameters);
    };
    const std::string swirl = described("swirl");
    EXPECT_NE(swirl.find("# That of the shape"), std::string::npos);
    const std::string circle = described("curvature-circle");
    for (const auto& [text, old, changed, what] :
         {std::tuple{swirl, "points = [\n    [0.", "points = [\n    [0.0", "another shape"},
          {swirl, "\nphase = 1", "\nphase = 2", "another shape"},
          {swirl, "amplitude = 1", "amplitude = 1.01", "another motion"},
          {swirl, "reversed = true", "reversed = false", "another motion"},
          {circle, "\n[curvature]\n",
           "\n[curvature]\n[[curvature.pairs]]\none = 0\nother = 1\nmobility = 2\n",
           "another motion"},
          {circle, "\n[curvature]\n", "\n[growth]\nspeed = 1\n", "another motion"}}) {
        EXPECT_NE(refusal(text, old, changed).find(what), std::string::npos) << changed;
    }
    // What changes neither is free.
    EXPECT_EQ(refusal(swirl, "\nh = 0.05", "\nh = 0.04"), "");
    EXPECT_EQ(refusal(swirl, "swirl = { amplitude = 1,", "swirl = { amplitude = 1.0,"), "");
    EXPECT_EQ(refusal(swirl, "high = [1, 1]", "high = [1, 1.1]"), "");
}

// The settings that the exact shape names none of are those of the file, which --set changes.
TEST(Describe, TakesTheSettingsOfAFileThatBeginsAsTheScene) {
    const SceneFile file = read_scene_text("scene = 'vortex-square'\n[options]\nh = 0.0525\n"
                                           "[domain]\nlow = [0, -0.1]\nhigh = [1, 1]\n"
                                           "[exact]\nscene = 'vortex-square'\n",
                                           "mine.toml");
    Parameters parameters = file.scene.defaults;
    parameters.h = 0.05;
    parameters.steps = 20; // the flow turns earlier
    const RunResult result = run_scene(file.scene, parameters, {});
    EXPECT_LT(number(result.last, "sd_rel"), 1e-3); // against that of 250 steps: 0.25
}

TEST(Describe, RefusesAFlowWithoutAName) {
    Scene scene = find_scene("scaling");
    scene.prepare = [prepare = scene.prepare](const Parameters& p) {
        scenes::Setup setup = prepare(p);
        setup.flow = steady([](auto, double, auto) {});
        return setup;
    };
    EXPECT_THROW((void)describe(scene, scene.defaults), InputError);
}

} // namespace
} // namespace dsc::scenes::describe_test
