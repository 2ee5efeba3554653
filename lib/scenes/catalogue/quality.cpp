// SPDX-License-Identifier: MIT
// Sizes of triangles that follow the interface (thesis, section 9.8; the test that section 11
// misses is the one by distance).
#include "flows/exact.h"
#include "scenes/catalogue/catalogue.h"
#include "scenes/catalogue/families.h"
#include "shapes/shapes.h"

namespace dsc::scenes {

namespace {

// The circle of `scaling`, in a mesh that is fine in a band about it and coarse elsewhere.
Setup grow_in_a_fine_band(const Parameters& p) {
    constexpr double edges_to_interface = 5; // as many as there are from anywhere outside the band
    Setup setup = scaling_scene({}, p.h).prepare(p);
    setup.sizes.by_distance = EdgesToInterface{p.h, edges_to_interface};
    return setup;
}

} // namespace

std::vector<Scene> quality_scenes() {
    return {
        {.name = "quality-distance",
         .description = "a circle grows in a mesh whose triangles grow with the distance to it",
         .section = "11",
         .defaults = {.h = 0.01, .dt = 0, .interface = coarse_interface(), .grade = 1.5},
         .prepare = grow_in_a_fine_band},
    };
}

} // namespace dsc::scenes
