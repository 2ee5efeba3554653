// SPDX-License-Identifier: MIT
// The meaning of scene files, and the errors of invalid ones.
#include "scenes/file/scene_file.h"

#include "dsc/base/error.h"
#include "scenes/run/run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dsc::scenes::scene_file_test {
namespace {

/// Lines 1 to 4 of the scene files below.
const std::string options = "[options]\nh = 0.1\ndt = 0.01\nsteps = 2\n";
const std::string disc = "[[shape]]\ncircle = { centre = [0.5, 0.5], radius = 0.2 }\n";

SceneFile read(const std::string& text) { return read_scene_text(text, "s.toml"); }

scenes::Setup setup_of(const std::string& text) {
    const Scene scene = read(text).scene;
    return scene.prepare(scene.defaults);
}

RunResult run_text(const std::string& text) {
    const Scene scene = read(text).scene;
    return run_scene(scene, scene.defaults, {});
}

TEST(SceneFile, NeedsNoMoreThanOptions) {
    const SceneFile file = read(options);
    EXPECT_EQ(file.scene.name, "s");
    const RunResult result = run_scene(file.scene, file.scene.defaults, {});
    EXPECT_TRUE(result.holds());
    EXPECT_EQ(result.steps, 2);
}

TEST(SceneFile, TakesSettingsLikeAnyScene) {
    const Scene scene = read(options + disc).scene;
    Parameters parameters = scene.defaults;
    apply_setting(parameters, scene.keys, "steps=5");
    apply_setting(parameters, scene.keys, "h=0.05");
    apply_setting(parameters, scene.keys, "period=3");
    const scenes::Setup setup = scene.prepare(parameters);
    EXPECT_EQ(setup.steps, 5);
    EXPECT_GT(setup.outlines.at(0).size(), scene.prepare(scene.defaults).outlines.at(0).size());
}

TEST(SceneFile, FindsTheThirdOfDtStepsAndPeriod) {
    const scenes::Setup by_dt = setup_of("[options]\nh = 0.1\ndt = 0.25\nperiod = 2\n");
    EXPECT_EQ(by_dt.steps, 8);
    EXPECT_EQ(by_dt.half_step, 4);
    const scenes::Setup by_steps = setup_of("[options]\nh = 0.1\nsteps = 5\nperiod = 2\n");
    EXPECT_EQ(by_steps.dt, 0.4);
    EXPECT_FALSE(by_steps.half_step);
}

TEST(SceneFile, HasFlowsOneAfterTheOther) {
    const scenes::Setup setup =
        setup_of(options + "[[flow]]\nuntil = 1\nu = '2'\nv = '0'\n"
                           "[[flow]]\nuntil = 2\nu = '-x'\nv = 'k*period'\n"
                           "parameters = { k = 3 }\n[[flow]]\nu = 'h'\nv = '0'\n");
    ASSERT_EQ(setup.flow.size(), 3U);
    EXPECT_EQ(setup.flow[0].end, 1);
    EXPECT_TRUE(std::isinf(setup.flow[2].end));
    for (const auto& [leg, u] : {std::pair{0, 2.0}, {1, -4.0}, {2, 0.1}}) {
        Point<double> p(4, 0);
        setup.flow[static_cast<std::size_t>(leg)].velocity({&p, 1}, 0, {&p, 1});
        EXPECT_EQ(p.x(), u) << leg;
    }
}

TEST(SceneFile, HasPhasesAndCurves) {
    const scenes::Setup shapes =
        setup_of(options + "[[shape]]\nphase = 3\n"
                           "points = [[0.1, 0.1], [0.9, 0.1], [0.5, 0.9]]\n"
                           "[measure]\nphase = 3");
    EXPECT_EQ(shapes.phases, std::vector<Phase>{3});
    EXPECT_EQ(shapes.measured, 3U);
    const scenes::Setup curves =
        setup_of(options + "[domain]\nhigh = [2, 1]\nclamped = true\n"
                           "[[curve]]\nleft = 1\nright = 2\npoints = [[1, 0], [1, 1]]\n"
                           "[[curve]]\nleft = 3\nright = 1\ncircle = "
                           "{ centre = [0.5, 0.5], radius = 0.2 }\n[curvature]\nkeeps = [3]\n"
                           "pairs = [{ one = 1, other = 2, tension = 2 }]");
    ASSERT_EQ(curves.curves.size(), 2U);
    EXPECT_TRUE(curves.clamped);
    EXPECT_EQ(curves.domain.high.x(), 2);
    EXPECT_EQ(curves.curves[1].points.front(), curves.curves[1].points.back());
    ASSERT_TRUE(curves.curvature);
    EXPECT_EQ(curves.curvature->pairs.at(0).tension, 2);
    EXPECT_EQ(curves.curvature->keeps, std::vector<Phase>{3});
}

TEST(SceneFile, TellsWhatIsTooFineForTheMesh) {
    const std::string shapes = "[[shape]]\npoints = [[0.2, 0.2], [0.8, 0.2], [0.8, 0.201], "
                               "[0.8, 0.8], [0.2, 0.8]]\n"
                               "[[shape]]\nrectangle = { low = [0.9, 0.1], high = [1.2, 0.3] }\n"
                               "[[shape]]\nrectangle = { low = [0.4, 0.4], high = [0.41, 0.41] }\n";
    const RunResult result = run_text(options + shapes);
    EXPECT_EQ(result.input.thinned, 1U);
    EXPECT_EQ(result.input.dropped, 1U);
    EXPECT_EQ(result.input.clipped, 1U);
    const std::vector<std::string> told = sentences(result.input);
    ASSERT_EQ(told.size(), 3U);
    EXPECT_TRUE(told[0].starts_with("1 point was left out of 13, ")) << told[0];
    EXPECT_TRUE(told[1].starts_with("1 shape was left out as too small, ")) << told[1];
    EXPECT_TRUE(told[2].starts_with("1 outline was cut off ")) << told[2];
    EXPECT_THROW((void)run_text(options + "detail = 'keep'\n" + shapes), InputError);
    // Two halves with a gap stay separate, unless the tolerance for shared borders closes the gap.
    const std::string halves = "[[shape]]\nrectangle = { low = [0.2, 0.2], high = [0.5, 0.8] }\n"
                               "[[shape]]\nrectangle = { low = [0.505, 0.2], high = [0.8, 0.8] }\n";
    EXPECT_EQ(run_text(options + halves).phases.phases.back().components, 2U);
    EXPECT_EQ(
        run_text(options + "border_tolerance = 0.1\n" + halves).phases.phases.back().components,
        1U);
    const std::string strips = "[[shape]]\nrectangle = { low = [0.2, 0.0], high = [0.5, 1.0] }\n"
                               "[[shape]]\nrectangle = { low = [0.505, 0.0], high = [0.8, 1.0] }\n";
    EXPECT_EQ(run_text(options + "coverage = 'first'\n" + strips).phases.phases.back().components,
              1U);
    EXPECT_THROW((void)run_text(options + "coverage = 'whole'\n" + strips), InputError);
}

TEST(SceneFile, ShapesOfSeveralPhasesRun) {
    const RunResult result = run_text(
        options + "[flow]\nu = '0.1'\nv = '0'\n"
                  "[[shape]]\nphase = 2\nrectangle = { low = [0.1, 0.1], high = [0.4, 0.9] }\n"
                  "[[shape]]\nphase = 5\nellipse = { centre = [0.7, 0.5], radii = [0.1, 0.2] }");
    EXPECT_TRUE(result.holds());
    ASSERT_EQ(result.phases.phases.size(), 3U);
    EXPECT_EQ(result.phases.phases[2].phase, 5U);
    EXPECT_NEAR(result.phases.phases[1].area, 0.24, 1e-9);
}

// A ring-shaped domain, given by two outlines, clips a disc.
TEST(SceneFile, ADomainOfAnyShapeIsReadLikeAShape) {
    const std::string shape = "[[shape]]\ncircle = { centre = [0.9, 0.5], radius = 0.3 }\n";
    const std::string ring = "[[domain.outline]]\ncircle = { centre = [0.5, 0.5], radius = 0.5 }\n"
                             "[[domain.outline]]\ncircle = { centre = [0.5, 0.5], radius = 0.2 }\n";
    const RunResult result = run_text(options + "[flow]\nu = '0'\nv = '0'\n" + ring + shape);
    EXPECT_TRUE(result.holds());
    ASSERT_EQ(result.phases.phases.size(), 2U);
    EXPECT_NEAR(result.phases.phases[0].area + result.phases.phases[1].area,
                std::numbers::pi * 0.21, 6e-3);
    EXPECT_THROW((void)run_text("scene = 'grains'\n" + options + ring), InputError);
    EXPECT_THROW((void)run_text(options + "[domain]\nlow = [0, 0]\n" + ring), InputError);
}

// A channel with an inflow at one named side: what flows in flows out on the other one.
TEST(SceneFile, SidesOfTheDomainHaveNames) {
    const std::string domain =
        "[domain]\noutline = [{ points = [[0, 0], [2, 1], [1.5, 2], [-0.5, 1]], "
        "sides = ['wall', 'out', 'wall', 'in'] }, "
        "{ circle = { centre = [0.7, 1], radius = 0.2 }, sides = 'hole' }]\n";
    const std::string fluid = "[fluid]\nphases = [{ phase = 0 , density = 1, viscosity = 1 }]\n";
    const scenes::Setup setup =
        setup_of(options + domain + fluid +
                 "walls = { in = { inflow = '2 * t + x' }, out = 'open', wall = 'slip', "
                 "hole = { velocity = ['y', '-x'] } }\n");
    const FluidOptions& options_of_fluid = setup.fluid->options;
    ASSERT_EQ(options_of_fluid.domain_edges.size(), 4 + 13U);
    EXPECT_EQ(options_of_fluid.domain_edges[1].side, "out");
    EXPECT_EQ(options_of_fluid.domain_edges[1].from, Point<double>(2, 1));
    EXPECT_EQ(options_of_fluid.domain_edges[3].to, Point<double>(0, 0));
    EXPECT_EQ(options_of_fluid.domain_edges.back().side, "hole");
    const auto side = [&](const std::string& name) {
        return *std::ranges::find(options_of_fluid.sides, name, &FluidSide::name);
    };
    ASSERT_EQ(options_of_fluid.sides.size(), 4U);
    EXPECT_EQ(side("out").wall, Wall::open);
    EXPECT_EQ(side("wall").wall, Wall::slip);
    EXPECT_EQ(side("in").inflow({3, 9}, 0.5), 4);
    EXPECT_EQ(side("hole").velocity({3, 9}, 0), Point<double>(9, -3));
}

TEST(SceneFile, ScalesAndMovesWhatItReads) {
    const scenes::Setup setup =
        setup_of(options + "[[shape]]\npoints = [[0, 0], [1, 0], [1, 1]]\nscale = [0.5, -0.5]\n"
                           "move = [0.2, 0.8]");
    EXPECT_EQ(setup.outlines.at(0), (Outline{{0.2, 0.8}, {0.7, 0.8}, {0.7, 0.30000000000000004}}));
}

// The vertices on the left have no velocity: they are held and counted, as for any flow.
TEST(SceneFile, HoldsVerticesWhereAFormulaHasNoValue) {
    const RunResult result = run_text(options + "[flow]\nu = 'sqrt(x - 0.5)'\nv = '0'\n" + disc);
    EXPECT_GT(result.held, 0U);
    EXPECT_EQ(result.steps, 2);
    EXPECT_EQ(result.inverted, 0U);
}

struct Wrong {
    std::string text;
    std::vector<std::string> words; ///< of the sentence
};

TEST(SceneFile, ErrorsNameFileLineKeyValueAndWhatIsAllowed) {
    const std::string shape = options + "[[shape]]\n";
    const std::string flow = options + "[flow]\n";
    const std::vector<Wrong> wrong{
        {"[options\n", {"s.toml:1", "[options"}},
        {"a = 1\na = 2\n", {"s.toml:2", "a = 2"}},
        {"[option]\nh = 1\n", {"s.toml:1", "'option'", "options"}},
        {"[options]\nh = 0.1\nstpes = 3\n", {"s.toml:3", "[options]", "'stpes'", "steps"}},
        {"[options]\nh = 0.1\nintegrator = 'rk5'\n", {"s.toml:3", "integrator", "rk5", "rk4"}},
        {"[options]\nh = -1\n", {"s.toml:2", "[options] h", "-1", "1e-40 to 1e40"}},
        {"[options]\nh = nan\n", {"s.toml:2", "nan", "1e-40 to 1e40"}},
        {"[options]\nh = [1]\n", {"s.toml:2", "h", "a number"}},
        {"[options]\nh = 0.1\nsteps = 1.5\n", {"s.toml:3", "steps", "1.5", "whole number"}},
        {"[options]\nh = 0.1\nangle = 9\n", {"s.toml:3", "'angle'"}},
        {"[options]\ndt = 1\nsteps = 1\n", {"s.toml", "[options]", "no h"}},
        {"[options]\nh = 0.1\ndt = 1\n", {"s.toml", "dt alone", "steps"}},
        {"[options]\nh = 1e-5\ndt = 1\nsteps = 1\n[domain]\nhigh = [9, 9]\n", {"s.toml", "edges"}},
        {"[options]\nh = 2e-4\ndt = 1\nsteps = 1\n", {"s.toml", "20000000 triangles"}},
        {"options = 3\n", {"s.toml:1", "options", "3", "[options]"}},
        {"name = '../x'\n" + options, {"s.toml:1", "name", "../x", "letters"}},
        {"name = ''\n" + options, {"s.toml:1", "name"}},
        {"scene = 'swril'\n", {"s.toml:1", "swril", "swirl"}},
        {options + "[domain]\nlow = [0, 0]\nhigh = [0, 1]\n", {"s.toml:7", "[domain] high"}},
        {options + "[domain]\nlow = [0, nan]\n", {"s.toml:6", "[domain] low", "nan", "[x, y]"}},
        {options + "[domain]\nlow = [0, 0, 0]\n", {"s.toml:6", "[domain] low", "[x, y]"}},
        {options + "[fluid]\nwalls = { left = 'free' }\n", {"s.toml:6", "left", "free", "no-slip"}},
        {options + "[fluid]\nwalls = { inlet = 'slip' }\n", {"s.toml:6", "inlet", "bottom"}},
        {options + "[fluid]\nwalls = { left = { inflow = 'q' } }\n", {"s.toml:6", "inflow", "q"}},
        {options + "[fluid]\nwalls = { left = { velocity = ['x'] } }\n",
         {"s.toml:6", "velocity", "two formulas"}},
        {options + "[fluid]\nwalls = { left = { inflow = 'x', velocity = ['x', 'y'] } }\n",
         {"s.toml:6", "inflow and velocity"}},
        {options + "[domain]\nmesh = 'a.msh'\n", {"s.toml:6", "a.msh", "dsc.from_meshio"}},
        {options + "[domain]\noutline = { radius = 2 }\n", {"s.toml:6", "outline", "radius"}},
        {options + "[domain]\noutline = { points = [[0, 0], [1, 0], [0, 1]], sides = ['a', 'b'] }\n"
                   "[fluid]\nphases = [{ phase = 0, density = 1, viscosity = 1 }]\n",
         {"s.toml:6", "sides", "2 names, 3 edges"}},
        {options + "[domain]\noutline = { points = [[0, 0], [1, 0], [0, 1]], sides = 'a' }\n",
         {"s.toml:6", "sides", "no fluid", "[fluid]"}},
        {options + "[fluid]\nphases = [{ phase = 1, density = 1, viscosity = -2 }]\n",
         {"s.toml:6", "viscosity", "-2"}},
        {options + "[fluid]\nphases = [{ phase = 1, density = 1 }]\n", {"s.toml", "viscosity"}},
        {options + "[fluid]\nphases = [{ phase = 0, void = true, density = 1 }]\n",
         {"s.toml:6", "density", "void"}},
        {options + "[fluid]\ntensions = [{ one = 0, other = 1, tension = 1 }]\n",
         {"s.toml:5", "phase 0", "properties"}},
        {options + "[fluid]\n[flow]\nu = 'x'\nv = 'y'\n", {"s.toml", "flow", "fluid", "one"}},
        {shape, {"s.toml:5", "[shape]", "points, file, circle, ellipse"}},
        {shape + "circle = { centre = [0.5, 0.5] }\n", {"s.toml:6", "[shape.circle]", "radius"}},
        {shape + "circle = { centre = [0.5, 0.5], radius = 0 }\n", {"s.toml:6", "radius", "0"}},
        {shape + "circle = { centre = 5, radius = 1 }\n", {"s.toml:6", "centre", "5", "[x, y]"}},
        {shape + "cricle = 5\n", {"s.toml:6", "'cricle'", "circle"}},
        {shape + "points = [[0,0],[1,0],[1,1]]\nfile = 'a.txt'\n", {"s.toml:7", "points and file"}},
        {shape + "points = [[0,0],\n[1,0],\n[1]]\n", {"s.toml:8", "bad value 3", "[x, y]"}},
        {shape + "points = [[0,0],[1,0]]\n", {"s.toml:5", "2 points", "3 points or more"}},
        {shape + "rectangle = { low = [0,0], high = [0,1] }\n", {"s.toml:6", "high", "above"}},
        {shape + "ellipse = { centre = [0,0], radii = [1,0] }\n", {"s.toml:6", "radii", "above 0"}},
        {shape + "phase = -1\npoints = []\n", {"s.toml:6", "phase", "-1"}},
        {options + "shape = 3\n", {"s.toml:5", "unknown key", "'shape'"}},
        {options + "[sizes]\nedges_to_interface = 0\n", {"s.toml:6", "edges_to_interface", "0"}},
        {options + "[sizes]\nlongest = -1\n", {"s.toml:6", "longest", "-1"}},
        {options + "[sizes]\nsmallest = 1\n", {"s.toml:6", "unknown key", "'smallest'"}},
        {disc + "[[curve]]\npoints = [[0, 0], [1, 1]]\n" + options, {"s.toml:3", "curve"}},
        {flow, {"s.toml:5", "[flow]", "key u"}},
        {flow + "u = 'x +'\nv = '1'\n", {"s.toml:6", "[flow] u", "character 4", "a number"}},
        {flow + "u = 'x'\nv = 'z'\n", {"s.toml:7", "[flow] v", "character 1", "'z'", "x, y, t"}},
        {flow + "u = '''x\n+\n$\n\t!'''\nv = '1'\n", {"s.toml:6", "character 5", "'$  !'"}},
        {flow + "u = 'x'\n", {"s.toml:5", "[flow]", "key v"}},
        {flow + "u = 1\nv = '1'\n", {"s.toml:6", "[flow] u", "in quotes"}},
        {flow + "u = 'x'\nv = 'x'\nparameters = { sin = 1 }\n", {"s.toml:8", "sin", "bad name"}},
        {flow + "u = '1'\nswirl = {}\n", {"s.toml:7", "'swirl'", "parameters"}},
        {options + "[[flow]]\nu = '1'\nv = '1'\n[[flow]]\nu = '1'\nv = '1'\n",
         {"s.toml:5", "until"}},
        {options + "[[flow]]\nu = '1'\nv = '1'\nuntil = 2\n[[flow]]\nu = '1'\nv = '1'\nuntil = 1\n",
         {"s.toml:12", "until", "order"}},
        {flow + "u = '1'\nv = '1'\n[growth]\nspeed = 1\n", {"s.toml:8", "flow and growth"}},
        {options + "[curvature]\nkeeps = [0]\n", {"s.toml:6", "keeps", "whole numbers from 1"}},
        {options + "[curvature]\npairs = [{ one = 1 }]\n", {"s.toml:6", "other"}},
        {options + "[exact]\nback = true\n", {"s.toml:6", "back", "period"}},
        {options + "[exact]\n", {"s.toml:5", "[exact]", "back, advected"}},
        {options + "[limits]\nsd_rel = 1\n", {"s.toml:6", "'sd_rel'", "sd_rel_last"}},
        {options + "[limits]\nsd_rel_last = '1'\n", {"s.toml:6", "sd_rel_last", "a number"}},
        {options + "[measure]\nphase = 0\n", {"s.toml:6", "phase", "from 1"}},
        {"scene = 'grains'\n[options]\nh = 1e-4\n", {"s.toml", "grains", "20000"}},
    };
    for (const auto& [text, words] : wrong) {
        SCOPED_TRACE(text);
        try {
            (void)read(text);
            ADD_FAILURE() << "accepted";
        } catch (const InputError& error) {
            for (const std::string& word : words) {
                EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
                    << "'" << word << "' is not in: " << error.what();
            }
        }
    }
}

TEST(SceneFile, IsWhatHasASlashOrEndsInToml) {
    EXPECT_TRUE(is_scene_file("a.toml"));
    EXPECT_TRUE(is_scene_file("folder/a"));
    EXPECT_FALSE(is_scene_file("swirl"));
}

TEST(SceneFile, MayNameItsKeysAsInTheFirstRelease) {
    const auto text = [&](const std::string& key, const std::string& carried) {
        return carried + " = [1]\n" + options + key + " = 25\n" + disc +
               "[flow]\nu = '1'\nv = '0'\n[exact]\n" + carried + " = true\n";
    };
    testing::internal::CaptureStderr();
    const SceneFile old = read(text("corner", "carried"));
    const std::string warnings = testing::internal::GetCapturedStderr();
    EXPECT_EQ(old.scene.defaults.interface.feature_degrees, 25);
    EXPECT_EQ(old.scene.prepare(old.scene.defaults).advected, std::vector<Phase>{1});
    EXPECT_NE(warnings.find("s.toml:6: [options]: 'corner' is now called 'feature'"),
              std::string::npos)
        << warnings;
    EXPECT_NE(warnings.find("'carried' is now called 'advected'"), std::string::npos) << warnings;
    EXPECT_THROW(read(text("feature = 20\ncorner", "advected")), InputError);
}

} // namespace
} // namespace dsc::scenes::scene_file_test
