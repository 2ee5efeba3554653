// SPDX-License-Identifier: MIT
// Growth (thesis, section 9.2): new vertices appear on the interface all the time.
#include "flows/exact.h"
#include "scenes/catalogue/catalogue.h"
#include "scenes/catalogue/families.h"
#include "shapes/shapes.h"

namespace dsc::scenes {

namespace {

Setup grow(const Parameters& p) {
    static constexpr double first_radius = 0.1;
    constexpr double last_radius = 0.4;
    static const Point<double> middle(0.5, 0.5);
    // The thesis's circles grow by less than an edge length per step.
    Setup setup = scheduled(p, last_radius - first_radius, 0.3 * p.h);
    setup.outlines = {circle(middle, first_radius, p.h)};
    setup.flow = steady(Radial{middle, 1.0});
    setup.exact = [](double time) { return exact_circle(middle, first_radius + time); };
    return setup;
}

// The thesis's own interpolator: vertices inserted on the interface lie on the circle.
Setup grow_round(const Parameters& p) {
    Setup setup = grow(p);
    setup.insertion = OnCircle{};
    return setup;
}

} // namespace

Scene scaling_scene(Scene about, double h) {
    about.defaults = {.h = h, .dt = 0, .interface = coarse_interface()};
    about.prepare = grow;
    return about;
}

std::vector<Scene> scaling_scenes() {
    Scene round = scaling_scene(
        {"scaling-round", "the same, and the application keeps the circle round", "9.2"}, 0.02);
    round.prepare = grow_round;
    return {scaling_scene({"scaling", "a circle grows to four times its radius", "9.2"}, 0.02),
            round};
}

} // namespace dsc::scenes
