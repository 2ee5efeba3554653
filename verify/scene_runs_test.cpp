// SPDX-License-Identifier: MIT
// Every scene of the catalogue, coarse enough to be looked at after every step: always a valid
// complex, nobody left behind, and figures that agree with each other.
#include "scenes/run.h"

#include "dsc/base/error.h"
#include "dsc/complex/hash.h"
#include "dsc/complex/validate.h"
#include "scenes/measure.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

namespace dsc::scenes {
namespace {

// The coarsest edge length at which the scene is still itself.
double coarse_edge(const std::string& scene) {
    if (scene == "zalesak") {
        return 0.025; // half the slot
    }
    if (scene == "single-vortex") {
        return 0.025; // the filament gets as thin as this
    }
    return 0.04;
}

Parameters coarse_parameters(const Scene& scene) {
    Parameters parameters = scene.defaults;
    parameters.h = coarse_edge(scene.name);
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

TEST_P(EveryScene, IsValidAfterEveryStep) {
    const Scene& scene = find_scene(GetParam().scene);
    const Parameters parameters = coarse_parameters(scene);
    RunOptions options;
    options.strategy = GetParam().strategy;
    options.submeshing.submeshes = 4;
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
        area = signed_area(interface_outlines(complex));
    };
    const RunResult result = run_scene(scene, parameters, options);
    EXPECT_EQ(looked_at, result.steps + 1);
    EXPECT_EQ(result.steps, scene.prepare(parameters).steps);
    EXPECT_EQ(result.mesh_hash, hash);
    EXPECT_EQ(result.triangles_last, triangles);
    EXPECT_EQ(result.area_last, area);
    EXPECT_EQ(result.inverted, 0U);
    EXPECT_EQ(result.unreached, 0U);
    EXPECT_EQ(result.held, 0U);
    EXPECT_EQ(result.gave_up, "");
    EXPECT_GE(result.sub_steps, static_cast<std::uint64_t>(result.steps));
    EXPECT_GT(result.operations.at("moves"), 0U);
    EXPECT_GT(result.min_quality_last, 0.0);
    EXPECT_LE(result.min_quality_ever, result.min_quality_last);
    EXPECT_EQ(result.area_histogram.total(), triangles);
    EXPECT_EQ(result.quality_histogram.total(), triangles);
    EXPECT_EQ(result.area_ratio, result.area_last / result.area_first);
    // Coarse, but the shape that it should be.
    EXPECT_LT(result.sd_rel_last, 0.1);
    EXPECT_NEAR(result.area_last / result.area_exact_last, 1, 0.05);
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
    std::string name = info.param.scene + "_" + to_string(info.param.strategy);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryScene, testing::ValuesIn(cases()), name_of);

// --- running one --------------------------------------------------------------------------------

Parameters short_run(const Scene& scene) {
    Parameters parameters = coarse_parameters(scene);
    parameters.steps = 10;
    return parameters;
}

TEST(RunScene, GivesTheSameBitsAgain) {
    const Scene& scene = find_scene("swirl");
    const RunResult a = run_scene(scene, short_run(scene), {});
    const RunResult b = run_scene(scene, short_run(scene), {});
    EXPECT_EQ(a.mesh_hash, b.mesh_hash);
    EXPECT_EQ(a.operations, b.operations);
    EXPECT_EQ(a.sd_rel_last, b.sd_rel_last);
    Parameters other = short_run(scene);
    other.seed = 3;
    EXPECT_NE(run_scene(scene, other, {}).mesh_hash, a.mesh_hash);
}

TEST(RunScene, RunsInFloat) {
    const Scene& scene = find_scene("swirl");
    Parameters parameters = short_run(scene);
    const RunResult wide = run_scene(scene, parameters, {});
    parameters.real = RealType::single_precision;
    const RunResult narrow = run_scene(scene, parameters, {});
    EXPECT_TRUE(narrow.holds());
    EXPECT_NE(narrow.mesh_hash, wide.mesh_hash);
    EXPECT_NEAR(narrow.area_ratio, wide.area_ratio, 1e-4);
}

TEST(RunScene, EndsWhenInterrupted) {
    const Scene& scene = find_scene("swirl");
    std::atomic<bool> interrupted{false};
    RunOptions options;
    options.interrupted = &interrupted;
    options.observer = [&](int step, const Complex<double>&) {
        if (step == 3) {
            interrupted = true;
        }
    };
    const RunResult result = run_scene(scene, short_run(scene), options);
    EXPECT_TRUE(result.interrupted);
    EXPECT_EQ(result.steps, 3);
}

TEST(RunScene, RefusesWhatDoesNotGoTogether) {
    const Scene& scene = find_scene("swirl");
    RunOptions options;
    options.submeshing.threads = 2;
    EXPECT_THROW((void)run_scene(scene, short_run(scene), options), InputError);
    options.strategy = Strategy::reference;
    EXPECT_THROW((void)run_scene(scene, short_run(scene), options), InputError);
    options.strategy = Strategy::counting;
    options.submeshing.submeshes = 70000;
    EXPECT_THROW((void)run_scene(scene, short_run(scene), options), InputError);
    EXPECT_THROW((void)parse_strategy("cubes"), InputError);
    EXPECT_THROW((void)find_scene("swril"), InputError);
    for (const Strategy strategy : all_strategies) {
        EXPECT_EQ(parse_strategy(to_string(strategy)), strategy);
    }
}

TEST(RunScene, WritesTheContractsKeys) {
    const Scene& scene = find_scene("swirl");
    const auto json = nlohmann::json::parse(to_json(run_scene(scene, short_run(scene), {})));
    for (const char* key : {"scene",
                            "parameters",
                            "steps",
                            "triangles_first",
                            "triangles_last",
                            "interface_vertices_last",
                            "area_first",
                            "area_last",
                            "area_exact_last",
                            "area_ratio",
                            "sd_rel_last",
                            "sd_rel_half",
                            "hausdorff_last",
                            "min_quality_last",
                            "min_angle_deg_last",
                            "min_quality_ever",
                            "inverted",
                            "unreached",
                            "operations",
                            "cpu_s",
                            "wall_s",
                            "step_us_median",
                            "threads",
                            "strategy",
                            "mesh_hash",
                            "commit",
                            "machine"}) {
        EXPECT_TRUE(json.contains(key)) << key;
    }
    EXPECT_EQ(json["scene"], "swirl");
    EXPECT_EQ(json["steps"], 20);
    EXPECT_EQ(json["parameters"]["steps"], 10);
    EXPECT_TRUE(json["sd_rel_half"].is_number());
    const Scene& one_way = find_scene("scaling");
    const auto other = nlohmann::json::parse(to_json(run_scene(one_way, short_run(one_way), {})));
    EXPECT_TRUE(other["sd_rel_half"].is_null());
}

} // namespace
} // namespace dsc::scenes
