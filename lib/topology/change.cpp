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
AreaAccount change_topology(Complex<Real>& complex, const TopologyOptions<Real>& options,
                            Real edge_length, std::span<Suspect<Real>> suspects, double time,
                            std::vector<Event>& events) {
    TopologyWork<Real> work{.complex = complex,
                            .options = options,
                            .edge_length = edge_length,
                            .time = time,
                            .events = events};
    for (const Suspect<Real>& suspect : suspects) {
        if (is_held_up(work, suspect.vertex)) {
            work.held_up.push_back(suspect.vertex);
        }
    }
    std::ranges::sort(work.held_up);
    // Most suspects face no sheet: they count once something else has changed.
    const auto others =
        std::partition(suspects.begin(), suspects.end(), [](const Suspect<Real>& suspect) {
            return suspect.is_facing || suspect.is_sharp;
        });
    const std::span<const Suspect<Real>> notable(suspects.begin(), others);
    const bool has_wide = is_wide(largest_contact(options, edge_length), edge_length);
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

template AreaAccount change_topology(Complex<double>&, const TopologyOptions<double>&, double,
                                     std::span<Suspect<double>>, double, std::vector<Event>&);
template AreaAccount change_topology(Complex<float>&, const TopologyOptions<float>&, float,
                                     std::span<Suspect<float>>, double, std::vector<Event>&);

} // namespace dsc
