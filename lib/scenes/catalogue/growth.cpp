// SPDX-License-Identifier: MIT
// Growth along the normal, and phases that merge on the way.
#include "flows/two_discs.h"
#include "scenes/catalogue/families.h"
#include "shapes/shapes.h"

#include <algorithm>

namespace dsc::scenes {

namespace {

/// The farthest that the interface goes in a step, in edge lengths.
constexpr double step = 0.3;
/// How far the discs grow, and by how much they shrink after that.
constexpr double distance = 0.1;

Setup two_discs_there_and_back(const Parameters& p) {
    static constexpr double speed = 1;
    const TwoDiscs discs;
    const Schedule half = schedule(p, distance / speed, step * p.h / speed);
    const double turn = half.steps * half.dt;
    Setup setup;
    for (const auto& centre : {discs.first, discs.second}) {
        setup.outlines.push_back(circle(centre, discs.radius, p.h));
    }
    setup.growth = Growth{.speed = speed, .turns_at = turn};
    setup.dt = half.dt;
    setup.steps = 2 * half.steps;
    setup.half_step = half.steps;
    setup.exact = [discs, turn](double time) {
        const double grown = speed * std::min(time, turn);
        const double shrunk = speed * std::max(time - turn, 0.0);
        return shrunk > 0 ? shrunk_discs(discs, grown, shrunk) : grown_discs(discs, grown);
    };
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
    };
}

} // namespace dsc::scenes
