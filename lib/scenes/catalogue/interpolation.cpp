// SPDX-License-Identifier: MIT
// A value at the vertices (thesis, section 9.5): the interface sets the value and leaves it behind
// as it moves on; inserted vertices get it by linear interpolation.
//
// The thesis lets the value rise linearly from the first radius on. The field then has a kink,
// where linear interpolation is only of first order in any mesh. With a quadratic rise the slope is
// continuous, and the largest error is of second order.
#include "flows/exact.h"
#include "scenes/catalogue/families.h"
#include "shapes/shapes.h"

#include <algorithm>

namespace dsc::scenes {

namespace {

Setup grow_with_value(const Parameters& p) {
    static constexpr double first_radius = 0.15;
    constexpr double last_radius = 0.45;
    constexpr double way = last_radius - first_radius;
    static const Point<double> middle(0.5, 0.5);
    Setup setup = scheduled(p, way, std::min(way / 160, 0.3 * p.h));
    setup.outlines = {circle(middle, first_radius, p.h)};
    setup.flow = steady(Radial{middle, 1.0});
    setup.exact = [](double time) { return exact_circle(middle, first_radius + time); };
    setup.value = RadialValue{.centre = middle,
                              .first_radius = first_radius,
                              .last_radius = last_radius,
                              .power = p.ramp == Ramp::linear ? 1.0 : 2.0};
    return setup;
}

} // namespace

std::vector<Scene> interpolation_scenes() {
    return {{.name = "interpolation",
             .description = "a growing circle leaves a value behind at the vertices inside",
             .section = "9.5",
             .defaults = {.h = 0.0525, .dt = 0},
             .prepare = grow_with_value,
             .keys = common_keys({"ramp"})}};
}

} // namespace dsc::scenes
