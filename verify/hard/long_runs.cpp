// SPDX-License-Identifier: MIT
// Errors that only become visible after many steps.
#include "scene.h"
#include "watch.h"

#include "flows/exact.h"
#include "flows/velocity.h"
#include "shapes/shapes.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace dsc::hard {

namespace {

using scenes::Outline;

HardResult zalesak_case(int revolutions) {
    HardResult result;
    result.asked =
        "Zalesak's disc at h = 0.02, " + std::to_string(revolutions) + " revolutions of 628 steps";
    constexpr double h = 0.02;
    constexpr int steps = 628;
    const std::vector<Outline> outlines{scenes::slotted_disc({}, h)};
    auto scene = scene_of<double>(unit_square, outlines, h);
    Watch<double> watch(scene.complex, scene.options,
                        {.domain = unit_square, .thorough_every = 157}, result);
    const scenes::Rotation rotation{{0.5, 0.5}, 2 * std::numbers::pi};
    bool going = true;
    for (int turn = 1; turn <= revolutions && going; ++turn) {
        going = watch.run(rotation, turn - 1, 1.0 / steps, steps);
    }
    // RK4's own error: the angle lags by (2 pi / 628)^4 / 120 of the rotation.
    const double lag =
        std::pow(2 * std::numbers::pi / steps, 4) / 120 * 2 * std::numbers::pi * revolutions;
    const double cost = lag * 0.4 * scenes::perimeter(outlines) / scenes::signed_area(outlines);
    result.happened = "the error grows in proportion to time, as RK4's own lag does";
    note_error(result, shape_error<double>(scene.complex, outlines), 2 * cost + 1e-9);
    expect_sound(result, Targets::reachable);
    return result;
}

HardResult slow_case(std::uint64_t steps) {
    constexpr double h = 0.1;
    constexpr double way = 0.3;
    const std::vector<Outline> outlines{scenes::circle({0.35, 0.5}, 0.2, h)};
    const auto exact = scenes::translated_shape(outlines, {way, 0}).outlines;
    // Each step rounds a coordinate below 1 by at most half a unit in the last place, perhaps
    // always in the same direction.
    const double drift = static_cast<double>(steps) * 0.5 * std::numeric_limits<double>::epsilon();
    const double allowed = drift * scenes::perimeter(exact) / scenes::signed_area(exact) + 1e-13;
    HardResult result = advect({.asked = "a circle translated by three edge lengths in " +
                                         std::to_string(steps) + " steps",
                                .outlines = outlines,
                                .h = h,
                                .flow = scenes::Translation{{1, 0}},
                                .dt = way / static_cast<double>(steps),
                                .steps = steps,
                                .exact = exact,
                                .allowed = allowed,
                                .thorough_every = static_cast<int>(steps / 100)});
    result.happened = "the shape drifts by rounding alone: " + text(*result.error / allowed) +
                      " of what one rounding a step adds up to at most";
    return result;
}

} // namespace

void append_long_runs(std::vector<HardCase>& cases) {
    cases.push_back({"zalesak-10", [] { return zalesak_case(10); }});
    cases.push_back({"zalesak-100", [] { return zalesak_case(100); }, true});
    cases.push_back({"slow-20000", [] { return slow_case(20000); }});
    cases.push_back({"slow-1000000", [] { return slow_case(1000000); }, true});
}

const std::vector<HardCase>& all_cases() {
    static const std::vector<HardCase> cases = [] {
        std::vector<HardCase> list;
        append_coordinates(list);
        append_long_steps(list);
        append_contacts(list);
        append_degenerate(list);
        append_numbers(list);
        append_long_runs(list);
        return list;
    }();
    return cases;
}

} // namespace dsc::hard
