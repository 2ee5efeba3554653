// SPDX-License-Identifier: MIT
#include "topology/change.h"

#include "topology/films/films.h"
#include "topology/films/landing.h"
#include "topology/films/remnants.h"
#include "topology/films/wall_films.h"
#include "topology/films/wide_films.h"
#include "topology/give_back.h"
#include "topology/junctions/junctions.h"

#include <algorithm>

namespace dsc {

template <class Real>
AreaAccount change_topology(TopologyWork<Real> work, std::span<Suspect> suspects) {
    // Most suspects face no sheet: they count once something else has changed.
    const auto others =
        std::partition(suspects.begin(), suspects.end(), [](const Suspect& suspect) {
            return suspect.is_facing || suspect.is_sharp;
        });
    const std::span<const Suspect> notable(suspects.begin(), others);
    for (std::size_t i = 0; i < suspects.size(); ++i) {
        const std::uint32_t v = suspects[i].vertex;
        work.complex.vertices[v].slot = static_cast<std::uint32_t>(i);
        if (is_held_up(work, v)) {
            work.held_up.push_back(v);
        }
    }
    std::ranges::sort(work.held_up);
    const bool has_wide =
        is_wide(largest_contact(work.options, work.edge_length), work.edge_length);
    if (has_wide) {
        open_wide_films<Real>(work, suspects);
    }
    open_wall_films<Real>(work, has_wide ? suspects : notable);
    open_films<Real>(work, suspects, notable);
    land_vertices<Real>(work, has_wide ? suspects : notable);
    change_junctions<Real>(work, notable);
    remove_remnants<Real>(work, notable);
    take_touched_apart(work);
    return give_back(work);
}

template AreaAccount change_topology(TopologyWork<double>, std::span<Suspect>);
template AreaAccount change_topology(TopologyWork<float>, std::span<Suspect>);

} // namespace dsc
