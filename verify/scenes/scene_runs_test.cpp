// SPDX-License-Identifier: MIT
// What a run of a scene gives: figures that agree with each other, and the keys of the contract.
#include "scenes/catalogue/catalogue.h"
#include "support/enumerators.h"

#include "scenes/run/json.h"
#include "scenes/run/run.h"

#include "dsc/base/error.h"
#include "dsc/parallel/executors.h"
#include "measures/hausdorff.h"
#include "measures/interface_outlines.h"
#include "measures/symmetric_difference.h"
#include "scenes/file/excerpt.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace dsc::scenes::scene_runs_test {
namespace {

Parameters short_run(const Scene& scene) {
    Parameters parameters = scene.defaults;
    parameters.h = 0.04;
    parameters.steps = 10;
    return parameters;
}

TEST(RunScene, EndsWhenInterrupted) {
    const Scene& scene = find_scene("scaling");
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
    for (const StrategyEntry& entry : strategies()) {
        EXPECT_EQ(parse_strategy(entry.name), entry.strategy);
    }
}

TEST(Strategies, HaveOneEntryEach) {
    ASSERT_EQ(strategies().size(), test::count_enumerators<Strategy>());
    std::set<std::string> names;
    for (std::size_t i = 0; i < strategies().size(); ++i) {
        const StrategyEntry& entry = strategies()[i];
        EXPECT_EQ(entry.strategy, static_cast<Strategy>(i));
        EXPECT_TRUE(names.insert(entry.name).second) << entry.name << " twice";
        EXPECT_FALSE(entry.description.empty()) << entry.name;
        EXPECT_EQ(submeshes_of(entry.strategy, {.submeshes = 3}),
                  is_parallel(entry.strategy) ? 3U : 1U);
    }
    EXPECT_EQ(name_list(parallel_strategies(), [](Strategy one) { return to_string(one); }),
              "fixed, counting, active, blocks, cells, copy");
}

TEST(RunScene, WritesTheContractsKeys) {
    const Scene& scene = find_scene("swirl");
    const auto json = nlohmann::json::parse(to_json(run_scene(scene, short_run(scene), {})));
    std::istringstream keys(
        "scene parameters steps triangles_first triangles_last interface_vertices_last area_first "
        "area_last area_exact_last area_ratio sd_rel_last sd_rel_half hausdorff_last "
        "min_quality_last min_angle_deg_last min_quality_ever inverted unreached operations events "
        "phases junctions_last cpu_s wall_s run_s first_step_us step_us_median threads "
        "threads_used "
        "strategy submeshes mesh_hash peak_memory_mb commit machine");
    for (std::string key; keys >> key;) {
        EXPECT_TRUE(json.contains(key) && !json[key].is_null()) << key;
    }
    EXPECT_TRUE(json["jaggedness_half"]["largest_excess_deg"].is_number());
    EXPECT_EQ(json["scene"], "swirl");
    EXPECT_EQ(json["steps"], 20);
    EXPECT_EQ(json["parameters"]["steps"], 10);
    EXPECT_TRUE(json["sd_rel_half"].is_number());
    const Scene& one_way = find_scene("scaling");
    const auto other = nlohmann::json::parse(to_json(run_scene(one_way, short_run(one_way), {})));
    for (const char* key : {"area_half", "sd_rel_half", "hausdorff_half", "jaggedness_half"}) {
        EXPECT_TRUE(other.contains(key) && other[key].is_null()) << key;
    }
    RunOptions options;
    options.measure_shape = false;
    const auto without =
        nlohmann::json::parse(to_json(run_scene(scene, short_run(scene), options)));
    EXPECT_TRUE(without["sd_rel_last"].is_null()) << "what could not be measured";
}

TEST(RunScene, SaysHowThePhasesDivideTheDomain) {
    const Scene& scene = find_scene("swirl");
    const auto json = nlohmann::json::parse(to_json(run_scene(scene, short_run(scene), {})));
    const auto& phases = json["phases"];
    ASSERT_EQ(phases.size(), 2U);
    EXPECT_EQ(phases[0]["phase"], 0);
    EXPECT_EQ(phases[1]["phase"], 1);
    EXPECT_NEAR(phases[0]["area"].get<double>() + phases[1]["area"].get<double>(), 1, 1e-13);
    EXPECT_NEAR(phases[1]["area"].get<double>(), json["area_last"].get<double>(), 1e-3);
    EXPECT_NEAR(phases[0]["boundary"].get<double>(), 4, 1e-13);
    EXPECT_EQ(phases[0]["perimeter"], phases[1]["perimeter"]);
    EXPECT_EQ(phases[0]["holes"], 1);
    EXPECT_EQ(phases[1]["components"], 1);
    EXPECT_EQ(json["junctions_last"], 0);
}

TEST(RunScene, MeasuresBothMoments) {
    const Scene& scene = find_scene("swirl");
    const Parameters parameters = short_run(scene);
    const scenes::Setup setup = scene.prepare(parameters);
    std::vector<Outline> half;
    std::vector<Outline> last;
    RunOptions options;
    options.observer = [&](int step, const Complex<double>& complex) {
        (step == *setup.half_step ? half : last) = interface_outlines(complex);
    };
    const RunResult result = run_scene(scene, parameters, options);
    const double time = *setup.half_step * setup.dt;
    for (const auto& [outlines, exact, figures] :
         {std::tuple(half, setup.exact(time), result.half.value()),
          std::tuple(last, setup.exact(2 * time), result.last)}) {
        EXPECT_EQ(number(figures, "area"), signed_area(outlines));
        EXPECT_EQ(number(figures, "area_exact"), exact.area);
        EXPECT_EQ(number(figures, "sd"), symmetric_difference(outlines, exact.outlines));
        EXPECT_EQ(number(figures, "hausdorff"), hausdorff(outlines, exact.outlines).distance());
        EXPECT_EQ(number(figures, "exact_error"), exact.own_error);
        EXPECT_GT(number(figures, "sd"), 100 * number(figures, "exact_error"));
    }
    const auto json = nlohmann::json::parse(to_json(result));
    EXPECT_EQ(json["sd_half"], number(*result.half, "sd"));
    EXPECT_EQ(json["sd_last"], number(result.last, "sd"));
    EXPECT_EQ(json["sd_rel_half"], number(*result.half, "sd_rel"));
    EXPECT_EQ(json["sd_rel_last"], number(result.last, "sd_rel"));
}

} // namespace
} // namespace dsc::scenes::scene_runs_test
