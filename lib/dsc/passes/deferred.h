// SPDX-License-Identifier: MIT
// Work that a submesh may not do and therefore defers to another colour.
#pragma once

#include "dsc/base/types.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dsc {

/// A vertex that is moving to its target.
template <class Real>
struct MovingVertex {
    std::uint32_t vertex; ///< its id
    Real x;               ///< target
    Real y;
    std::uint32_t star = no_id; ///< number of its star in `Work::stars`
};

/// The kind of a deferred task.
enum class DeferredKind : std::uint8_t {
    star,          ///< a star that must be visited
    moving_vertex, ///< a vertex that has yet to reach its target
    remeshing,     ///< an interface vertex at which the interface may have to be split or collapsed
    listing,       ///< an interface vertex that now lies in another submesh and belongs in its list
};

/// One entry of the queue.
template <class Real>
struct Deferred {
    /// The route of an entry that is processed serially at the end, because no submesh takes it.
    static constexpr std::uint32_t nowhere = 0xffffffffU;

    std::uint32_t vertex;          ///< the vertex concerned
    std::uint32_t route = nowhere; ///< number of the submesh that takes it
    Real x = 0;                    ///< target of a moving vertex
    Real y = 0;
    DeferredKind kind; ///< the task at the vertex

    /// The vertex and its target; only of the kind `moving_vertex`.
    [[nodiscard]] MovingVertex<Real> moving_vertex() const { return {vertex, x, y}; }
};

/// A queue of deferred work. Not thread-safe: each submesh has its own, which others read after the
/// submesh has ended.
template <class Real>
struct DeferredQueue {
    std::vector<Deferred<Real>> entries; ///< in the order in which they were deferred
    std::size_t routed = 0;              ///< entries before this one have a route

    /// Defers a visit of the star of `v`. Amortised O(1), as are the next three.
    void star(std::uint32_t v) { put(v, DeferredKind::star); }
    /// Defers interface remeshing at `v`.
    void remeshing(std::uint32_t v) { put(v, DeferredKind::remeshing); }
    /// Defers `v` to the interface list of the submesh that owns it now.
    void listing(std::uint32_t v) { put(v, DeferredKind::listing); }
    /// Defers a movement.
    void moving_vertex(const MovingVertex<Real>& m) {
        entries.push_back(
            {.vertex = m.vertex, .x = m.x, .y = m.y, .kind = DeferredKind::moving_vertex});
    }
    /// Empties the queue and keeps its memory.
    void clear() {
        entries.clear();
        routed = 0;
    }

private:
    void put(std::uint32_t v, DeferredKind kind) { entries.push_back({.vertex = v, .kind = kind}); }
};

} // namespace dsc
