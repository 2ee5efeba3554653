// SPDX-License-Identifier: MIT
// Rigid motion without rotation (thesis, section 9.1): any loss is caused by upkeep alone.
#include "flows/exact.h"
#include "scenes/catalogue/families.h"
#include "shapes/shapes.h"

#include <algorithm>

namespace dsc::scenes {

namespace {

Setup around(const Parameters& p) {
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
}

} // namespace

std::vector<Scene> translation_scenes() {
    return {{.name = "translation",
             .description = "a circle goes right, down, and back at an angle",
             .section = "9.1",
             .defaults = {.h = 0.051, .dt = 0},
             .prepare = around}};
}

} // namespace dsc::scenes
