// SPDX-License-Identifier: MIT
// The swirl (thesis, section 9.6, equation 11) and the single vortex that is common in the
// literature: shapes are stretched to filaments, and most come back.
#include "flows/exact.h"
#include "scenes/catalogue/families.h"
#include "shapes/shapes.h"

#include <cmath>

namespace dsc::scenes {

namespace {

constexpr double disc_radius = 0.15;

Point<double> centre() { return {0.5, 0.75}; }

Setup swirl_one_way(const Parameters& p) {
    Setup setup;
    setup.outlines = {slotted_disc({}, p.h)};
    setup.flow = steady(Swirl{});
    setup.dt = p.dt;
    setup.steps = p.steps;
    setup.exact = [flow = setup.flow, h = p.h](double t) {
        const ParametricCurve curve = slotted_disc_curve({});
        return advected_shape(curve, flow, t, markers_for(curve, h));
    };
    return setup;
}

Setup reversing_vortex(const Parameters& p) {
    Setup setup = scheduled(p, p.period, 0.01);
    setup.outlines = {circle(centre(), disc_radius, p.h)};
    setup.flow = steady(Swirl{1.0, p.period});
    if (setup.steps % 2 == 0 && std::abs(setup.steps * setup.dt - p.period) < 1e-9 * p.period) {
        setup.half_step = setup.steps / 2;
    }
    setup.exact = [flow = setup.flow, period = p.period, h = p.h](double t) {
        const ParametricCurve curve = circle_curve(centre(), disc_radius);
        return std::abs(t - period) < 1e-9 * period
                   ? unmoved_shape(curve)
                   : advected_shape(curve, flow, t, markers_for(curve, h));
    };
    return setup;
}

} // namespace

std::vector<Scene> swirl_scenes() {
    return {
        there_and_back_scene({"swirl", "a circle is swirled for `steps` steps, and back", "9.6"},
                             0.01, 0.01, 260, Swirl{}, circle_curve(centre(), disc_radius),
                             [](double h) { return circle(centre(), disc_radius, h); }),
        // The disc's legs are stretched until they are thinner than an edge: at the default end,
        // time 4, the mean width of the shape, 2 A / P, is 0.0067.
        {.name = "swirl-zalesak",
         .description = "Zalesak's slotted disc is swirled, one way",
         .section = "9.6",
         .defaults = {.h = 0.01, .dt = 0.01, .steps = 400},
         .prepare = swirl_one_way},
        {.name = "single-vortex",
         .description = "LeVeque's reversing vortex stretches a circle into a filament",
         .section = "anchors: section 3 of the field's literature",
         .defaults = {.h = 0.01, .dt = 0.01, .period = 8},
         .prepare = reversing_vortex,
         .keys = common_keys({"period"})},
    };
}

} // namespace dsc::scenes
