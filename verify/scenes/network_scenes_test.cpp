// SPDX-License-Identifier: MIT
// Networks of curves that move by curvature, against theory: angles at junctions, the self-similar
// new edge between four sectors, the growth of grains, constant areas; and a drop that a pool
// absorbs.
#include "measures/junctions.h"
#include "measures/phases.h"
#include "scenes/catalogue/catalogue.h"
#include "scenes/run/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

namespace dsc::scenes::network_scenes_test {
namespace {

using std::numbers::pi;

std::uint64_t count(const RunResult& result, EventKind kind) {
    return static_cast<std::uint64_t>(std::ranges::count(result.events, kind, &Event::kind));
}

void expect_sound(const RunResult& result) {
    EXPECT_EQ(result.inverted, 0U);
    EXPECT_EQ(result.unreached, 0U);
    EXPECT_EQ(result.gave_up, "");
}

TEST(ThreePhases, BecomeALensOf120DegreesToSecondOrder) {
    std::vector<double> errors;
    for (const double h : {0.04, 0.02, 0.01}) {
        SCOPED_TRACE(h);
        const Scene& scene = find_scene("three-phases");
        Parameters parameters = scene.defaults;
        parameters.h = h;
        const RunResult result = run_scene(scene, parameters, {});
        expect_sound(result);
        EXPECT_EQ(result.junctions.count, 2U);
        EXPECT_LT(result.junctions.worst_deviation_deg, 0.3 * h / 0.02);
        EXPECT_NEAR(number(result.last, "area") / result.area_first, 1, 1e-9);
        errors.push_back(number(result.last, "sd_rel"));
    }
    EXPECT_LT(errors[1], 2e-3);
    EXPECT_GT(std::log2(errors[0] / errors[2]) / 2, 1.8) << errors[0] << ", " << errors[2];
}

// The new edge has the length c sqrt(t), with c for three angles of the rays. At 45 degrees edges
// along y and along x would have the same energy; the tie goes to the phases with the smaller
// numbers.
TEST(T1, OpensAnEdgeAsTheSelfSimilarSolution) {
    for (const auto& [degrees, c] :
         {std::pair{45.0, 0.77081}, std::pair{40.0, 1.08572}, std::pair{30.0, 1.87560}}) {
        SCOPED_TRACE(degrees);
        const Scene& scene = find_scene("t1");
        Parameters parameters = scene.defaults;
        parameters.angle = degrees;
        std::vector<Point<double>> ends;
        RunOptions options;
        options.observer = [&](int, const Complex<double>& complex) {
            ends.clear();
            for (const Junction& junction : measure_junctions(complex)) {
                ends.push_back(complex.position(junction.vertex));
            }
        };
        const RunResult result = run_scene(scene, parameters, options);
        expect_sound(result);
        EXPECT_EQ(count(result, EventKind::t1), 1U);
        ASSERT_EQ(ends.size(), 2U);
        EXPECT_LT(std::abs(ends[0].y() - ends[1].y()), 0.1 * parameters.h);
        const double length = (ends[0] - ends[1]).norm();
        EXPECT_GT(length, 10 * parameters.h);
        const double time = result.steps * result.parameters.dt;
        EXPECT_NEAR(length / std::sqrt(time), c, 0.02 * c);
        EXPECT_LT(result.junctions.worst_deviation_deg, 1);
    }
}

struct Grain {
    double area = 0;
    double sides = 0; ///< neighbours
};

// The phases that are one piece without a hole and away from the domain boundary.
std::map<Phase, Grain> grains_inside(const Complex<double>& complex) {
    const PhaseReport report = measure_phases(complex);
    std::map<Phase, Grain> grains;
    for (const PhaseFigures& one : report.phases) {
        if (one.boundary == 0 && one.components == 1 && one.holes == 0) {
            grains[one.phase].area = one.area;
        }
    }
    for (const PairFigures& pair : report.pairs) {
        for (const Phase phase : {pair.one, pair.other}) {
            if (const auto grain = grains.find(phase); grain != grains.end()) {
                ++grain->second.sides;
            }
        }
    }
    return grains;
}

// dA/dt = (n - 6) pi / 3 where interfaces meet in threes at 120 degrees (J. von Neumann, "Metal
// interfaces", 1952; W. W. Mullins, "Two-dimensional motion of idealized grain boundaries", 1956):
// of all grains of three to nine sides that keep their sides for a while and are not yet small.
TEST(Grains, GrowAsTheirSidesSay) {
    const Scene& scene = find_scene("grains");
    Parameters parameters = scene.defaults;
    parameters.h = 0.008;
    parameters.grains = 40; // of twenty edges across
    parameters.steps = 200;
    parameters.dt = 0.2 * parameters.h * parameters.h;
    constexpr int every = 10;
    constexpr int smooth = 50;  // steps after which the initial angles have no effect
    std::vector<double> errors; // relative; for six sides, to the rate for seven
    std::map<Phase, Grain> before;
    RunOptions options;
    options.observer = [&](int step, const Complex<double>& complex) {
        if (step % every != 0 || step < smooth) {
            return;
        }
        const std::map<Phase, Grain> now = grains_inside(complex);
        for (const auto& [phase, grain] : before) {
            const auto same = now.find(phase);
            if (same == now.end() || same->second.sides != grain.sides || grain.sides > 9 ||
                grain.area < std::pow(5 * parameters.h, 2)) {
                continue;
            }
            const double rate = (same->second.area - grain.area) / (every * parameters.dt);
            const double by_law = (grain.sides - 6) * pi / 3;
            errors.push_back(std::abs(rate - by_law) / std::max(std::abs(by_law), pi / 3));
        }
        before = now;
    };
    const RunResult result = run_scene(scene, parameters, options);
    expect_sound(result);
    std::ranges::sort(errors);
    ASSERT_GT(errors.size(), 200U);
    EXPECT_LT(errors[errors.size() / 2], 0.01);
    EXPECT_LT(errors[errors.size() * 9 / 10], 0.03);
}

TEST(Foam, KeepsTheAreasOfItsBubblesAndComesTo120Degrees) {
    const Scene& scene = find_scene("foam");
    Parameters parameters = scene.defaults;
    parameters.h = 0.016;
    std::map<Phase, double> first;
    std::map<Phase, double> last;
    RunOptions options;
    options.observer = [&](int step, const Complex<double>& complex) {
        last.clear();
        for (const PhaseFigures& bubble : measure_phases(complex).phases) {
            last[bubble.phase] = bubble.area;
        }
        first = step == 0 ? last : first;
    };
    const RunResult result = run_scene(scene, parameters, options);
    expect_sound(result);
    ASSERT_EQ(first.size(), last.size());
    EXPECT_GT(first.size(), 20U);
    for (const auto& [phase, area] : first) {
        EXPECT_NEAR(last[phase] / area, 1, 1e-8) << phase;
    }
    EXPECT_EQ(result.junctions.crossings, 0U);
    EXPECT_LT(result.junctions.worst_deviation_deg, 1);
}

} // namespace
} // namespace dsc::scenes::network_scenes_test
