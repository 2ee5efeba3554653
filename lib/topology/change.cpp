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
#include <iterator>
#include <utility>
#include <vector>

namespace dsc {

namespace {

template <class Real>
std::vector<Vertex> touched_since(const TopologyWork<Real>& work, std::size_t first) {
    return {work.touched.begin() + static_cast<std::ptrdiff_t>(first), work.touched.end()};
}

} // namespace

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
    open_boundary_films<Real>(work, has_wide ? candidates : notable);
    // Wide films, films along the domain boundary and vertices that land go on moving at once: what
    // they leave slender is not mended here.
    const std::size_t touched_first = work.touched.size();
    meet_fronts(work);
    open_films<Real>(work, candidates, notable);
    std::vector<Vertex> mended = touched_since(work, touched_first);
    land_vertices<Real>(work, has_wide ? candidates : notable);
    const std::size_t touched_before_junctions = work.touched.size();
    change_junctions<Real>(work, notable);
    remove_remnants<Real>(work, notable);
    std::ranges::copy(touched_since(work, touched_before_junctions), std::back_inserter(mended));
    split_touched(work, std::move(mended));
    return give_back(work);
}

template AreaAccount change_topology(TopologyWork<double>, std::span<Candidate>);
template AreaAccount change_topology(TopologyWork<float>, std::span<Candidate>);

} // namespace dsc
