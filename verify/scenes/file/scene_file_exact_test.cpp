// SPDX-License-Identifier: MIT
// The exact shape given in a scene file, and the errors measured against it.
#include "scenes/catalogue/catalogue.h"
#include "scenes/file/scene_file.h"
#include "scenes/run/run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace dsc::scenes::scene_file_exact_test {
namespace {

const std::string options = "[options]\nh = 0.1\ndt = 0.01\nsteps = 2\n";
const std::string swirl_flow = "[flow]\nu = 'sin(pi*x)^2 * sin(2*pi*y) * cos(pi*t/period)'\n"
                               "v = '-sin(pi*y)^2 * sin(2*pi*x) * cos(pi*t/period)'\n";
const std::string disc = "[[shape]]\ncircle = { centre = [0.5, 0.5], radius = 0.2 }\n";

SceneFile read(const std::string& text) { return read_scene_text(text, "s.toml"); }

scenes::Setup setup_of(const std::string& text) {
    const Scene scene = read(text).scene;
    return scene.prepare(scene.defaults);
}

TEST(SceneFileExact, KnowsExactShapes) {
    const std::string vortex = "[options]\nh = 0.1\ndt = 0.1\nperiod = 2\n" + swirl_flow + disc;
    const auto back = setup_of(vortex + "[exact]\nback = true").exact;
    EXPECT_NEAR(back(0).area, 0.04 * 3.14159265358979, 1e-9);
    EXPECT_NEAR(back(2).area, 0.04 * 3.14159265358979, 1e-9);
    EXPECT_TRUE(std::isnan(back(1).area)) << "nobody knows";
    const auto advected = setup_of(vortex + "[exact]\nadvected = true").exact;
    EXPECT_NEAR(signed_area(advected(1).outlines), 0.04 * 3.14159265358979, 1e-6);
    const std::string ring = "dsc_ring_" + std::to_string(::getpid()) + ".txt";
    const std::filesystem::path folder = testing::TempDir();
    std::ofstream(folder / ring) << "0.1 0.1\n0.5 0.1\n0.5 0.9\n0.1 0.9\n\n"
                                    "0.2 0.3\n0.4 0.3\n0.4 0.7\n0.2 0.7\n";
    const Scene with_hole =
        read_scene_text(options + "[flow]\nu = '1'\nv = '0'\n[[shape]]\nfile = '" + ring +
                            "'\n[exact]\nadvected = true",
                        folder / "s.toml")
            .scene;
    std::filesystem::remove(folder / ring);
    const auto holes = with_hole.prepare(with_hole.defaults).exact;
    EXPECT_NEAR(holes(0.1).area, 0.4 * 0.8 - 0.2 * 0.4, 1e-9);
    EXPECT_NEAR(signed_area(holes(0.1).outlines), 0.4 * 0.8 - 0.2 * 0.4, 1e-6);
}

// A ring of phase 1 around a disc of phase 2 with a hole, and another disc beside them.
TEST(SceneFileExact, OfSeveralPhasesIsThatOfTheMeasuredOne) {
    const std::string text =
        "[options]\nh = 0.05\ndt = 0.1\nperiod = 2\n" + swirl_flow + "[exact]\nback = true\n" +
        "[[shape]]\ncircle = { centre = [0.5, 0.5], radius = 0.3 }\n"
        "[[shape]]\nphase = 2\ncircle = { centre = [0.5, 0.5], radius = 0.2 }\n"
        "[[shape]]\nphase = 0\ncircle = { centre = [0.5, 0.5], radius = 0.1 }\n"
        "[[shape]]\nphase = 2\ncircle = { centre = [0.1, 0.1], radius = 0.08 }\n";
    const auto area_of = [&](const std::string& phase) {
        return setup_of(text + "[measure]\nphase = " + phase + "\n").exact(0).area / 3.14159265;
    };
    EXPECT_NEAR(area_of("1"), 0.09 - 0.04, 1e-3);
    EXPECT_NEAR(area_of("2"), 0.04 - 0.01 + 0.0064, 1e-3);
    EXPECT_THROW((void)area_of("3"), InputError);
    EXPECT_THROW((void)setup_of(text), InputError) << "which of them?";
}

// The triangle has two of its three points on the rectangle's border, the rhombus all four.
TEST(SceneFileExact, APolygonThatTouchesAnotherIsAHoleIfItIsInside) {
    const auto area_beside = [](const std::string& points) {
        return setup_of("[options]\nh = 0.05\ndt = 0.1\nperiod = 2\n" + swirl_flow +
                        "[exact]\nback = true\n[measure]\nphase = 1\n"
                        "[[shape]]\npoints = [[0.3, 0.3], [0.5, 0.3], [0.5, 0.7], [0.3, 0.7]]\n"
                        "[[shape]]\nphase = 2\npoints = " +
                        points + "\n")
            .exact(0)
            .area;
    };
    EXPECT_NEAR(area_beside("[[0.3, 0.65], [0.1, 0.5], [0.3, 0.35]]"), 0.2 * 0.4, 1e-12);
    EXPECT_NEAR(area_beside("[[0.4, 0.3], [0.5, 0.5], [0.4, 0.7], [0.3, 0.5]]"), 0.04, 1e-12);
}

TEST(SceneFileExact, IsMeasuredWhereTheExactShapeIsKnown) {
    const Scene scene = read("[options]\nh = 0.05\ndt = 0.05\nperiod = 1\n" + swirl_flow + disc +
                             "[exact]\nback = true")
                            .scene;
    const RunResult result = run_scene(scene, scene.defaults, {});
    EXPECT_LT(number(result.last, "sd_rel"), 0.01);
    ASSERT_TRUE(result.half);
    EXPECT_TRUE(std::isnan(number(*result.half, "sd_rel")));
}

TEST(SceneFileExact, BeginsAsASceneOfTheCatalogue) {
    const Scene swirl = find_scene("swirl");
    Parameters parameters = swirl.defaults;
    parameters.h = 0.05;
    parameters.steps = 3;
    const Scene scene = read("scene = 'swirl'\n[options]\nh = 0.05\nsteps = 3\n").scene;
    const RunResult result = run_scene(scene, scene.defaults, {});
    EXPECT_EQ(result.mesh_hash, run_scene(swirl, parameters, {}).mesh_hash);
    EXPECT_EQ(result.parameters.steps, 3) << "each way, as in the catalogue";
    EXPECT_TRUE(std::isfinite(number(result.last, "sd_rel")));

    const scenes::Setup other = setup_of("scene = 'swirl'\n" + disc);
    EXPECT_EQ(other.steps, 520);
    EXPECT_EQ(other.outlines.size(), 1U);
    EXPECT_FALSE(other.exact) << "that of another shape";
}

} // namespace
} // namespace dsc::scenes::scene_file_exact_test
