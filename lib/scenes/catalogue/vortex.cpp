// SPDX-License-Identifier: MIT
// Twisting and untwisting (thesis, section 9.4).
#include "flows/exact.h"
#include "scenes/catalogue/families.h"
#include "shapes/shapes.h"

#include <cmath>

namespace dsc::scenes {

Scene there_and_back_scene(Scene about, double h, double dt, int steps, const Velocity& velocity,
                           const ParametricCurve& curve, std::function<Outline(double h)> outline) {
    about.defaults = {.h = h, .dt = dt, .steps = steps};
    about.counts_steps_each_way = true;
    about.prepare = [velocity, curve, outline = std::move(outline)](const Parameters& p) {
        Setup setup;
        setup.outlines = {outline(p.h)};
        setup.dt = p.dt;
        setup.steps = 2 * p.steps;
        setup.half_step = p.steps;
        const double half = p.steps * p.dt;
        setup.flow = there_and_back(velocity, half);
        setup.exact = [curve, flow = setup.flow, half, h = p.h](double t) {
            return std::abs(t - 2 * half) < 1e-9 * half
                       ? unmoved_shape(curve)
                       : advected_shape(curve, flow, t, markers_for(curve, h));
        };
        return setup;
    };
    return about;
}

std::vector<Scene> vortex_scenes() {
    const std::vector<Point<double>> square{{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}};
    return {there_and_back_scene({"vortex-square", "a square is twisted and untwisted", "9.4"},
                                 0.02, 0.002, 250, Vortex{{0.5, 0.5}, 1.0}, polygon_curve(square),
                                 [square](double h) { return polygon(square, h); })};
}

} // namespace dsc::scenes
