// SPDX-License-Identifier: MIT
// Rigid motion without rotation (thesis, section 9.1): any loss is caused by remeshing alone.
#include "flows/exact.h"
#include "scenes/catalogue/families.h"
#include "shapes/shapes.h"

#include <algorithm>

namespace dsc::scenes {

namespace {

Setup around(const Parameters& p) {
    static constexpr double leg = 0.4;
    Setup setup = scheduled(p, 3 * leg, 3 * leg / 360);
    setup.outlines = {circle({0.3, 0.7}, 0.15, p.h)};
    setup.flow = {{leg, Translation{{1, 0}}},
                  {2 * leg, Translation{{0, -1}}},
                  {3 * leg, Translation{{-1, 1}}}};
    setup.exact = [first = setup.outlines](double t) {
        const double a = std::min(t, leg);
        const double b = std::clamp(t - leg, 0.0, leg);
        const double c = std::max(t - 2 * leg, 0.0);
        return translated_shape(first, {a - c, c - b});
    };
    return setup;
}

// The triangles inside move as one body. Thresholds accept the first triangles whatever their shape
// and size, so none of them changes.
Setup around_with_its_inside(const Parameters& p) {
    Setup setup = around(p);
    setup.advected = {1};
    setup.thresholds = {{},
                        {.collapse_quality = 0, .smooth_quality = 0, .shortest = 0, .crowded = 0}};
    return setup;
}

} // namespace

std::vector<Scene> translation_scenes() {
    return {{.name = "translation",
             .description = "a circle moves right, down, and back diagonally",
             .section = "9.1",
             .defaults = {.h = 0.051, .dt = 0},
             .prepare = around},
            {.name = "translation-phase",
             .description = "the same with the circle's inside, whose triangles do not change",
             .section = "9.1",
             .defaults = {.h = 0.0525, .dt = 0},
             .prepare = around_with_its_inside}};
}

} // namespace dsc::scenes
