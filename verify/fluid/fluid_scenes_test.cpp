// SPDX-License-Identifier: MIT
// The scenes of fluids in coarse meshes: the complex stays valid, and figures agree with the
// physics.
#include "scenes/catalogue/catalogue.h"
#include "scenes/run/json.h"
#include "scenes/run/run.h"

#include "dsc/base/error.h"
#include "dsc/queries/validate.h"
#include "replay/mesh_hash.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace dsc::scenes::fluid_scenes_test {
namespace {

RunResult run(const Scene& scene, const std::vector<std::string>& settings,
              const RunOptions& options = {}) {
    Parameters parameters = scene.defaults;
    for (const std::string& setting : settings) {
        apply_setting(parameters, scene.keys, setting);
    }
    return run_scene(scene, parameters, options);
}

RunResult run(const std::string& name, const std::vector<std::string>& settings,
              const RunOptions& options = {}) {
    return run(find_scene(name), settings, options);
}

// The scene with another setup.
Scene changed(const std::string& name, const std::function<void(Setup&)>& change) {
    Scene scene = find_scene(name);
    scene.prepare = [original = scene.prepare, change](const Parameters& parameters) {
        Setup setup = original(parameters);
        change(setup);
        return setup;
    };
    return scene;
}

TEST(FluidScenes, AreValidAfterEveryStep) {
    for (const Scene& scene : catalogue()) {
        if (!scene.prepare(scene.defaults).fluid) {
            continue;
        }
        SCOPED_TRACE(scene.name);
        int looked_at = 0;
        RunOptions options;
        options.observer = [&](int, const Complex<double>& complex) {
            ++looked_at;
            EXPECT_EQ(validate(complex).problem, "");
        };
        const std::string h = std::to_string(2 * scene.defaults.h);
        const RunResult result = run(scene.name, {"h=" + h, "steps=2", "dt=0.01"}, options);
        EXPECT_TRUE(result.holds());
        EXPECT_EQ(looked_at, 3);
        EXPECT_LT(number(result.fluid, "area_drift_last"), 1e-11);
        EXPECT_GT(number(result.fluid, "largest_velocity_last"), 0);
    }
}

// Compares the first steps of a run with the exact heights.
TEST(FluidScenes, WavesHaveTheirExactHeights) {
    const RunResult level = run("capillary-wave", {"dt=0.0075", "steps=30"});
    EXPECT_LT(number(level.fluid, "amplitude_error"), 2e-3);
    const RunResult drop = run("oscillating-drop", {"dt=0.025", "steps=20"});
    EXPECT_LT(number(drop.fluid, "amplitude_error"), 5e-3);
}

TEST(FluidScenes, TheResultAndItsSeriesHaveTheFigures) {
    RunOptions options;
    options.series_every = 1;
    const RunResult result = run("rising-bubble", {"h=0.08", "dt=0.02", "steps=4"}, options);
    const std::string json = to_json(result);
    for (const char* key :
         {"circularity_min", "circularity_min_t", "rise_velocity_max", "rise_velocity_max_t",
          "centre_last", "area_drift_last", "largest_velocity_last", "pressure_jump_last",
          "energy_last", "solve_s", "assembly_s", "dsc_s"}) {
        EXPECT_NE(json.find('"' + std::string(key) + "\": "), std::string::npos) << key;
    }
    ASSERT_EQ(result.series.size(), 5U);
    EXPECT_EQ(number(result.series[0].figures, "rise_velocity"), 0);
    EXPECT_GT(number(result.series[4].figures, "rise_velocity"),
              number(result.series[3].figures, "rise_velocity"));
    EXPECT_EQ(number(result.series[4].figures, "rise_velocity"),
              number(result.fluid, "rise_velocity_max"));
}

TEST(FluidScenes, RunInDoubleAndNotByTheReference) {
    EXPECT_THROW(run("static-drop", {"real=float"}), InputError);
    RunOptions options;
    options.strategy = Strategy::reference;
    EXPECT_THROW(run("static-drop", {}, options), InputError);
}

TEST(FluidScenes, ATensionOfPhasesThatNeverMeetIsRefused) {
    const Scene scene = changed("rising-bubble", [](auto& setup) {
        setup.fluid->options.phases.push_back({.phase = 2});
        setup.fluid->options.tensions.push_back({.one = 1, .other = 2, .tension = 1});
    });
    EXPECT_THROW((void)run(scene, {"topology=keep", "h=0.1", "steps=1"}), InputError);
    EXPECT_TRUE(run(scene, {"topology=change", "h=0.1", "steps=1"}).holds())
        << "they may meet later";
}

// A drop of another phase falls into the pool, but no tension is given for this pair of phases.
TEST(FluidScenes, PhasesThatMeetWithoutATensionEndTheRun) {
    const Scene scene = changed("falling-drop", [](auto& setup) {
        setup.curves.back().left = 2;
        setup.fluid->options.phases.push_back({.phase = 2, .density = 1000, .viscosity = 5});
        setup.fluid->options.tensions.push_back({.one = 0, .other = 2, .tension = 20});
    });
    const RunResult result = run(scene, {"h=0.04", "dt=0.01"});
    EXPECT_NE(result.gave_up.find("no tension"), std::string::npos) << result.gave_up;
    EXPECT_GT(result.steps, 10);
    EXPECT_EQ(result.events.size(), 0U) << "those of the step are undone as well";
}

TEST(FluidScenes, ARunWhoseEquationsCannotBeSolvedSaysSo) {
    const Scene scene = changed("rising-bubble", [](auto& setup) {
        setup.fluid->options.gravity = {0, -1e300}; // forces beyond all numbers
    });
    RunOptions options;
    options.checkpoint.path = testing::TempDir() + "fluid_that_failed.checkpoint";
    std::uint64_t first = 0;
    options.observer = [&](int step, const Complex<double>& complex) {
        first = step == 0 ? mesh_hash(complex) : first;
    };
    const RunResult result = run(scene, {"h=0.08"}, options);
    EXPECT_FALSE(result.holds());
    EXPECT_NE(result.gave_up, "");
    EXPECT_EQ(result.steps, 0) << "the step is undone";
    EXPECT_EQ(result.mesh_hash, first);
    const Checkpoint saved = read_checkpoint(options.checkpoint.path);
    options.checkpoint.path.clear();
    options.resume = &saved;
    EXPECT_EQ(run(scene, {"h=0.08"}, options).gave_up, result.gave_up) << "and once more";
    EXPECT_GT(number(result.fluid, "energy_last"), 0) << "of the last good state";
}

} // namespace
} // namespace dsc::scenes::fluid_scenes_test
