// SPDX-License-Identifier: MIT
#include "dsc/base/error.h"
#include "scenes/scene.h"
#include "shapes/shapes.h"

#include <cmath>
#include <numbers>

namespace dsc::scenes {

namespace {

constexpr double pi = std::numbers::pi;
const Point<double> middle(0.5, 0.5);

using Keys = std::vector<std::string>;
const Keys common_keys{"h",          "dt",      "steps",   "integrator", "tolerance", "insertion",
                       "coarsening", "reading", "longest", "shortest",   "deviation", "turn",
                       "gap",        "grading", "finest",  "real",       "seed"};

Keys with(Keys keys, const std::string& more) {
    keys.push_back(more);
    return keys;
}

// dt and steps: what is given stays; what is not follows from the scene's duration.
struct Schedule {
    double dt;
    int steps;
};

Schedule schedule(const Parameters& p, double duration, double default_dt) {
    Schedule s{p.dt > 0 ? p.dt : (p.steps > 0 ? duration / p.steps : default_dt), p.steps};
    if (s.steps == 0) {
        const double count = std::max(1.0, std::round(duration / s.dt));
        if (count > 1e8) {
            throw InputError("time step too small", "--set dt", std::to_string(s.dt),
                             "at most 100000000 steps for a duration of " +
                                 std::to_string(duration));
        }
        s.steps = static_cast<int>(count);
        if (p.dt <= 0) {
            s.dt = duration / s.steps; // whole steps end where the scene ends
        }
    }
    return s;
}

Scene scaling(std::string name, std::string description, std::string section, double h) {
    Parameters defaults;
    defaults.h = h;
    defaults.dt = 0;
    defaults.interface = coarse_interface();
    return {std::move(name),
            std::move(description),
            std::move(section),
            common_keys,
            defaults,
            [](const Parameters& p) {
                static constexpr double first_radius = 0.1;
                constexpr double last_radius = 0.4;
                // The thesis's circles grow by less than an edge a step.
                const Schedule s = schedule(p, last_radius - first_radius, 0.3 * p.h);
                Setup setup;
                setup.outlines = {circle(middle, first_radius, p.h)};
                setup.flow = steady(Radial{middle, 1.0});
                setup.dt = s.dt;
                setup.steps = s.steps;
                setup.exact = [](double time) { return exact_circle(middle, first_radius + time); };
                return setup;
            }};
}

Scene translation() {
    Parameters defaults;
    defaults.h = 0.051;
    defaults.dt = 0;
    return {"translation",
            "a circle goes right, down, and back at an angle",
            "9.1",
            common_keys,
            defaults,
            [](const Parameters& p) {
                static constexpr double leg = 0.4;
                const Schedule s = schedule(p, 3 * leg, 3 * leg / 360);
                Setup setup;
                setup.outlines = {circle({0.3, 0.7}, 0.15, p.h)};
                setup.flow = {{leg, Translation{{1, 0}}},
                              {2 * leg, Translation{{0, -1}}},
                              {3 * leg, Translation{{-1, 1}}}};
                setup.dt = s.dt;
                setup.steps = s.steps;
                setup.exact = [first = setup.outlines](double t) {
                    const double a = std::min(t, leg);
                    const double b = std::clamp(t - leg, 0.0, leg);
                    const double c = std::max(t - 2 * leg, 0.0);
                    return translated_shape(first, {a - c, c - b});
                };
                return setup;
            }};
}

// A rigid turn about the middle of the domain, once around.
Scene rotation(std::string name, std::string description, std::string section, double h, int steps,
               std::function<std::vector<Outline>(double h)> outlines) {
    Parameters defaults;
    defaults.h = h;
    defaults.dt = 0;
    return {std::move(name),
            std::move(description),
            std::move(section),
            common_keys,
            defaults,
            [outlines = std::move(outlines), steps](const Parameters& p) {
                const Schedule s = schedule(p, 1.0, 1.0 / steps);
                Setup setup;
                setup.outlines = outlines(p.h);
                setup.flow = steady(Rotation{middle, 2 * pi});
                setup.dt = s.dt;
                setup.steps = s.steps;
                setup.exact = [first = setup.outlines](double t) {
                    return rotated_shape(first, middle, 2 * pi * t);
                };
                return setup;
            }};
}

// A curve that a flow takes away and back: `steps` is the number of steps each way.
Scene there_and_back_scene(std::string name, std::string description, std::string section, double h,
                           double dt, int steps_each_way, const Velocity& velocity,
                           const Curve& curve, std::function<Outline(double h)> outline) {
    Parameters defaults;
    defaults.h = h;
    defaults.dt = dt;
    defaults.steps = steps_each_way;
    return {std::move(name),
            std::move(description),
            std::move(section),
            common_keys,
            defaults,
            [velocity, curve, outline = std::move(outline)](const Parameters& p) {
                Setup setup;
                setup.outlines = {outline(p.h)};
                setup.dt = p.dt;
                setup.steps = 2 * p.steps;
                setup.half_step = p.steps;
                const double half = p.steps * p.dt;
                setup.flow = there_and_back(velocity, half);
                setup.exact = [curve, flow = setup.flow, half](double t) {
                    return std::abs(t - 2 * half) < 1e-9 * half ? unmoved_shape(curve)
                                                                : advected_shape(curve, flow, t);
                };
                return setup;
            }};
}

// The disc's legs are drawn out until they are thinner than an edge: at the default end, time 4,
// the mean width of the shape, 2 A / P, is 0.0067.
Scene swirl_zalesak() {
    Parameters defaults;
    defaults.h = 0.01;
    defaults.dt = 0.01;
    defaults.steps = 400;
    return {"swirl-zalesak",
            "Zalesak's slotted disc is swirled, one way",
            "9.6",
            common_keys,
            defaults,
            [](const Parameters& p) {
                Setup setup;
                setup.outlines = {slotted_disc({}, p.h)};
                setup.flow = steady(Swirl{});
                setup.dt = p.dt;
                setup.steps = p.steps;
                setup.exact = [flow = setup.flow](double t) {
                    return advected_shape(slotted_disc_curve({}), flow, t);
                };
                return setup;
            }};
}

Scene single_vortex() {
    Parameters defaults;
    defaults.h = 0.01;
    defaults.dt = 0.01;
    defaults.period = 8;
    return {"single-vortex",
            "LeVeque's reversing vortex stretches a circle into a filament",
            "anchors: section 3 of the field's literature",
            with(common_keys, "period"),
            defaults,
            [](const Parameters& p) {
                const Point<double> centre(0.5, 0.75);
                const Schedule s = schedule(p, p.period, 0.01);
                Setup setup;
                setup.outlines = {circle(centre, 0.15, p.h)};
                setup.flow = steady(Swirl{1.0, p.period});
                setup.dt = s.dt;
                setup.steps = s.steps;
                if (s.steps % 2 == 0 && std::abs(s.steps * s.dt - p.period) < 1e-9 * p.period) {
                    setup.half_step = s.steps / 2;
                }
                setup.exact = [flow = setup.flow, centre, period = p.period](double t) {
                    const Curve curve = circle_curve(centre, 0.15);
                    return std::abs(t - period) < 1e-9 * period ? unmoved_shape(curve)
                                                                : advected_shape(curve, flow, t);
                };
                return setup;
            }};
}

Scene four_circles_scene() {
    Parameters defaults;
    defaults.h = 0.01;
    defaults.dt = 0;
    defaults.interface = coarse_interface();
    return {"speedup-four-circles",
            "four circles side by side go up, each within its own slab",
            "9.7",
            common_keys,
            defaults,
            [](const Parameters& p) {
                constexpr double shift = 0.6;
                const Schedule s =
                    schedule(p, shift, shift / std::max(120.0, std::round(shift / (0.5 * p.h))));
                Setup setup;
                for (int i = 0; i < 4; ++i) {
                    setup.outlines.push_back(circle({(2 * i + 1) / 8.0, 0.2}, 0.08, p.h));
                }
                setup.flow = steady(Translation{{0, 1}});
                setup.dt = s.dt;
                setup.steps = s.steps;
                setup.exact = [first = setup.outlines](double t) {
                    return translated_shape(first, {0, t});
                };
                return setup;
            }};
}

std::vector<Scene> make_catalogue() {
    const Point<double> high(0.5, 0.75);
    const std::vector<Point<double>> square{{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}};
    return {
        translation(),
        scaling("scaling", "a circle grows to four times its radius", "9.2", 0.02),
        rotation("rotation-rectangle", "a rectangle turns once about its centre", "9.3", 0.02, 360,
                 [](double h) {
                     return std::vector<Outline>{rectangle({0.25, 0.4}, {0.75, 0.6}, h)};
                 }),
        rotation("rotation-crescent", "a crescent turns once about the origin", "9.3", 0.02, 360,
                 [](double h) {
                     return std::vector<Outline>{crescent({middle, 0.3, {0.68, 0.5}, 0.24}, h)};
                 }),
        there_and_back_scene("vortex-square", "a square is twisted and untwisted", "9.4", 0.02,
                             0.002, 250, Vortex{middle, 1.0}, polygon_curve(square),
                             [square](double h) { return polygon(square, h); }),
        rotation("zalesak", "Zalesak's slotted disc, one revolution", "9.6", 0.01, 628,
                 [](double h) { return std::vector<Outline>{slotted_disc({}, h)}; }),
        there_and_back_scene("swirl", "a circle is swirled for `steps` steps, and back", "9.6",
                             0.01, 0.01, 260, Swirl{}, circle_curve(high, 0.15),
                             [high](double h) { return circle(high, 0.15, h); }),
        swirl_zalesak(),
        single_vortex(),
        scaling("speedup-scaling", "a circle grows in a mesh of about 28,000 triangles", "9.7",
                0.00887),
        four_circles_scene(),
    };
}

} // namespace

InterfaceThresholds coarse_interface() {
    InterfaceThresholds thresholds;
    thresholds.longest = 1.4;
    thresholds.shortest = 0.45;
    thresholds.deviation = 0.02;
    return thresholds;
}

const std::vector<Scene>& catalogue() {
    static const std::vector<Scene> scenes = make_catalogue();
    return scenes;
}

const Scene& find_scene(const std::string& name) {
    std::string names;
    for (const Scene& scene : catalogue()) {
        if (scene.name == name) {
            return scene;
        }
        names += (names.empty() ? "" : ", ") + scene.name;
    }
    throw InputError("unknown scene", "run", "'" + name + "'", names);
}

} // namespace dsc::scenes
