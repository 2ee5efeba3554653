// SPDX-License-Identifier: MIT
// Steps of many edge lengths, and filaments thinner than an edge.
#include "cases.h"
#include "scene.h"
#include "watch.h"

#include "flows/exact.h"
#include "flows/velocity.h"
#include "measures/interface_outlines.h"
#include "shapes/shapes.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace dsc::hard {

namespace {

using scenes::Outline;

// The exact shapes need to be far better than the methods only; under the sanitizers they are dear.
constexpr int exact_steps = 512;
constexpr scenes::MarkerOptions exact_markers{.spacing = 3e-3, .deviation = 1e-6};

void note_steps(HardResult& result, double allowed) {
    expect(result, *result.error <= allowed,
           "error " + text(*result.error) + ", allowed " + text(allowed));
    result.happened = "arrives everywhere, in at most " + std::to_string(result.most_sub_steps) +
                      " sub-steps a step";
    expect_sound(result, Targets::reachable);
}

HardResult translation_case(double edges) {
    HardResult result;
    result.asked = "a circle goes 300 edge lengths along a domain, " + text(edges) + " a step";
    constexpr double h = 0.05;
    constexpr double way = 300 * h;
    const Rectangle domain{{0, 0}, {16, 1}};
    const std::vector<Outline> outlines{scenes::circle({0.5, 0.5}, 0.2, h)};
    auto scene = scene_of<double>(domain, outlines, h);
    Watch<double> watch(scene.complex, scene.options, {.domain = domain, .thorough_every = 50},
                        result);
    const double dt = edges * h;
    watch.run(scenes::Translation{{1, 0}}, 0, dt,
              static_cast<std::uint64_t>(std::lround(way / dt)));
    result.error =
        shape_error<double>(scene.complex, scenes::translated_shape(outlines, {way, 0}).outlines);
    result.error_is = shape_error_words;
    // Rigid: only rounding is left, of 3000 steps at most.
    note_steps(result, 1e-11);
    return result;
}

HardResult rotation_case(double edges) {
    HardResult result;
    result.asked = "a circle turns about the middle of the domain for 300 edge lengths, " +
                   text(edges) + " a step";
    constexpr double h = 0.04;
    const double outermost = 0.4;
    const std::vector<Outline> outlines{scenes::circle({0.5, 0.75}, 0.15, h)};
    auto scene = scene_of<double>(unit_square, outlines, h);
    Watch<double> watch(scene.complex, scene.options, {.domain = unit_square, .thorough_every = 50},
                        result);
    const double dt = edges * h / outermost; // in radians, at an angular speed of 1
    const auto steps = static_cast<std::uint64_t>(std::lround(300 / edges));
    watch.run(scenes::Rotation{{0.5, 0.5}, 1}, 0, dt, steps);
    result.error = shape_error<double>(
        scene.complex,
        scenes::rotated_shape(outlines, {0.5, 0.5}, static_cast<double>(steps) * dt).outlines);
    result.error_is = shape_error_words;
    // RK4 by 0.06 radians at a time: 0.06^5 / 120 each, 500 times, in units of the outermost
    // radius.
    note_steps(result, 5e-5);
    return result;
}

HardResult swirl_case(double edges) {
    HardResult result;
    result.asked = "the swirl for two units of time, 100 edge lengths, " + text(edges) + " a step";
    constexpr double h = 0.02;
    constexpr double end = 2.0;
    const std::vector<Outline> outlines{scenes::circle({0.5, 0.75}, 0.15, h)};
    auto scene = scene_of<double>(unit_square, outlines, h);
    Watch<double> watch(scene.complex, scene.options, {.domain = unit_square, .thorough_every = 20},
                        result);
    const double dt = edges * h;
    watch.run(scenes::Swirl{}, 0, dt, static_cast<std::uint64_t>(std::lround(end / dt)));
    result.error = shape_error<double>(
        scene.complex,
        scenes::advected_shape(scenes::circle_curve({0.5, 0.75}, 0.15),
                               scenes::steady(scenes::Swirl{}), end, exact_steps, exact_markers)
            .outlines);
    result.error_is = shape_error_words;
    note_steps(result, 0.02);
    return result;
}

HardResult vortex_case() {
    HardResult result;
    result.asked = "the single vortex with T = 16 at h = 0.02: at T/2 the filament is half an edge "
                   "wide";
    constexpr double h = 0.02;
    constexpr double period = 16;
    constexpr int steps = 1600;
    const scenes::Swirl swirl{1, period};
    const std::vector<Outline> outlines{scenes::circle({0.5, 0.75}, 0.15, h)};
    auto scene = scene_of<double>(unit_square, outlines, h);
    Watch<double> watch(scene.complex, scene.options, {.domain = unit_square, .thorough_every = 50},
                        result);
    constexpr double dt = period / steps;
    const auto curve = scenes::circle_curve({0.5, 0.75}, 0.15);
    bool going = watch.run(swirl, 0, dt, steps / 2);
    const auto half =
        scenes::advected_shape(curve, scenes::steady(swirl), period / 2, exact_steps, exact_markers)
            .outlines;
    const double at_half = shape_error<double>(scene.complex, half);
    const double width = 2 * curve.area / scenes::perimeter(half);
    going = going && watch.run(swirl, period / 2, dt, steps / 2);
    result.error = shape_error<double>(scene.complex, scenes::unmoved_shape(curve).outlines);
    result.error_is = shape_error_words;
    result.values = {{"error at T/2", at_half},
                     {"mean width of the filament at T/2, in edges", width / h}};
    result.happened = "stretched to " + text(width / h) + " edges and back, in one piece";
    expect(result, going, "the run ended early");
    expect(result, scenes::interface_outlines(scene.complex).size() == 1, "it is in pieces");
    expect(result, *result.error <= 0.02, "error " + text(*result.error) + ", allowed 0.02");
    expect_sound(result, Targets::reachable);
    return result;
}

HardResult slotted_disc_case() {
    HardResult result;
    result.asked = "the slotted disc in the swirl, one way for five units of time at h = 0.02";
    constexpr double h = 0.02;
    constexpr double dt = 0.01;
    constexpr int steps = 500;
    const std::vector<Outline> outlines{scenes::slotted_disc({}, h)};
    auto scene = scene_of<double>(unit_square, outlines, h);
    Watch<double> watch(scene.complex, scene.options, {.domain = unit_square, .thorough_every = 50},
                        result);
    const bool going = watch.run(scenes::Swirl{}, 0, dt, steps);
    const auto exact =
        scenes::advected_shape(scenes::slotted_disc_curve({}), scenes::steady(scenes::Swirl{}),
                               steps * dt, exact_steps, exact_markers);
    result.error = shape_error<double>(scene.complex, exact.outlines);
    result.error_is = shape_error_words;
    const double width = 2 * exact.area / scenes::perimeter(exact.outlines);
    result.values = {{"mean width of the filament, in edges", width / h}};
    result.happened = "drawn out to " + text(width / h) + " edges, in one piece";
    expect(result, going, "the run ended early");
    expect(result, scenes::interface_outlines(scene.complex).size() == 1, "it is in pieces");
    expect(result, *result.error <= 0.1, "error " + text(*result.error) + ", allowed 0.1");
    expect_sound(result, Targets::reachable);
    return result;
}

} // namespace

void append_long_steps(std::vector<HardCase>& cases) {
    for (const double edges : {0.1, 1.0, 5.0, 20.0, 100.0}) {
        const std::string name = "edges-per-step-" + text(edges);
        cases.push_back(
            {name + "-translation", false, [edges] { return translation_case(edges); }});
        cases.push_back({name + "-rotation", false, [edges] { return rotation_case(edges); }});
        cases.push_back({name + "-swirl", false, [edges] { return swirl_case(edges); }});
    }
    cases.push_back({"filament-vortex-16", false, vortex_case});
    cases.push_back({"filament-slotted-disc", false, slotted_disc_case});
}

} // namespace dsc::hard
