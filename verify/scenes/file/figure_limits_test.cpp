// SPDX-License-Identifier: MIT
// Limits of figures in a scene file.
#include "scenes/file/figure_limits.h"

#include "dsc/base/error.h"
#include "scenes/file/scene_file.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsc::scenes::figure_limits_test {
namespace {

/// Lines 1 to 4 of the scene files below.
const std::string few_steps = "[options]\nh = 0.1\ndt = 0.01\nsteps = 2\n";
const std::string advected = "[flow]\nu = '1'\nv = '0'\n[exact]\nadvected = true\n"
                             "[[shape]]\ncircle = { centre = [0.5, 0.5], radius = 0.2 }\n";

SceneFile read_figures(const std::string& text) { return read_scene_text(text, "s.toml"); }

TEST(FigureLimits, KeepsLimits) {
    const auto limits =
        read_figures(few_steps + advected +
                     "[limits]\nsd_rel_last = 1e-3\narea_ratio = { min = 0.9, max = 1.1 }\n"
                     "jaggedness_last.largest_excess_deg = 0\n")
            .limits;
    ASSERT_EQ(limits.size(), 3U);
    EXPECT_EQ(limits[0].figure, "area_ratio");
    EXPECT_EQ(limits[0].min, 0.9);
    EXPECT_NE(limits[0].where.find("s.toml:14: [limits] area_ratio"), std::string::npos)
        << limits[0].where;
    EXPECT_EQ(limits[1].figure, "jaggedness_last.largest_excess_deg");
    EXPECT_EQ(limits[2].max, 1e-3);
    EXPECT_TRUE(std::isinf(limits[2].min));
}

const std::string channel =
    "[domain]\noutline = { points = [[0, 0], [2, 0], [2, 1], [0, 1]], sides = ['wall', 'out', "
    "'wall', 'in'] }\n"
    "[fluid]\nwalls = { in = { inflow = '1' }, out = 'open' }\nphases = [{ phase = 0, density = "
    "1, viscosity = 1 }]\n";

TEST(FigureLimits, KnowThoseOfAFluid) {
    const auto limits = read_figures(few_steps + channel +
                                     "[limits]\nforce_x_wall_last = { min = 1, max = 2 }\n"
                                     "force_y_out_last = 1\nenergy_last = 3\n")
                            .limits;
    ASSERT_EQ(limits.size(), 3U);
    EXPECT_EQ(limits[1].figure, "force_x_wall_last");
    EXPECT_EQ(limits[1].min, 1);
    const std::string drop = "[[shape]]\nphase = 2\ncircle = { centre = [1, 0.5], radius = 0.2 }\n"
                             "[measure]\nphase = 2\n[limits]\ncircularity_min = 1\n";
    EXPECT_EQ(read_figures(few_steps + channel + drop).limits.size(), 1U);
}

TEST(FigureLimits, ErrorsNameFileLineKeyAndReason) {
    const std::vector<std::pair<std::string, std::vector<std::string>>> wrong{
        {few_steps + "[limits]\nsd_rel_last = nan\n", {"s.toml:6", "sd_rel_last", "nan"}},
        {few_steps + "[limits]\n", {"s.toml:5", "[limits]", "no limit", "sd_rel_last"}},
        {few_steps + "[limits]\ninverted = {}\n", {"s.toml:6", "inverted", "min, max"}},
        {few_steps + "[limits]\nmin_quality_last = { min = 1, max = 0 }\n", {"s.toml:6"}},
        {few_steps + "[limits]\nsd_rel_last = 1\n",
         {"s.toml:6", "[limits] sd_rel_last", "does not measure the figure", "exact shape"}},
        {few_steps + advected + "[limits]\nsd_rel_half = 1\n", {"s.toml:13", "half-way"}},
        {"[options]\nh = 0.1\ndt = 0.1\nperiod = 1\n[exact]\nback = true\n[limits]\nsd_half = 1\n",
         {"s.toml:8", "sd_half", "half-way"}},
        {few_steps + "[limits]\nattribute_error_last = 1\n", {"s.toml:6", "has no value"}},
        {few_steps + advected + "[measure]\nshape = false\n[limits]\nsd_last = 1\n",
         {"s.toml:15", "sd_last", "not known"}},
        {few_steps + channel + "[limits]\nforce_x_lid_last = 1\n",
         {"s.toml:11", "force_x_lid_last", "no side 'lid'", "only wall, out, in"}},
        {few_steps + channel + "[limits]\ncentre_last = 1\n", {"s.toml:11", "no shape", "phase 1"}},
        {few_steps + channel + "[measure]\nphase = 2\n[limits]\narea_drift_last = 1\n",
         {"s.toml:13", "no shape has the phase 2"}},
        {few_steps + channel + "[limits]\narea_ratio = 1\n", {"s.toml:11", "no shape"}},
        {few_steps + channel + "[limits]\namplitude_error = 1\n", {"s.toml:11", "wave"}},
        {few_steps + channel + "[limits]\nneck_last = 1\n", {"s.toml:11", "neck"}},
        {few_steps + channel + "[limits]\nforce_z_wall_last = 1\n",
         {"s.toml:11", "unknown key", "force_x_SIDE_last"}},
        {few_steps + "[limits]\nforce_x_wall_last = 1\n", {"s.toml:6", "has no fluid"}},
    };
    for (const auto& [text, words] : wrong) {
        SCOPED_TRACE(text);
        try {
            (void)read_figures(text);
            ADD_FAILURE() << "accepted";
        } catch (const InputError& error) {
            for (const std::string& word : words) {
                EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
                    << word << " is not in: " << error.what();
            }
        }
    }
}

} // namespace
} // namespace dsc::scenes::figure_limits_test
