// SPDX-License-Identifier: MIT
// Rigid rotations (thesis, section 9.3): sharp features must stay sharp.
#include "flows/exact.h"
#include "scenes/catalogue/families.h"
#include "shapes/shapes.h"

#include <numbers>

namespace dsc::scenes {

Scene rotation_scene(Scene about, double h, int steps, std::function<Outline(double h)> outline) {
    about.defaults = {.h = h, .dt = 0};
    about.prepare = [outline = std::move(outline), steps](const Parameters& p) {
        constexpr double whole_turn = 2 * std::numbers::pi;
        const Point<double> middle(0.5, 0.5);
        Setup setup = scheduled(p, 1.0, 1.0 / steps);
        setup.outlines = {outline(p.h)};
        setup.flow = steady(Rotation{middle, whole_turn});
        setup.exact = [first = setup.outlines, middle](double t) {
            return rotated_shape(first, middle, whole_turn * t);
        };
        return setup;
    };
    return about;
}

std::vector<Scene> rotation_scenes() {
    return {
        rotation_scene({"rotation-rectangle", "a rectangle turns once about its centre", "9.3"},
                       0.02, 360,
                       [](double h) {
                           return rectangle({0.25, 0.4}, {0.75, 0.6}, h);
                       }),
        rotation_scene({"rotation-crescent", "a crescent turns once about the origin", "9.3"}, 0.02,
                       360,
                       [](double h) {
                           return crescent({{0.5, 0.5}, 0.3, {0.68, 0.5}, 0.24}, h);
                       }),
    };
}

// The usual test of sharp corners and thin slots (thesis, section 9.6).
std::vector<Scene> zalesak_scenes() {
    return {rotation_scene({"zalesak", "Zalesak's slotted disc, one revolution", "9.6"}, 0.01, 628,
                           [](double h) { return slotted_disc({}, h); })};
}

} // namespace dsc::scenes
