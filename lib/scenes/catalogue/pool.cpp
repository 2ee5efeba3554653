// SPDX-License-Identifier: MIT
// A drop falls into a pool and merges with it: the thesis's example of merging phases (section 13).
// The pool's surface is at rest, and the flow slows down towards it, so the drop is flattened;
// without merging, a film of air would stay under it.
#include "flows/velocity.h"
#include "scenes/catalogue/families.h"
#include "shapes/shapes.h"

namespace dsc::scenes {

namespace {

constexpr Falling fall{.surface = 0.3, .depth = 0.1, .speed = 1};
const Point<double> first_centre(0.5, 0.55);
constexpr double drop_radius = 0.12;
/// Vertices of the polygon that represents the drop's exact shape.
constexpr double fine = 1e-4;

ExactShape drop_and_pool_at(double time) {
    ExactShape shape;
    Outline drop = circle(first_centre, drop_radius, fine);
    for (auto& point : drop) {
        point = fall.advected(point, time);
    }
    shape.outlines = {drop, {{0, 0}, {1, 0}, {1, fall.surface}, {0, fall.surface}}};
    shape.area = signed_area(shape.outlines);
    shape.own_error = 2 * drop_radius * fine * fine;
    return shape;
}

Setup drop_and_pool(const Parameters& p) {
    Setup setup = scheduled(p, 0.35, 0.3 * p.h / fall.speed); // half of the fall
    Outline drop = circle(first_centre, drop_radius, p.h);
    drop.push_back(drop.front());
    setup.curves = {{drop, 1, exterior_phase},
                    {{{0, fall.surface}, {1, fall.surface}}, exterior_phase, 1}};
    setup.measured = 1;
    setup.flow = steady(fall);
    setup.half_step = setup.steps;
    setup.steps *= 2;
    setup.exact = drop_and_pool_at;
    return setup;
}

} // namespace

std::vector<Scene> pool_scenes() {
    return {
        {.name = "drop-and-pool",
         .description = "a drop falls into a pool and is absorbed",
         .section = "13",
         .defaults = {.h = 0.01, .dt = 0, .topology = Topology::change},
         .prepare = drop_and_pool},
    };
}

} // namespace dsc::scenes
