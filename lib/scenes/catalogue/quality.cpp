// SPDX-License-Identifier: MIT
// Sizes of triangles that follow the interface (thesis, section 9.8; section 11 asks for the test
// by distance).
#include "flows/exact.h"
#include "scenes/catalogue/catalogue.h"
#include "scenes/catalogue/families.h"

#include <algorithm>

namespace dsc::scenes {

namespace {

// The circle of `scaling` in a mesh that is fine in a band around the circle and coarse elsewhere.
Setup grow_in_a_fine_band(const Parameters& p) {
    constexpr double edges_to_interface = 5; // from any point outside the band
    Setup setup = scaling_scene({}, p.h).prepare(p);
    setup.sizes.by_distance = EdgesToInterface{p.h, edges_to_interface};
    return setup;
}

// Ratio of coarse to fine edge lengths.
constexpr double coarse_over_fine = 4;

// The four combinations of fine and coarse triangles, inside and outside. The interface is fine
// unless both are coarse; it starts fine, and remeshing adapts it to its targets.
Setup grow_in_two_sizes(const Parameters& p) {
    const auto length = [&](Fineness fineness) {
        return fineness == Fineness::coarse ? coarse_over_fine * p.h : p.h;
    };
    const double inside = length(p.inside);
    const double outside = length(p.outside);
    Setup setup = scaling_scene({}, p.h).prepare(p);
    setup.sizes.by_place = LengthByPhase{{outside, inside}};
    setup.sizes.on_interface = [finer = std::min(inside, outside)](const auto&, double) {
        return finer;
    };
    return setup;
}

// Edges of triangles and of the interface are long at the left end of the growing circle and short
// at its right end; beyond the ends they are as long as at the nearer end.
Setup grow_across_sizes(const Parameters& p) {
    const auto length = [h = p.h](const Point<double>& place, double time) {
        const double radius = 0.1 + time;
        const double share = (place.x() - (0.5 - radius)) / (2 * radius);
        const double longest = coarse_over_fine * h;
        return longest + (h - longest) * std::clamp(share, 0.0, 1.0);
    };
    Setup setup = scaling_scene({}, p.h).prepare(p);
    setup.sizes.by_place = [length](const Point<double>& place, double time, Phase) {
        return length(place, time);
    };
    setup.sizes.on_interface = length;
    setup.sizes.changes_in_time = true;
    return setup;
}

} // namespace

std::vector<Scene> quality_scenes() {
    return {
        {.name = "quality-combinations",
         .description = "a circle grows; triangles inside and outside are fine or coarse",
         .section = "9.8",
         .defaults = {.h = 0.02,
                      .dt = 0,
                      .inside = Fineness::fine,
                      .outside = Fineness::coarse,
                      .interface = coarse_interface(),
                      .grade = 1.5},
         .prepare = grow_in_two_sizes,
         .keys = common_keys({"inside", "outside"})},
        {.name = "quality-varying",
         .description =
             "a circle grows in a mesh that is coarse at its left end and fine at its right",
         .section = "9.8",
         .defaults = {.h = 0.01, .dt = 0, .interface = coarse_interface(), .grade = 1.5},
         .prepare = grow_across_sizes},
        {.name = "quality-distance",
         .description = "a circle grows in a mesh whose triangles grow with the distance to it",
         .section = "11",
         .defaults = {.h = 0.01, .dt = 0, .interface = coarse_interface(), .grade = 1.5},
         .prepare = grow_in_a_fine_band},
    };
}

} // namespace dsc::scenes
