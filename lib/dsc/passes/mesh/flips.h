// SPDX-License-Identifier: MIT
// Flips of the mesh update (Lawson 1977): from the edges of a star that violate the Delaunay
// condition on, until all edges around satisfy it.
#pragma once

#include "dsc/base/verdict.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/passes/mesh/poor_stars.h"
#include "dsc/passes/waiting.h"
#include "dsc/passes/work.h"
#include "dsc/quality/measures.h"

#include <algorithm>

namespace dsc {

/// Thread safety: flips change triangles of the submesh of the work alone.
template <class Real>
class DelaunayFlips {
public:
    DelaunayFlips(Work<Real>& work, const WaitingRule& waiting)
        : work_(work), complex_(work.complex), waiting_(waiting) {}

    /// Starts at the incident edges whose margins are negative. Returns whether an edge was
    /// flipped; the star is stale then.
    bool flip_incident_edges(const Star<Real>& star, const IncidentEdgeMargins<Real>& margins) {
        const std::uint64_t before = work_.log.counts.flips;
        work_.candidates.clear();
        for (std::uint32_t i = 0; i < star.size; ++i) {
            if (margins[i] < 0) {
                work_.candidates.push_back(prev(star.corner[i]));
            }
        }
        drain();
        return work_.log.counts.flips != before;
    }

    /// Starts at the edges of the star's triangles, after its centre moved: reuses the data of the
    /// star, and lists only the edges that fail. `margins` are those of the moved star.
    void flip_edges_of_triangles(const Star<Real>& star, const IncidentEdgeMargins<Real>& margins) {
        work_.candidates.clear();
        const Point<Real> centre(star.x0, star.y0);
        for (std::uint32_t i = 0; i < star.size; ++i) {
            const Corner across = complex_.twin(star.corner[i]);
            if (complex_.phase_at(across) == star.phase[i] &&
                !is_delaunay<Real>(centre, {star.x[i], star.y[i]}, apex(across),
                                   {star.x_next[i], star.y_next[i]})) {
                work_.candidates.push_back(star.corner[i]);
            }
            if (margins[i] < 0) {
                work_.candidates.push_back(prev(star.corner[i]));
            }
        }
        drain();
    }

    /// Starts at the incident edges of a star, whichever they are.
    void flip_around(const Star<Real>& star) {
        work_.candidates.clear();
        for (std::uint32_t i = 0; i < star.size; ++i) {
            work_.candidates.push_back(prev(star.corner[i]));
        }
        drain();
    }

private:
    /// Lawson's algorithm terminates; this bound only guards against rounding that the tolerance of
    /// the test does not cover.
    static constexpr std::size_t max_flips_at_once = 4096;

    /// The vertex at a corner, which another submesh may own and move.
    Point<Real> apex(Corner corner) const {
        const auto& record = complex_.vertices[complex_.vertex(corner)];
        return {read_shared(record.x), read_shared(record.y)};
    }

    void drain() {
        auto& candidates = work_.candidates;
        std::size_t flips = 0;
        const Region& region = work_.submesh.region;
        while (!candidates.empty()) {
            const Corner c = candidates.back();
            candidates.pop_back();
            // The triangle of c belongs to an owned star, or to a flip in one, so it is owned if it
            // is alive.
            const TriangleRecord& near = complex_.triangles[triangle_of(c)];
            if (near.v[0] == no_id) {
                continue;
            }
            const std::uint32_t i = index_of(c);
            const Corner o = near.n[i];
            if (complex_.phase_at(o) != near.phase) {
                continue;
            }
            const auto at = [this](std::uint32_t v) { return complex_.position(Vertex{v}); };
            const Point<Real> here = at(near.v[i]);
            const Point<Real> from = at(near.v[next_index(i)]);
            const Point<Real> across = apex(o);
            const Point<Real> to = at(near.v[prev_index(i)]);
            if (is_delaunay<Real>(here, from, across, to)) {
                continue;
            }
            if (!owns(complex_, region, complex_.vertex(o)) ||
                (waiting_.applies() && waits_around(work_, waiting_, c))) {
                deferred(work_, complex_.vertex(next(c)));
                continue;
            }
            // All four vertices are owned: the region need not be consulted.
            if (flips >= max_flips_at_once ||
                edge_flip_guard(complex_, Region{}, c) != Verdict::legal) {
                continue;
            }
            rewire::flip(complex_, work_.log, c);
            if (work_.watched_quality >= 0) {
                list_flip(near.v[i], here, from, across, to);
            }
            ++flips;
            candidates.push_back(c);
            candidates.push_back(prev(c));
            candidates.push_back(o);
            candidates.push_back(prev(o));
        }
    }

    // After a flip, where `v` is at `here`, opposite to the edge that was there before. Not
    // inlined, as `list_poor`.
    [[gnu::noinline]] void list_flip(std::uint32_t v, const Point<Real>& here,
                                     const Point<Real>& from, const Point<Real>& across,
                                     const Point<Real>& to) {
        list_if_poor(work_, v,
                     std::min(quality_squared<Real>(here, from, across),
                              quality_squared<Real>(here, across, to)));
    }

    Work<Real>& work_;
    Complex<Real>& complex_;
    const WaitingRule& waiting_;
};

} // namespace dsc
