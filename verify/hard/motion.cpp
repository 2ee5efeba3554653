// SPDX-License-Identifier: MIT
// Steps of many edge lengths, and filaments thinner than an edge.
#include "scene.h"
#include "watch.h"

#include "flows/exact.h"
#include "flows/velocity.h"
#include "measures/interface_outlines.h"
#include "shapes/shapes.h"

#include <cmath>
#include <string>
#include <vector>

namespace dsc::hard {

namespace {

using scenes::Outline;

// The exact shapes only need to be much more accurate than the methods; under the sanitizers more
// markers take too long.
constexpr scenes::MarkerOptions exact_markers{.spacing = 3e-3, .deviation = 1e-6};

// Advects a shape in long or short steps; no step is too long, because sub-steps divide it.
HardResult in_steps(const Advected& advected) {
    HardResult result = advect(advected);
    result.happened = "arrives everywhere, in at most " + std::to_string(result.max_sub_steps) +
                      " sub-steps a step";
    return result;
}

HardResult translation_case(double edges) {
    constexpr double h = 0.05;
    constexpr double way = 300 * h;
    const std::vector<Outline> outlines{scenes::circle({0.5, 0.5}, 0.2, h)};
    return in_steps(
        {.asked = "a circle goes 300 edge lengths along a domain, " + text(edges) + " a step",
         .outlines = outlines,
         .h = h,
         .flow = scenes::Translation{{1, 0}},
         .dt = edges * h,
         .steps = static_cast<std::uint64_t>(std::lround(way / (edges * h))),
         .exact = scenes::translated_shape(outlines, {way, 0}).outlines,
         .allowed = 1e-11, // a rigid motion: only the rounding errors of at most 3000 steps
         .domain = {{0, 0}, {16, 1}}});
}

HardResult rotation_case(double edges) {
    constexpr double h = 0.04;
    const double outermost = 0.4;
    const double dt = edges * h / outermost; // in radians, at an angular speed of 1
    const auto steps = static_cast<std::uint64_t>(std::lround(300 / edges));
    const std::vector<Outline> outlines{scenes::circle({0.5, 0.75}, 0.15, h)};
    const double angle = static_cast<double>(steps) * dt;
    return in_steps(
        {.asked = "a circle turns about the middle of the domain for 300 edge lengths, " +
                  text(edges) + " a step",
         .outlines = outlines,
         .h = h,
         .flow = scenes::Rotation{{0.5, 0.5}, 1},
         .dt = dt,
         .steps = steps,
         .exact = scenes::rotated_shape(outlines, {0.5, 0.5}, angle).outlines,
         // RK4's error: 500 steps of 0.06 radians with 0.06^5 / 120 each, times the outermost
         // radius.
         .allowed = 5e-5});
}

// This swirl does not return, so the exact shape is computed by markers.
std::vector<Outline> swirled(const scenes::ParametricCurve& curve, double end) {
    return scenes::advected_shape(curve, scenes::steady(scenes::Swirl{}), end, exact_markers)
        .outlines;
}

HardResult swirl_case(double edges) {
    constexpr double h = 0.02;
    constexpr double end = 2.0;
    return in_steps(
        {.asked = "the swirl for two units of time, 100 edge lengths, " + text(edges) + " a step",
         .outlines = {scenes::circle({0.5, 0.75}, 0.15, h)},
         .h = h,
         .flow = scenes::Swirl{},
         .dt = edges * h,
         .steps = static_cast<std::uint64_t>(std::lround(end / (edges * h))),
         .exact = swirled(scenes::circle_curve({0.5, 0.75}, 0.15), end),
         .allowed = 0.02,
         .thorough_every = 20});
}

HardResult slotted_disc_case() {
    constexpr double h = 0.02;
    constexpr double dt = 0.01;
    constexpr int steps = 500;
    const std::vector<Outline> exact = swirled(scenes::slotted_disc_curve({}), steps * dt);
    const double width = 2 * scenes::signed_area(exact) / scenes::perimeter(exact);
    return advect(
        {.asked = "the slotted disc in the swirl, one way for five units of time at h = 0.02",
         .outlines = {scenes::slotted_disc({}, h)},
         .h = h,
         .flow = scenes::Swirl{},
         .dt = dt,
         .steps = steps,
         .exact = exact,
         .allowed = 0.1,
         .happened = "stretched to a width of " + text(width / h) + " edges, in one piece"},
        [](const Complex<double>& complex, HardResult& result) {
            expect(result, scenes::interface_outlines(complex).size() == 1, "it is in pieces");
        });
}

} // namespace

void append_long_steps(std::vector<HardCase>& cases) {
    for (const double edges : {0.1, 1.0, 5.0, 20.0, 100.0}) {
        const std::string name = "edges-per-step-" + text(edges);
        cases.push_back({name + "-translation", [edges] { return translation_case(edges); }});
        cases.push_back({name + "-rotation", [edges] { return rotation_case(edges); }});
        cases.push_back({name + "-swirl", [edges] { return swirl_case(edges); }});
    }
    cases.push_back({"filament-slotted-disc", slotted_disc_case});
}

} // namespace dsc::hard
