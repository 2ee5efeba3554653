// SPDX-License-Identifier: MIT
// A walk from triangle to triangle towards a point, by exact signs (O. Devillers, S. Pion,
// M. Teillaud, "Walking in a triangulation", 2002). For algorithms of the library; an application
// calls `locate`.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/geometry/predicates.h"

namespace dsc {

/// Where a walk ended.
struct WalkEnd {
    enum class Kind : std::uint8_t {
        triangle, ///< the point is strictly inside the triangle of `corner`
        edge,     ///< inside the edge opposite to `corner`
        vertex,   ///< on the vertex at `corner`
        stopped,  ///< beyond the edge opposite to `corner`, which must not be crossed
        lost,     ///< the steps are used up
    };
    Kind kind = Kind::lost;
    Corner corner = border_corner;
};

/// The end of a walk in the triangle of `here`. The point lies on the edges opposite to `first` and
/// `second` (no_id: on none), and on the inner side of the others.
[[nodiscard]] constexpr WalkEnd arrive(Corner here, Corner first, Corner second) {
    if (first == no_id) {
        return {WalkEnd::Kind::triangle, here};
    }
    if (second == no_id) {
        return {WalkEnd::Kind::edge, first};
    }
    // Two edges meet in the corner that is opposite to neither.
    Corner at = here;
    while (at == first || at == second) {
        at = next(at);
    }
    return {WalkEnd::Kind::vertex, at};
}

/// Walks from the living triangle `start`, in at most `limit` steps. Each step crosses an edge that
/// has the point strictly on its other side, and the walk stops if `may_cross(corner opposite to
/// it)` is false; it must be false at the domain boundary. In a mesh that is not Delaunay such a
/// walk could go in circles, so the edge that is tried first is chosen by a reproducible
/// pseudo-random bit. O(limit).
template <class Real, class MayCross>
[[nodiscard]] WalkEnd walk(const Complex<Real>& complex, Triangle start, const Point<Real>& point,
                           std::size_t limit, MayCross may_cross) {
    Corner here = corner_of(start.id, 0);
    Corner entered = no_id; // the walk never steps back through the edge that it came through
    std::uint32_t coin = 0x9e3779b9U;
    for (std::size_t step = 0; step < limit; ++step) {
        coin = coin * 1664525U + 1013904223U;
        Corner c = here;
        for (std::uint32_t turn = (coin >> 16U) % 3; turn > 0; --turn) {
            c = next(c);
        }
        Corner first = no_id;
        Corner second = no_id;
        Corner across = no_id;
        for (int side = 0; side < 3; ++side, c = next(c)) {
            if (c == entered) {
                continue;
            }
            const auto a = complex.position(Vertex{complex.vertex(next(c))});
            const auto b = complex.position(Vertex{complex.vertex(prev(c))});
            const int sign = orientation<Real>(a, b, point);
            if (sign < 0) {
                across = c;
                break;
            }
            if (sign == 0) {
                second = first;
                first = c;
            }
        }
        if (across == no_id) {
            return arrive(here, first, second);
        }
        if (!may_cross(across)) {
            return {WalkEnd::Kind::stopped, across};
        }
        here = complex.twin(across);
        entered = here;
    }
    return {};
}

} // namespace dsc
