// SPDX-License-Identifier: MIT
// Every scene of the catalogue, coarse enough to be looked at after every step: always a valid
// complex, nobody left behind, and figures that agree with each other.
#include "scenes/catalogue/catalogue.h"
#include "support/usual_efforts.h"

#include "scenes/run/run.h"

#include "dsc/queries/validate.h"
#include "measures/interface_outlines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace dsc::scenes::every_scene_test {
namespace {

// The coarsest edge length at which the scene is still itself.
double coarse_edge(const std::string& scene) {
    if (scene == "zalesak") {
        return 0.025; // half the slot
    }
    if (scene == "swirl-zalesak") {
        return 0.02; // three times the width of the legs at the end
    }
    if (scene == "single-vortex") {
        return 0.025; // the filament gets as thin as this
    }
    if (scene == "t1") {
        return 0.02; // later the edge is as long as the domain allows
    }
    if (scene == "curvature-dumbbell") {
        return 0.02; // a third of the neck
    }
    if (scene == "quality-combinations" || scene == "quality-varying") {
        return 0.02; // coarse edges are four times as long
    }
    return 0.04;
}

Parameters coarse_parameters(const Scene& scene) {
    Parameters parameters = scene.defaults;
    parameters.h = coarse_edge(scene.name);
    // Longer ones make filaments for whose exact shape a test has no time.
    if (scene.name == "swirl") {
        parameters.steps = 130;
    } else if (scene.name == "swirl-zalesak") {
        parameters.steps = 60;
    } else if (scene.name == "single-vortex") {
        parameters.period = 1.4;
    } else if (scene.name == "t1" || scene.name == "grains" || scene.name == "foam") {
        parameters.dt = 0.4 * parameters.h * parameters.h; // their own takes too many steps
    }
    return parameters;
}

struct Case {
    std::string scene;
    Strategy strategy;
};

std::vector<Case> cases() {
    std::vector<Case> list;
    for (const Scene& scene : catalogue()) {
        for (const Strategy strategy : {Strategy::sequential, Strategy::active}) {
            list.push_back({scene.name, strategy});
        }
    }
    return list;
}

class EveryScene : public testing::TestWithParam<Case> {};

// Time is no test of a fault that makes a step look at more than it has to.
void expect_usual_effort(const RunResult& result) {
    const auto usual = std::ranges::find(usual_efforts, result.scene, &UsualEffort::scene);
    ASSERT_NE(usual, usual_efforts.end()) << result.scene;
    const double stars = static_cast<double>(result.operations.at("examined")) /
                         static_cast<double>(result.operations.at("moves"));
    EXPECT_LE(stars, most_of_usual * usual->stars) << "stars examined for each move";
    EXPECT_GE(stars, usual->stars / most_of_usual) << "usual_efforts.h is out of date";
    const double passes = result.passes_per_vertex_step;
    const double most = is_parallel(result.strategy) ? most_passes_in_submeshes : most_of_usual;
    EXPECT_LE(passes, most * usual->passes) << "passes for each vertex and step";
    EXPECT_GE(passes, usual->passes / most_of_usual) << "usual_efforts.h is out of date";
}

TEST_P(EveryScene, IsValidAfterEveryStep) {
    const Scene& scene = find_scene(GetParam().scene);
    const Parameters parameters = coarse_parameters(scene);
    RunOptions options;
    options.strategy = GetParam().strategy;
    options.submeshing.submeshes = 4;
    const scenes::Setup setup = scene.prepare(parameters);
    int looked_at = 0;
    std::uint64_t hash = 0;
    std::uint64_t triangles = 0;
    double area = 0;
    options.observer = [&](int step, const Complex<double>& complex) {
        ASSERT_EQ(step, looked_at);
        ++looked_at;
        ASSERT_EQ(validate(complex).problem, "") << "after step " << step;
        hash = mesh_hash(complex);
        triangles = complex.triangle_count();
        area = signed_area(interface_outlines(complex, {.phase = setup.measured}));
    };
    const RunResult result = run_scene(scene, parameters, options);
    EXPECT_EQ(looked_at, result.steps + 1);
    EXPECT_EQ(result.steps, setup.steps);
    EXPECT_EQ(result.mesh_hash, hash);
    EXPECT_EQ(result.triangles_last, triangles);
    EXPECT_EQ(number(result.last, "area"), area);
    EXPECT_EQ(result.inverted, 0U);
    EXPECT_EQ(result.unreached, 0U);
    EXPECT_EQ(result.held, 0U);
    EXPECT_EQ(result.gave_up, "");
    EXPECT_GE(result.sub_steps, static_cast<std::uint64_t>(result.steps));
    EXPECT_GT(result.operations.at("moves"), 0U);
    expect_usual_effort(result);
    EXPECT_GT(number(result.last, "min_quality"), 0.0);
    EXPECT_LE(result.min_quality_ever, number(result.last, "min_quality"));
    EXPECT_EQ(result.area_histogram.total(), triangles);
    EXPECT_EQ(result.quality_histogram.total(), triangles);
    EXPECT_EQ(result.area_ratio, number(result.last, "area") / result.area_first);
    if (!setup.exact) {
        return;
    }
    // Coarse, but the shape that it should be.
    EXPECT_LT(number(result.last, "sd_rel"), 0.1);
    const double exact = number(result.last, "area_exact");
    EXPECT_NEAR(number(result.last, "area"), exact, 0.05 * std::max(exact, result.area_first));
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
    std::string name = info.param.scene + "_" + to_string(info.param.strategy);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryScene, testing::ValuesIn(cases()), name_of);

} // namespace
} // namespace dsc::scenes::every_scene_test
