// SPDX-License-Identifier: MIT
#include "topology/change.h"

#include "topology/films/boundary_films.h"
#include "topology/films/films.h"
#include "topology/films/landing.h"
#include "topology/films/meeting.h"
#include "topology/films/remnants.h"
#include "topology/films/wide_films.h"
#include "topology/give_back.h"
#include "topology/junctions/junctions.h"

#include <algorithm>

namespace dsc {

template <class Real>
AreaAccount change_topology(TopologyWork<Real> work, std::span<Candidate> candidates) {
    // Most candidates face no sheet: they matter only after something else has changed.
    const auto others =
        std::partition(candidates.begin(), candidates.end(), [](const Candidate& candidate) {
            return candidate.is_facing || candidate.is_sharp;
        });
    const std::span<const Candidate> notable(candidates.begin(), others);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const std::uint32_t v = candidates[i].vertex;
        work.complex.vertices[v].slot = static_cast<std::uint32_t>(i);
        if (is_blocked(work, v)) {
            work.blocked.push_back(v);
        }
    }
    std::ranges::sort(work.blocked);
    const bool has_wide =
        is_wide(largest_contact(work.options, work.edge_length), work.edge_length);
    if (has_wide) {
        open_wide_films<Real>(work, candidates);
    }
    // What wide films leave slender is mended by the next sub-steps, as their vertices go on
    // moving.
    const std::size_t first_mended = work.touched.size();
    open_boundary_films<Real>(work, has_wide ? candidates : notable);
    meet_fronts(work);
    open_films<Real>(work, candidates, notable);
    land_vertices<Real>(work, has_wide ? candidates : notable);
    change_junctions<Real>(work, notable);
    remove_remnants<Real>(work, notable);
    split_touched(work, first_mended);
    return give_back(work);
}

template AreaAccount change_topology(TopologyWork<double>, std::span<Candidate>);
template AreaAccount change_topology(TopologyWork<float>, std::span<Candidate>);

} // namespace dsc
