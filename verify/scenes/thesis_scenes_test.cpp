// SPDX-License-Identifier: MIT
// Properties of the thesis's scenes (sections 9.2, 9.5 and 9.8), as numbers: a circle stays round,
// a value is left behind, and the size of triangles depends on the phase or the position.
#include "scenes/catalogue/catalogue.h"
#include "scenes/file/scene_file.h"
#include "scenes/run/run.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/quality/measures.h"
#include "dsc/queries/phases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace dsc::scenes::thesis_scenes_test {
namespace {

const Point<double> centre_of_domain(0.5, 0.5);

Parameters with_settings(const Scene& scene, std::initializer_list<const char*> settings) {
    Parameters parameters = scene.defaults;
    for (const char* setting : settings) {
        apply_setting(parameters, scene.keys, setting);
    }
    return parameters;
}

RunResult run_with(const std::string& name, std::initializer_list<const char*> settings,
                   RunOptions options = {}) {
    const Scene& scene = find_scene(name);
    options.measure_shape = false;
    RunResult result = run_scene(scene, with_settings(scene, settings), options);
    EXPECT_TRUE(result.holds()) << name;
    return result;
}

// --- section 9.2 --------------------------------------------------------------------------------

// The largest distance of an interface vertex from the circle, over its radius.
double roundness_error(const std::string& name, std::initializer_list<const char*> settings) {
    double worst = 0;
    RunOptions options;
    options.observer = [&](int, const Complex<double>& complex) {
        double smallest = 1;
        double largest = 0;
        for (const Vertex v : vertices(complex)) {
            if (is_interface(complex, v)) {
                const double radius = (complex.position(v) - centre_of_domain).norm();
                smallest = std::min(smallest, radius);
                largest = std::max(largest, radius);
            }
        }
        worst = std::max(worst, (largest - smallest) / largest);
    };
    const RunResult result = run_with(name, settings, options);
    EXPECT_GT(result.operations.at("interface_splits"), 50U);
    return worst;
}

TEST(ScalingRound, StaysRoundToRounding) {
    const double own = roundness_error("scaling-round", {});
    const double cubic = roundness_error("scaling", {});
    const double linear = roundness_error("scaling", {"insertion=linear"});
    EXPECT_LT(own, 1e-13);
    EXPECT_GT(cubic, 1e-6);
    EXPECT_LT(cubic, 1e-4);
    EXPECT_GT(linear, 20 * cubic);
}

// --- section 9.5 --------------------------------------------------------------------------------

TEST(Interpolation, IsOfSecondOrderWithoutAKinkAndOfFirstWithOne) {
    const auto error = [](const char* h, const char* ramp, Strategy strategy) {
        RunOptions options;
        options.strategy = strategy;
        return run_with("interpolation", {h, ramp}, options).attribute_error;
    };
    for (const Strategy strategy : {Strategy::sequential, Strategy::cells}) {
        SCOPED_TRACE(to_string(strategy));
        const double coarse = error("h=0.0525", "ramp=quadratic", strategy);
        const double medium = error("h=0.02625", "ramp=quadratic", strategy);
        const double fine = error("h=0.013125", "ramp=quadratic", strategy);
        EXPECT_GT(std::log2(coarse / fine) / 2, 1.7) << coarse << ", " << medium << ", " << fine;
        EXPECT_GT(std::log2(medium / fine), 1.8) << medium << ", " << fine;
        EXPECT_LT(fine, 0.01);
    }
    const double coarse = error("h=0.0525", "ramp=linear", Strategy::sequential);
    const double fine = error("h=0.013125", "ramp=linear", Strategy::sequential);
    EXPECT_NEAR(std::log2(coarse / fine) / 2, 1, 0.4) << coarse << ", " << fine;
}

// --- section 9.8 --------------------------------------------------------------------------------

struct Areas {
    double inside = 0; ///< mean of the triangles
    double outside = 0;
};

Areas mean_areas(std::initializer_list<const char*> settings) {
    Areas areas;
    RunOptions options;
    options.observer = [&](int, const Complex<double>& complex) {
        std::size_t count = 0;
        for ([[maybe_unused]] const Triangle t : triangles(complex, 1)) {
            ++count;
        }
        const double all = phase_area(complex, 1);
        areas = {all / static_cast<double>(count),
                 (1 - all) / static_cast<double>(complex.triangle_count() - count)};
    };
    const Scene& scene = find_scene("quality-combinations");
    Parameters parameters = with_settings(scene, settings);
    parameters.dt = scene.prepare(parameters).dt;
    parameters.steps = 30; // as in the thesis
    options.measure_shape = false;
    EXPECT_TRUE(run_scene(scene, parameters, options).holds());
    return areas;
}

TEST(QualityCombinations, AreFineAndCoarseWhereTheyAreAskedToBe) {
    const Areas fine = mean_areas({"inside=fine", "outside=fine"});
    const Areas fine_inside = mean_areas({"inside=fine", "outside=coarse"});
    const Areas fine_outside = mean_areas({"inside=coarse", "outside=fine"});
    const Areas coarse = mean_areas({"inside=coarse", "outside=coarse"});
    EXPECT_GT(fine_inside.outside, 2.5 * fine_inside.inside);
    EXPECT_GT(fine_outside.inside, 2.5 * fine_outside.outside);
    EXPECT_NEAR(fine_inside.inside / fine.inside, 1, 0.2);
    EXPECT_NEAR(fine_outside.outside / fine.outside, 1, 0.2);
    EXPECT_GT(coarse.inside, 6 * fine.inside);
    EXPECT_GT(coarse.outside, 6 * fine.outside);
}

struct Sides {
    double left = 0;  ///< mean over the left quarter of the circle's width
    double right = 0; ///< mean over the right quarter
};

TEST(QualityVarying, IsCoarseAtTheLeftEndAndFineAtTheRightOneAtAllTimes) {
    RunOptions options;
    const Scene& scene = find_scene("quality-varying");
    const double dt = scene.prepare(scene.defaults).dt;
    options.observer = [&](int step, const Complex<double>& complex) {
        if (step == 0) {
            return; // at first, all interface edges have the edge length
        }
        const double radius = 0.1 + step * dt;
        const auto side_of = [&](double x) {
            return x < 0.5 - radius / 2 ? 0 : (x > 0.5 + radius / 2 ? 1 : 2);
        };
        std::array<double, 3> area_sum{};
        std::array<double, 3> length{};
        std::array<int, 3> triangle_count{};
        std::array<int, 3> edge_count{};
        for (const Triangle t : triangles(complex, 1)) {
            const auto v = complex.vertices_of(t);
            const double x =
                (complex.position(v[0]) + complex.position(v[1]) + complex.position(v[2])).x() / 3;
            const auto side = static_cast<std::size_t>(side_of(x));
            area_sum[side] += area(complex, t);
            ++triangle_count[side];
        }
        for (const Edge e : edges(complex)) {
            if (is_interface(complex, e)) {
                const auto [a, b] = complex.vertices_of(e);
                const Point<double> way = complex.position(b) - complex.position(a);
                const auto side =
                    static_cast<std::size_t>(side_of(complex.position(a).x() + way.x() / 2));
                length[side] += way.norm();
                ++edge_count[side];
            }
        }
        EXPECT_GT(area_sum[0] / triangle_count[0], 3 * area_sum[1] / triangle_count[1]) << step;
        EXPECT_GT(length[0] / edge_count[0], 1.7 * length[1] / edge_count[1]) << step;
    };
    const RunResult result = run_with("quality-varying", {}, options);
    EXPECT_EQ(result.steps, 100);
}

// --- the first frames ---------------------------------------------------------------------------

// The number of triangles at step 0 agrees with that of the thesis, for the thesis's edge lengths.
TEST(ThesisFrames, BeginWithAsManyTrianglesAsTheThesisWithinThreePerCent) {
    for (const char* name : {"translation", "translation-phase", "interpolation"}) {
        const RunResult result = run_with(name, {"h=0.0525", "dt=0.001", "steps=1"});
        EXPECT_NEAR(static_cast<double>(result.triangles_first) / 884, 1, 0.03) << name;
    }
    // As the example thesis-vortex.toml.
    const Scene vortex = read_scene_text("scene = \"vortex-square\"\n"
                                         "[options]\nh = 0.0525\nsteps = 1\n"
                                         "[domain]\nlow = [0, -0.03]\nhigh = [1, 1.02]\n",
                                         "vortex.toml")
                             .scene;
    const RunResult result = run_scene(vortex, vortex.defaults, {});
    EXPECT_NEAR(static_cast<double>(result.triangles_first) / 903, 1, 0.03);
}

} // namespace
} // namespace dsc::scenes::thesis_scenes_test
