// SPDX-License-Identifier: MIT
// Frames and pictures that a run writes: at which steps, and what they show.
#include "scenes/output/frames.h"
#include "scenes/output/pictures.h"

#include "dsc/base/error.h"
#include "dsc/initial/initial_complex.h"
#include "support/outline_testing.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace dsc::scenes::output_test {
namespace {

TEST(Frames, AreDueAtStepsAndTimes) {
    scenes::Setup setup;
    setup.steps = 10;
    setup.dt = 0.1;
    setup.half_step = 5;
    const auto due = [&](FramePlan plan) {
        plan.folder = "somewhere";
        std::vector<int> steps;
        for (int step = 0; step <= setup.steps; ++step) {
            if (is_frame_due(plan, setup, step)) {
                steps.push_back(step);
            }
        }
        return steps;
    };
    EXPECT_EQ(due({.count = 3}), (std::vector<int>{0, 5, 10}));
    EXPECT_EQ(due({.every = 4}), (std::vector<int>{0, 4, 8, 10}));
    EXPECT_EQ(due({.times = {0.3, 0.31, 0.7, 1.0}}), (std::vector<int>{3, 4, 7, 10}));
    EXPECT_EQ(due({.every = 5, .times = {0.05}}), (std::vector<int>{0, 1, 5, 10}));
    EXPECT_FALSE(is_frame_due({}, setup, 0));
    EXPECT_THROW(check_times({.times = {1.05}}, setup), InputError);
    EXPECT_THROW(check_times({.times = {-0.1}}, setup), InputError);
    // In floating point 2.1 / 0.7 is more than 3, but the third step must still have this frame.
    setup.dt = 0.7;
    EXPECT_TRUE(is_frame_due({.folder = "f", .times = {2.1}}, setup, 3));
}

TEST(Pictures, HaveTheLayersThatAreAskedFor) {
    const auto folder = std::filesystem::temp_directory_path();
    const std::string path = folder / ("dsc_picture_" + std::to_string(getpid()) + ".svg");
    const std::vector<Shape> shapes{{test::square(0.1, 0.1, 0.5), 2}};
    const auto complex = initial_complex<double>({}, shapes, {.edge_length = 0.1});
    const auto expect = [&](const char* layers, std::initializer_list<const char*> there,
                            std::initializer_list<const char*> not_there) {
        SCOPED_TRACE(layers);
        write_picture(complex, parse_layers(layers), "a title", path);
        std::ifstream file(path);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        for (const char* what : there) {
            EXPECT_NE(text.find(what), std::string::npos) << what;
        }
        for (const char* what : not_there) {
            EXPECT_EQ(text.find(what), std::string::npos) << what;
        }
    };
    expect("phases,edges,interface",
           {"class=\"phase-2\"", "class=\"interface\"", "stroke=\"#888888\"",
            "<title>a title</title>"},
           {"class=\"quality-"});
    expect("quality", {"class=\"quality-3"}, {"phase-2", "class=\"interface\""});
    std::filesystem::remove(path);
}

} // namespace
} // namespace dsc::scenes::output_test
