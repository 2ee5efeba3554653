// SPDX-License-Identifier: MIT
#include "topology/change.h"

#include "topology/films/boundary_films.h"
#include "topology/films/films.h"
#include "topology/films/remnants.h"
#include "topology/fronts/meeting.h"
#include "topology/give_back.h"
#include "topology/junctions/junctions.h"
#include "topology/landing/landing.h"

#include <algorithm>

namespace dsc {

template <class Real>
AreaAccount change_topology(TopologyWork<Real> work, std::span<const Candidate> candidates) {
    for (const Candidate& candidate : candidates) {
        if (is_blocked(work, candidate.vertex)) {
            work.blocked.push_back(candidate.vertex);
        }
    }
    std::ranges::sort(work.blocked);
    // Before any film opens: below a vertex that has arrived it would open without an area.
    land_junctions(work, candidates);
    land_vertices(work, candidates);
    Chords<Real> chords = find_chords(work);
    const std::size_t first_opened = work.touched.size();
    open_films<Real>(work, chords.list);
    // What wide films leave slender is mended by the next sub-steps, as their vertices go on
    // moving.
    const bool has_wide =
        is_wide(largest_contact(work.options, work.edge_length), work.edge_length);
    const std::size_t first_mended = has_wide ? work.touched.size() : 0;
    if (work.touched.size() > first_opened) {
        chords = find_chords(work); // films that opened have changed the interface
    }
    open_boundary_films(work, std::move(chords.list));
    if (chords.has_fronts) {
        meet_fronts(work);
    }
    change_junctions(work, candidates);
    remove_remnants(work, candidates);
    split_touched(work, candidates, first_mended);
    return give_back(work);
}

template AreaAccount change_topology(TopologyWork<double>, std::span<const Candidate>);
template AreaAccount change_topology(TopologyWork<float>, std::span<const Candidate>);

} // namespace dsc
