// SPDX-License-Identifier: MIT
// Numbers that are hardly numbers: denormals, NaN, infinities, and speeds beyond all sub-steps.
#include "cases.h"
#include "scene.h"
#include "watch.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/initial/initial_complex.h"
#include "flows/exact.h"
#include "measures/interface_outlines.h"
#include "shapes/shapes.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace dsc::hard {

namespace {

using scenes::Outline;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double denormal = std::numeric_limits<double>::denorm_min();
constexpr double circle_h = 0.05;
constexpr double dt = 0.01;
constexpr int step_count = 20;

using Field = std::function<Point<double>(const Point<double>&, double time)>;

Velocity<double> pointwise(const Field& field) {
    return [field](std::span<const Point<double>> positions, double time,
                   std::span<Point<double>> velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = field(positions[i], time);
        }
    };
}

const Point<double> right(1, 0);

Velocity<double> to_the_right() {
    return pointwise([](const Point<double>&, double) { return right; });
}

std::vector<Outline> disc() { return {scenes::circle({0.4, 0.5}, 0.2, circle_h)}; }

struct Strange {
    std::string asked;
    Field field;
    std::uint64_t least_held = 0; ///< summed over steps
    bool all_stay = false;        ///< nothing may have moved at the end
    bool all_go = false;          ///< everything must have gone the whole way
    std::string happened;
    bool held_block = false; ///< those who are held may stop others, which are counted too
    int only_step = -1;      ///< the field is asked in this step alone; `right` in all others
};

HardResult strange_case(const Strange& strange) {
    HardResult result;
    result.asked = strange.asked;
    auto scene = scene_of<double>(unit_square, disc(), circle_h);
    Watch<double> watch(scene.complex, scene.options, {.domain = unit_square}, result);
    std::uint64_t moves = 0;
    bool going = true;
    for (int i = 0; i < step_count && going; ++i) {
        const bool is_asked = strange.only_step < 0 || strange.only_step == i;
        going = watch.step(is_asked ? pointwise(strange.field) : to_the_right(), i * dt, dt);
        moves += watch.last().operations.moves;
    }
    expect(result, going, "the run ended early");
    expect(result, result.held >= strange.least_held,
           std::to_string(result.held) + " held, at least " + std::to_string(strange.least_held) +
               " expected");
    expect(result, strange.least_held > 0 || result.held == 0,
           "vertices were held without a reason");
    // Who is held may be in the way of those who go on.
    expect(result, strange.held_block || result.unreached == result.held,
           "vertices did not arrive for another reason than their velocity");
    const double way = strange.all_stay ? 0 : step_count * dt;
    if (strange.all_stay || strange.all_go) {
        result.error =
            shape_error<double>(scene.complex, scenes::translated_shape(disc(), {way, 0}).outlines);
        result.error_is = "symmetric difference to the exact shape, relative";
        expect(result, *result.error <= 1e-12, "error " + text(*result.error));
    } else {
        expect(result, moves > 0, "nothing moved");
    }
    result.values = {{"vertices moved, all steps", static_cast<double>(moves)}};
    result.happened = strange.happened;
    expect_sound(result, Targets::may_be_missed);
    return result;
}

// Not a number, or infinite, in the right part of the disc, in all of it...
Field bad_where(double bad, double from_x) {
    return [=](const Point<double>& p, double) {
        return p.x() > from_x ? Point<double>(bad, 0) : right;
    };
}

// ... or in the stages of a Runge-Kutta step that lie between two steps.
Field bad_when(double bad, double from, double to) {
    return [=](const Point<double>&, double time) {
        return time > from && time < to ? Point<double>(bad, 0) : right;
    };
}

HardResult some_nan() {
    return strange_case(
        {"a velocity that is NaN in a part of the plane, in all steps", bad_where(nan, 0.55),
         step_count, false, false,
         "vertices there are held and counted; the others go on until they meet one", true});
}
HardResult some_infinite() {
    return strange_case(
        {"a velocity that is infinite in a part of the plane, in all steps",
         bad_where(-infinity, 0.55), step_count, false, false,
         "vertices there are held and counted; the others go on until they meet one", true});
}
HardResult all_nan() {
    return strange_case({"a velocity that is NaN everywhere", bad_where(nan, -1),
                         step_count * disc().front().size(), true, false,
                         "all vertices are held and counted in every step"});
}
HardResult all_infinite() {
    return strange_case({"a velocity that is infinite everywhere", bad_where(infinity, -1),
                         step_count * disc().front().size(), true, false,
                         "all vertices are held and counted in every step"});
}

HardResult one_step_nan() {
    HardResult result =
        strange_case({.asked = "a velocity that is NaN everywhere in one step of twenty",
                      .field = bad_where(nan, -1),
                      .least_held = disc().front().size(),
                      .happened = "all vertices are held in that step and go on in the next",
                      .only_step = 3});
    expect(result, result.held == disc().front().size(), "held in more than that step");
    return result;
}

HardResult stage_nan() {
    // No step begins or ends in there: only the middle stages see it.
    return strange_case({"a velocity that is NaN in the middle stages of one Runge-Kutta step only",
                         bad_when(nan, 3.2 * dt, 3.8 * dt), disc().front().size(), false, false,
                         "all vertices are held in that step, as their targets are not finite"});
}

HardResult stage_infinite() {
    return strange_case(
        {"a velocity that is infinite in the middle stages of one Runge-Kutta step only",
         bad_when(infinity, 3.2 * dt, 3.8 * dt), disc().front().size(), false, false,
         "all vertices are held in that step, as their targets are not finite"});
}

HardResult denormal_velocity() {
    return strange_case({"a velocity of the smallest denormal",
                         [](const Point<double>&, double) { return Point<double>(denormal, 0); }, 0,
                         true, false, "nothing moves, and nothing else happens"});
}

HardResult denormal_component() {
    return strange_case({"a velocity with a denormal component",
                         [](const Point<double>&, double) { return Point<double>(1, denormal); }, 0,
                         false, true, "moves as with a component of zero"});
}

HardResult denormal_coordinates() {
    HardResult result;
    result.asked = "an outline with denormal coordinates in a domain about the origin; a domain of "
                   "denormal size";
    const Rectangle domain{{-0.5, -0.5}, {0.5, 0.5}};
    Outline outline = scenes::circle({0, 0}, 0.2, circle_h);
    for (auto& p : outline) {
        for (int axis = 0; axis < 2; ++axis) {
            p[axis] = std::abs(p[axis]) < 1e-12 ? denormal : p[axis];
        }
    }
    const std::vector<Outline> outlines{outline};
    auto scene = scene_of<double>(domain, outlines, circle_h);
    Watch<double> watch(scene.complex, scene.options, {.domain = domain}, result);
    const bool going = watch.run(
        pointwise([](const Point<double>& p, double) { return Point<double>(-p.y(), p.x()); }), 0,
        dt, step_count);
    result.error = shape_error<double>(
        scene.complex, scenes::rotated_shape(outlines, {0, 0}, step_count * dt).outlines);
    result.error_is = "symmetric difference to the exact shape, relative";
    expect(result, going, "the run ended early");
    expect(result, *result.error <= 1e-10, "error " + text(*result.error));
    const double tiny = 1e-310;
    expect_input_error(
        result,
        [&] {
            (void)scene_of<double>({{0, 0}, {tiny, tiny}}, std::vector<Outline>{}, tiny / 10);
        },
        "out of range");
    expect_input_error(
        result,
        [&] {
            (void)choose_frame({0, 0}, {tiny, tiny});
        },
        "1e-290");
    result.happened = "as with zeros; a domain of that size is refused by a typed error";
    expect_sound(result, Targets::reachable);
    return result;
}

// One vertex asks for more than any number of sub-steps.
HardResult too_fast(double speed) {
    HardResult result;
    result.asked = "a speed of " + text(speed) +
                   " in a part of the plane: a million sub-steps and "
                   "more";
    auto scene = scene_of<double>(unit_square, disc(), circle_h);
    Watch<double> watch(scene.complex, scene.options, {.domain = unit_square}, result);
    const auto field = pointwise([speed](const Point<double>& p, double) {
        return Point<double>(p.x() > 0.55 ? speed * p.x() : 1.0, 0);
    });
    const bool going = watch.step(field, 0, dt);
    const StepReport& report = watch.last();
    expect(result, !going && report.gave_up == GiveUp::too_many_sub_steps,
           "the step did not give up");
    expect(result, report.unreached == report.interface_vertices,
           "not every vertex was counted as left behind");
    double rightmost = 0;
    for (const auto& outline : scenes::interface_outlines(scene.complex)) {
        for (const auto& p : outline) {
            rightmost = std::max(rightmost, p.x());
        }
    }
    const bool is_named = scene.complex.is_alive(report.where);
    expect(result, is_named && scene.complex.position(report.where).x() == rightmost,
           "the place is not that of the fastest vertex");
    expect(result, std::abs(report.speed / (speed * rightmost) - 1) < 1e-12,
           "the speed is not that of the fastest vertex");
    result.happened = "gives up before the first sub-step and says where: all vertices counted";
    expect_sound(result, Targets::may_be_missed);
    return result;
}

} // namespace

void append_numbers(std::vector<HardCase>& cases) {
    cases.push_back({"denormal-velocity", false, denormal_velocity});
    cases.push_back({"denormal-component", false, denormal_component});
    cases.push_back({"denormal-coordinates", false, denormal_coordinates});
    cases.push_back({"nan-some", false, some_nan});
    cases.push_back({"nan-all", false, all_nan});
    cases.push_back({"nan-one-step", false, one_step_nan});
    cases.push_back({"nan-in-stages", false, stage_nan});
    cases.push_back({"infinite-some", false, some_infinite});
    cases.push_back({"infinite-all", false, all_infinite});
    cases.push_back({"infinite-in-stages", false, stage_infinite});
    cases.push_back({"too-fast-1e9", false, [] { return too_fast(1e9); }});
    cases.push_back({"too-fast-1e150", false, [] { return too_fast(1e150); }});
}

} // namespace dsc::hard
