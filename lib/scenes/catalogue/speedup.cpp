// SPDX-License-Identifier: MIT
// Scenes for measuring speed (thesis, section 9.7).
#include "flows/exact.h"
#include "scenes/catalogue/catalogue.h"
#include "scenes/catalogue/families.h"
#include "shapes/shapes.h"

#include <algorithm>
#include <cmath>

namespace dsc::scenes {

namespace {

Setup four_go_up(const Parameters& p) {
    constexpr double shift = 0.6;
    Setup setup = scheduled(p, shift, shift / std::max(120.0, std::round(shift / (0.5 * p.h))));
    for (int i = 0; i < 4; ++i) {
        setup.outlines.push_back(circle({(2 * i + 1) / 8.0, 0.2}, 0.08, p.h));
    }
    setup.flow = steady(Translation{{0, 1}});
    setup.exact = [first = setup.outlines](double t) { return translated_shape(first, {0, t}); };
    return setup;
}

} // namespace

std::vector<Scene> speedup_scenes() {
    return {
        scaling_scene(
            {"speedup-scaling", "a circle grows in a mesh of about 28,000 triangles", "9.7"},
            0.00887),
        {.name = "speedup-four-circles",
         .description = "four circles side by side move up, each within its own slab",
         .section = "9.7",
         .defaults = {.h = 0.01, .dt = 0, .interface = coarse_interface()},
         .prepare = four_go_up},
    };
}

} // namespace dsc::scenes
