// SPDX-License-Identifier: MIT
#include "dsc/passes/algorithm.h"

#include "dsc/geometry/side.h"
#include "dsc/motion/movement.h"
#include "dsc/passes/deferred.h"
#include "dsc/passes/edits.h"
#include "dsc/passes/waiting.h"
#include "dsc/passes/work.h"

#include <algorithm>

namespace dsc {

namespace {

// A vertex on the domain boundary stays there (thesis, section 6.4).
template <class Real>
void stay_on_boundary(const Complex<Real>& complex, const Star<Real>& star, Real& x, Real& y) {
    const Point<Real> at(star.x0, star.y0);
    const Point<Real> place =
        complex.is_boundary_feature(Vertex{star.vertex})
            ? at
            : slid_on_side<Real>(link_point(star, 0), at, link_point(star, star.size), {x, y},
                                 !star.one_phase);
    x = place.x();
    y = place.y();
}

// Defers an owned vertex to another colour, and stores the index of its queue entry in its record.
template <class Real>
void defer(Work<Real>& work, const MovingVertex<Real>& moving_vertex) {
    auto& record = work.complex.vertices[moving_vertex.vertex];
    record.flags |= vertex_on_way;
    record.slot = static_cast<std::uint32_t>(work.deferred.entries.size());
    work.deferred.moving_vertex(moving_vertex);
}

// Whether an owned vertex has been deferred. Its slot may be stale: the entry there decides. O(1).
template <class Real>
bool is_deferred(const Work<Real>& work, std::uint32_t vertex) {
    const auto& entries = work.deferred.entries;
    const std::uint32_t slot = work.complex.vertices[vertex].slot;
    return slot < entries.size() && entries[slot].vertex == vertex &&
           entries[slot].kind == DeferredKind::moving_vertex;
}

// Whether a neighbour in the direction of (x, y) has been deferred to another submesh. A vertex
// that passed it before it moves would block both. O(degree).
template <class Real>
bool follows_deferred(const Work<Real>& work, const Star<Real>& star, Real x, Real y) {
    const auto is_ahead = [&](std::uint32_t i) {
        return (x - star.x0) * (star.link_x(i) - star.x0) +
                   (y - star.y0) * (star.link_y(i) - star.y0) >
               0;
    };
    for (std::uint32_t i = 0; i < star.link_size(); ++i) {
        if (is_waiting(work.complex, star.link[i]) && is_ahead(i) &&
            is_deferred(work, star.link[i])) {
            return true;
        }
    }
    return false;
}

template <class Real>
bool gather_moving_vertex(Work<Real>& work, const MovingVertex<Real>& moving_vertex) {
    const Region& region = work.submesh.region;
    if (moving_vertex.star < work.stars.size()) {
        gather_cached(work.complex, region, work.stars[moving_vertex.star], work.star);
        return true;
    }
    return gather(work.complex, region, moving_vertex.vertex, work.star);
}

} // namespace

template <class Real>
void move_vertices(Work<Real>& work) {
    work.progressed = 0;
    work.arrived = 0;
    std::size_t kept = 0;
    for (const MovingVertex<Real>& moving_vertex : work.moving_vertices) {
        Star<Real>& star = work.star;
        const bool gathered = gather_moving_vertex(work, moving_vertex);
        auto& flags = work.complex.vertices[moving_vertex.vertex].flags;
        if (!star.owned) {
            if (gathered) {
                defer(work, moving_vertex);
            } else { // it belongs to another submesh
                work.deferred.moving_vertex(moving_vertex);
            }
            continue;
        }
        if (!gathered) {
            work.moving_vertices[kept++] = {moving_vertex.vertex, moving_vertex.x, moving_vertex.y};
            continue;
        }
        Real x = moving_vertex.x;
        Real y = moving_vertex.y;
        if (!star.closed) {
            stay_on_boundary(work.complex, star, x, y);
        }
        if (!owns_place<Real>(work.submesh.region, {x, y})) {
            // The vertex would leave the submesh, inside which the next colour looks for deferred
            // vertices.
            defer(work, moving_vertex);
            continue;
        }
        const MoveOutcome outcome = move_vertex(work.submesh, star, x, y);
        if (outcome != MoveOutcome::blocked) {
            ++work.progressed;
        }
        work.activate(moving_vertex.vertex);
        activate_link(work, star);
        constexpr std::uint32_t late = vertex_contact | vertex_on_way;
        work.arrived += outcome == MoveOutcome::reached ? 1 : 0;
        if (outcome != MoveOutcome::reached) {
            if (!work.submesh.region.is_whole() && follows_deferred(work, star, x, y)) {
                defer(work, moving_vertex);
            } else {
                flags |= vertex_on_way;
                work.moving_vertices[kept++] = {moving_vertex.vertex, moving_vertex.x,
                                                moving_vertex.y};
            }
        } else if ((flags & late) != 0) {
            flags &= ~late;
        }
    }
    work.moving_vertices.resize(kept);
}

template void move_vertices(Work<double>&);
template void move_vertices(Work<float>&);

} // namespace dsc
