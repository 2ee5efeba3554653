// SPDX-License-Identifier: MIT
// Extreme numbers: denormals, NaN, infinities, and speeds too high for any number of sub-steps.
#include "scene.h"
#include "watch.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/initial/initial_complex.h"
#include "flows/exact.h"
#include "measures/interface_outlines.h"
#include "shapes/shapes.h"
#include "support/pointwise.h"

#include <cmath>
#include <limits>
#include <string>
#include <tuple>
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

const Point<double> right(1, 0);

Velocity<double> to_the_right() { return test::constant(right.x(), right.y()); }

std::vector<Outline> disc() { return {scenes::circle({0.4, 0.5}, 0.2, circle_h)}; }

struct Strange {
    std::string asked;
    Field field;
    std::uint64_t min_held = 0; ///< summed over steps
    bool all_stay = false;      ///< nothing may have moved at the end
    bool all_go = false;        ///< all vertices must have arrived
    std::string happened;
    bool held_block = false; ///< held vertices may block others, which are counted too
    int only_step = -1;      ///< the step in which the velocity is bad; `right` in all others
    std::uint64_t max_held = std::numeric_limits<std::uint64_t>::max();
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
        going = watch.step(is_asked ? test::pointwise(strange.field) : to_the_right(), i * dt, dt);
        moves += watch.last().operations.moves;
    }
    expect(result, result.held >= strange.min_held,
           std::to_string(result.held) + " held, at least " + std::to_string(strange.min_held) +
               " expected");
    expect(result, strange.min_held > 0 || result.held == 0, "vertices were held without a reason");
    expect(result, result.held <= strange.max_held, "held in more than that step");
    // Held vertices may block vertices that move.
    expect(result, strange.held_block || result.unreached == result.held,
           "vertices did not arrive for another reason than their velocity");
    const double way = strange.all_stay ? 0 : step_count * dt;
    if (strange.all_stay || strange.all_go) {
        const auto exact = scenes::translated_shape(disc(), {way, 0}).outlines;
        note_error(result, shape_error<double>(scene.complex, exact), 1e-12);
    } else {
        expect(result, moves > 0, "nothing moved");
    }
    result.happened = strange.happened;
    expect_sound(result, Targets::may_be_missed);
    return result;
}

// The velocity is NaN or infinite in the right part of the disc, in the whole disc...
Field bad_where(double bad, double from_x) {
    return [=](const Point<double>& p, double) {
        return p.x() > from_x ? Point<double>(bad, 0) : right;
    };
}

// ...or only in the inner stages of a Runge-Kutta step.
Field bad_when(double bad, double from, double to) {
    return [=](const Point<double>&, double time) {
        return time > from && time < to ? Point<double>(bad, 0) : right;
    };
}

HardResult denormal_coordinates() {
    const Rectangle domain{{-0.5, -0.5}, {0.5, 0.5}};
    Outline outline = scenes::circle({0, 0}, 0.2, circle_h);
    for (auto& p : outline) {
        for (int axis = 0; axis < 2; ++axis) {
            p[axis] = std::abs(p[axis]) < 1e-12 ? denormal : p[axis];
        }
    }
    const std::vector<Outline> outlines{outline};
    return advect({.asked = "an outline with denormal coordinates in a domain about the origin",
                   .outlines = outlines,
                   .h = circle_h,
                   .flow = test::pointwise(
                       [](const Point<double>& p, double) { return Point<double>(-p.y(), p.x()); }),
                   .dt = dt,
                   .steps = step_count,
                   .exact = scenes::rotated_shape(outlines, {0, 0}, step_count * dt).outlines,
                   .allowed = 1e-10,
                   .happened = "as with zeros",
                   .domain = domain,
                   .thorough_every = 1});
}

// One vertex is so fast that no number of sub-steps is enough.
HardResult too_fast(double speed) {
    HardResult result;
    result.asked = "a speed of " + text(speed) +
                   " in a part of the plane: a million sub-steps and "
                   "more";
    auto scene = scene_of<double>(unit_square, disc(), circle_h);
    Watch<double> watch(scene.complex, scene.options, {.domain = unit_square}, result);
    const auto field = test::pointwise([speed](const Point<double>& p, double) {
        return Point<double>(p.x() > 0.55 ? speed * p.x() : 1.0, 0);
    });
    watch.step(field, 0, dt);
    const StepReport& report = watch.last();
    expect(result, report.gave_up == GiveUp::too_many_sub_steps, "the step did not give up");
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
    expect_sound(result, Targets::too_far);
    return result;
}

} // namespace

void append_numbers(std::vector<HardCase>& cases) {
    const auto add = [&](const std::string& name, const Strange& strange) {
        cases.push_back({name, [strange] { return strange_case(strange); }});
    };
    const std::uint64_t all = disc().front().size();
    add("denormal-velocity",
        {.asked = "a velocity of the smallest denormal",
         .field = [](const Point<double>&, double) { return Point<double>(denormal, 0); },
         .all_stay = true,
         .happened = "nothing moves, and nothing else happens"});
    add("denormal-component",
        {.asked = "a velocity with a denormal component",
         .field = [](const Point<double>&, double) { return Point<double>(1, denormal); },
         .all_go = true,
         .happened = "moves as with a component of zero"});
    cases.push_back({"denormal-coordinates", denormal_coordinates});
    for (const auto& [name, says, bad] :
         {std::tuple{"nan", "NaN", nan}, std::tuple{"infinite", "infinite", infinity}}) {
        const std::string begin = std::string("a velocity that is ") + says;
        const std::string prefix = std::string(name) + '-';
        add(prefix + "some",
            {.asked = begin + " in a part of the plane, in all steps",
             .field = bad_where(-bad, 0.55),
             .min_held = step_count,
             .happened =
                 "vertices there are held and counted; the others go on until they meet one",
             .held_block = true});
        add(prefix + "all", {.asked = begin + " everywhere",
                             .field = bad_where(bad, -1),
                             .min_held = step_count * all,
                             .all_stay = true,
                             .happened = "all vertices are held and counted in every step"});
        add(prefix + "one-step",
            {.asked = begin + " everywhere in one step of twenty",
             .field = bad_where(bad, -1),
             .min_held = all,
             .happened = "all vertices are held in that step and go on in the next",
             .only_step = 3,
             .max_held = all});
        // No step begins or ends in this interval: only the middle stages evaluate the velocity
        // there.
        add(prefix + "in-stages",
            {.asked = begin + " in the middle stages of one Runge-Kutta step only",
             .field = bad_when(bad, 3.2 * dt, 3.8 * dt),
             .min_held = all,
             .happened = "all vertices are held in that step, as their targets are not finite"});
    }
    for (const double speed : {1e9, 1e150}) {
        cases.push_back({speed == 1e9 ? "too-fast-1e9" : "too-fast-1e150",
                         [speed] { return too_fast(speed); }});
    }
}

} // namespace dsc::hard
