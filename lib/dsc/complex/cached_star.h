// SPDX-License-Identifier: MIT
// Stars that the interface remeshing caches for the movement. Unless an edit has changed it since,
// such a star is gathered again without a walk from triangle to triangle, and its neighbours on the
// interface are known.
#pragma once

#include "dsc/base/types.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/records.h"
#include "dsc/complex/submesh.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace dsc {

/// A closed star of at most eight triangles as the interface remeshing has left it.
struct CachedStar {
    static constexpr std::uint32_t capacity = 8; ///< the largest degree that fits

    std::uint32_t vertex = no_id; ///< the centre
    std::uint32_t size = 0;       ///< triangles of the star
    std::uint32_t stamp = 0;      ///< stamp of the centre, when the star was cached
    IncidentEdges incident;       ///< those of the interface
    Phase left = border_phase;    ///< on the left of the first of these edges, seen from the centre
    Phase right = border_phase;   ///< on its right
    std::array<std::uint32_t, capacity> link; ///< ids; the first one repeated from `size` on

    /// Whether the star is unchanged: each edit of it activates its centre, which sets another
    /// stamp. O(1).
    template <class Real>
    [[nodiscard]] bool is_unchanged(const Complex<Real>& complex) const {
        return complex.vertices[vertex].stamp == stamp;
    }
};

namespace detail {

/// Whether the region owns the centre and the link at their current positions.
template <class Real>
bool owns_cached(const Complex<Real>& complex, const Region& region, const CachedStar& kept) {
    const auto is_owned = [&](std::uint32_t v) { return owns(complex, region, v); };
    return is_owned(kept.vertex) &&
           std::all_of(kept.link.begin(), kept.link.begin() + kept.size, is_owned);
}

} // namespace detail

/// Caches a closed star that fits. O(1).
template <class Real>
CachedStar cache_star(const Complex<Real>& complex, const Star<Real>& star,
                      const IncidentEdges& incident) {
    CachedStar kept{.vertex = star.vertex,
                    .size = star.size,
                    .stamp = complex.vertices[star.vertex].stamp,
                    .incident = incident,
                    .left = star.phase_after(incident.first),
                    .right = star.phase_before(incident.first),
                    .link = {}};
    for (std::uint32_t i = 0; i < CachedStar::capacity; ++i) {
        kept.link[i] = star.link[i < star.size ? i : 0];
    }
    return kept;
}

/// Gathers the part of a cached star that movement reads: centre, link and current coordinates, but
/// no corners, phases and predecessors. The region must own the centre; if it does not own the
/// whole star, `owned` becomes false and nothing else is written. O(1).
template <class Real>
void gather_cached(const Complex<Real>& complex, const Region& region, const CachedStar& kept,
                   Star<Real>& star) {
    constexpr std::uint32_t lanes = CachedStar::capacity;
    star.owned = region.is_whole() || detail::owns_cached(complex, region, kept);
    if (!star.owned) {
        return;
    }
    const auto* const vertices = complex.vertices.data();
    const std::uint32_t n = kept.size;
    star.vertex = kept.vertex;
    star.size = n;
    star.closed = true;
    star.x0 = read_shared(vertices[kept.vertex].x);
    star.y0 = read_shared(vertices[kept.vertex].y);
    for (std::uint32_t i = 0; i < lanes; ++i) {
        const auto& record = vertices[kept.link[i]];
        star.link[i] = kept.link[i];
        star.x[i] = read_shared(record.x);
        star.y[i] = read_shared(record.y);
    }
    for (std::uint32_t i = 0; i < lanes; ++i) {
        const std::uint32_t next = i + 1 < n ? i + 1 : i < n ? 0 : 1;
        star.x_next[i] = read_shared(vertices[kept.link[next]].x);
        star.y_next[i] = read_shared(vertices[kept.link[next]].y);
    }
}

} // namespace dsc
