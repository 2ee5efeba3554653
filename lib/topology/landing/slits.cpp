// SPDX-License-Identifier: MIT
#include "topology/landing/slits.h"

namespace dsc {

namespace {

// The long side that ends at the vertex; no_id if there is no such slit.
template <class Real>
Corner slit_at(const TopologyWork<Real>& work, std::uint32_t v) {
    const Complex<Real>& complex = work.complex;
    Corner found = no_id;
    for_each_corner(complex, Vertex{v}, [&](Corner c) {
        for (const auto& [side, mouth] : {std::pair(next(c), prev(c)), {prev(c), next(c)}}) {
            const Real contact = within_triangles(work, contact_at(work, side));
            const Real width = direction(complex, mouth).squaredNorm();
            if (is_sheet(complex, c) && is_sheet(complex, side) && !is_outline(complex, mouth) &&
                phase_beyond(complex, c) == phase_beyond(complex, side) &&
                width < contact * contact && 4 * width < direction(complex, side).squaredNorm()) {
                found = side;
            }
        }
    });
    return found;
}

} // namespace

template <class Real>
void fill_slits(TopologyWork<Real>& work, std::uint32_t v) {
    const Complex<Real>& complex = work.complex;
    for (Corner side = slit_at(work, v); side != no_id; side = slit_at(work, v)) {
        const Triangle t{triangle_of(side)};
        const Point<double> place = centroid(complex, t).template cast<double>();
        const Phase taker = phase_beyond(complex, side);
        Event event{.kind = EventKind::widen,
                    .time = work.time,
                    .x = place.x(),
                    .y = place.y(),
                    .lost = complex.phase(t),
                    .taken = {taker, taker},
                    .area = static_cast<double>(doubled_area(complex, t)) / 2};
        if (!may_open(work, {.film = event.lost,
                             .sides = event.taken,
                             .x = event.x,
                             .y = event.y,
                             .thickness = static_cast<double>(thickness(complex, t))})) {
            return;
        }
        give(work, t, taker);
        work.events.push_back(event);
    }
}

template void fill_slits(TopologyWork<double>&, std::uint32_t);
template void fill_slits(TopologyWork<float>&, std::uint32_t);

} // namespace dsc
