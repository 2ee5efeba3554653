// SPDX-License-Identifier: MIT
// Growth along the normal, with phases that merge and split, or meet others.
#include "flows/eroded_dumbbell.h"
#include "flows/growing_discs.h"
#include "flows/two_discs.h"
#include "scenes/catalogue/families.h"
#include "shapes/shapes.h"

#include <algorithm>
#include <limits>

namespace dsc::scenes {

namespace {

/// The displacement of the interface in a step, in edge lengths.
constexpr double step_in_edges = 0.3;
/// The distance by which the discs grow and then shrink.
constexpr double distance = 0.1;

Setup two_discs_there_and_back(const Parameters& p) {
    static constexpr double speed = 1;
    const TwoDiscs discs;
    Setup setup = scheduled(p, distance / speed, step_in_edges * p.h / speed); // until they turn
    const double turn = setup.steps * setup.dt;
    for (const auto& centre : {discs.first, discs.second}) {
        setup.outlines.push_back(circle(centre, discs.radius, p.h));
    }
    setup.growth = Growth{.speed = speed, .turns_at = turn};
    setup.half_step = setup.steps;
    setup.steps *= 2;
    setup.exact = [discs, turn](double time) {
        const double grown = speed * std::min(time, turn);
        const double shrunk = speed * std::max(time - turn, 0.0);
        return shrunk_discs(discs, grown, shrunk);
    };
    return setup;
}

/// Half-way the neck, which closes at a depth of 0.04, is still open. Its sheets are parallel, so
/// all of it closes at once, too early by half the contact distance. At the end this error has
/// vanished, and the error is of second order again.
Setup dumbbell_to_two_lobes(const Parameters& p) {
    static constexpr double depth = 0.06;
    static constexpr double speed = -1;
    static const Dumbbell first{.neck = 0.08};
    Setup setup = scheduled(p, depth / -speed, step_in_edges * p.h / -speed);
    setup.outlines = {dumbbell(first, p.h)};
    setup.growth = Growth{.speed = speed, .turns_at = std::numeric_limits<double>::infinity()};
    setup.half_step = setup.steps / 2;
    setup.exact = [](double time) { return eroded_dumbbell(first, -speed * time); };
    return setup;
}

/// The shape of disc 1 is compared with its exact cell; the wrong area is that of all discs.
Setup discs_fill_the_square(const Parameters& p) {
    const auto discs =
        std::make_shared<const GrowingDiscs>(nucleating_discs(p.grains, p.sites, p.nucleation));
    Setup setup = scheduled(p, filling_time(*discs) + 2 * p.h, 0.5 * p.h);
    for (std::size_t i = 0; i < discs->radii.size(); ++i) {
        setup.outlines.push_back(circle(discs->centres[i], discs->radii[i], p.h));
        setup.phases.push_back(static_cast<Phase>(i + 1));
    }
    setup.measured = 1;
    setup.growth = Growth{.turns_at = std::numeric_limits<double>::infinity(), .discs = discs};
    setup.exact = [discs](double time) { return exact_cell(*discs, 0, time); };
    return setup;
}

} // namespace

std::vector<Scene> growth_scenes() {
    return {
        {.name = "grow-shrink",
         .description = "two discs grow by their normals, merge, and shrink again",
         .section = "13",
         .defaults =
             {.h = 0.01, .dt = 0, .interface = {.longest = 0.7}, .topology = Topology::change},
         .prepare = two_discs_there_and_back},
        {.name = "erode-dumbbell",
         .description = "a dumbbell shrinks by its normals and splits as its neck closes",
         .section = "13",
         .defaults =
             {.h = 0.01, .dt = 0, .interface = {.longest = 0.7}, .topology = Topology::change},
         .prepare = dumbbell_to_two_lobes},
        {.name = "johnson-mehl",
         .description = "discs of as many phases grow, meet, and fill the square",
         .section = "13",
         .defaults = {.h = 0.02,
                      .dt = 0,
                      .grains = 10,
                      .sites = 11,
                      .interface = {.longest = 0.7},
                      .topology = Topology::change},
         .prepare = discs_fill_the_square,
         .keys = common_keys({"grains", "sites", "nucleation"})},
    };
}

} // namespace dsc::scenes
