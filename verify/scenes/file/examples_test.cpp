// SPDX-License-Identifier: MIT
// The example files run, and each of them keeps to its limits.
#include "dsc/queries/validate.h"
#include "scenes/file/scene_file.h"
#include "scenes/file/text_file.h"
#include "scenes/run/run.h"
#include "scenes/space/run.h"
#include "scenes/space/scene_file.h"
#include "support/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace dsc::scenes::examples_test {
namespace {

std::vector<std::string> names_of_examples() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(DSC_EXAMPLES)) {
        if (entry.path().extension() == ".toml") {
            names.push_back(entry.path().stem().string());
        }
    }
    std::ranges::sort(names);
    return names;
}

std::filesystem::path example(const std::string& name) {
    return std::filesystem::path(DSC_EXAMPLES) / (name + ".toml");
}

class Example : public testing::TestWithParam<std::string> {};

TEST_P(Example, RunsAndStaysValid) {
    const std::string text = read_text_file(example(GetParam()));
    if (space::is_in_space(text, example(GetParam()))) {
        const space::SceneFile file = space::read_scene_text(text, example(GetParam()));
        const space::RunResult result = space::run_scene(file.scene, file.scene.defaults, {});
        EXPECT_TRUE(result.holds()) << result.problem;
        for (const FigureLimit& limit : file.limits) {
            const double measured = space::figures(result).at(limit.figure);
            EXPECT_GE(measured, limit.min) << limit.figure;
            EXPECT_LE(measured, limit.max) << limit.figure;
        }
        return;
    }
    SceneFile file = read_scene_file(example(GetParam()));
    if (test::are_asked_for("few")) { // FluidCylinder runs until the flow is steady
        file.scene.defaults.steps = std::min(file.scene.defaults.steps, 120);
    }
    RunOptions options;
    options.observer = [](int step, const Complex<double>& complex) {
        ASSERT_EQ(validate(complex).problem, "") << "after step " << step;
    };
    const RunResult result = run_scene(file.scene, file.scene.defaults, options);
    EXPECT_TRUE(result.holds());
    EXPECT_EQ(result.steps, file.scene.prepare(file.scene.defaults).steps);
    for (const FigureLimit& limit : file.limits) {
        const std::string name = limit.figure.substr(0, limit.figure.rfind("_last"));
        const double measured =
            name == "area_ratio" ? result.area_ratio : number(result.last, name);
        EXPECT_GE(measured, limit.min) << limit.figure;
        EXPECT_LE(measured, limit.max) << limit.figure;
    }
}

TEST_P(Example, BeginsWithACommentOfTwoLines) {
    const std::string text = read_text_file(example(GetParam()));
    EXPECT_TRUE(text.starts_with("# "));
    const std::size_t second = text.find('\n') + 1;
    EXPECT_EQ(text.compare(second, 2, "# "), 0);
}

INSTANTIATE_TEST_SUITE_P(Examples, Example, testing::ValuesIn(names_of_examples()),
                         [](const auto& one) {
                             std::string name = one.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

TEST(Examples, AreWhatTheyShow) {
    const SceneFile bubbles = read_scene_file(example("double-bubble"));
    const RunResult result = run_scene(bubbles.scene, bubbles.scene.defaults, {});
    // The films meet at 120 degrees, and areas are kept.
    EXPECT_EQ(result.junctions.count, 2U);
    EXPECT_LT(result.junctions.worst_deviation_deg, 2);
    EXPECT_NEAR(result.area_ratio, 1, 1e-6);
    // The heart loses its tip; the rest comes back.
    const SceneFile heart = read_scene_file(example("heart"));
    const double ratio = run_scene(heart.scene, heart.scene.defaults, {}).area_ratio;
    EXPECT_LT(ratio, 0.9995);
    EXPECT_GT(ratio, 0.99);
    // The exact shape of the vortex is known at the end, when the flow has returned.
    const SceneFile vortex = read_scene_file(example("my-vortex"));
    EXPECT_LT(number(run_scene(vortex.scene, vortex.scene.defaults, {}).last, "sd_rel"), 0.005);
}

} // namespace
} // namespace dsc::scenes::examples_test
