// SPDX-License-Identifier: MIT
// A point of a front: how far the front went in the sub-step, and how far the point is ahead of it.
#pragma once

#include "topology/region.h"

#include <array>
#include <optional>

namespace dsc {

/// A vertex of a front, or a point on an edge of it.
template <class Real>
struct FrontPoint {
    /// A vertex and its share of the point.
    struct End {
        std::uint32_t v = no_id;
        Real weight = 0;
    };
    std::array<End, 2> ends; ///< the second is `no_id` at a vertex
};

/// A vertex of a front.
template <class Real>
[[nodiscard]] FrontPoint<Real> front_point(std::uint32_t v) {
    return {{{{v, Real(1)}, {}}}};
}
/// At a share of the edge.
template <class Real>
[[nodiscard]] FrontPoint<Real> front_point(const Complex<Real>& complex, Corner edge, Real share) {
    return {{{{complex.vertex(next(edge)), 1 - share}, {complex.vertex(prev(edge)), share}}}};
}

/// How far the point would move in a whole sub-step like the last one; none if nobody knows.
template <class Real>
[[nodiscard]] std::optional<Point<Real>> way_of(const TopologyWork<Real>& work,
                                                const FrontPoint<Real>& point);
/// The same along a normal of the front, in units of the domain: the end of a seam, which goes
/// along the seam, tells it only from where two fronts met there.
template <class Real>
[[nodiscard]] std::optional<Real>
speed_of(const TopologyWork<Real>& work, const FrontPoint<Real>& point, const Point<Real>& normal);
/// How far the vertex is ahead of its front, which goes so far along this normal in a sub-step;
/// below 0 if it did not arrive.
template <class Real>
[[nodiscard]] Real lead_of(const TopologyWork<Real>& work, std::uint32_t v,
                           const Point<Real>& normal, Real speed);
/// Notes that the vertex is so many sub-steps ahead of its fronts, or late if below 0, and how far
/// they go in a sub-step.
template <class Real>
void put_ahead(TopologyWork<Real>& work, std::uint32_t v, Real shares, Real speed);
/// Whether the point, or an end of its edge, is blocked.
template <class Real>
[[nodiscard]] bool is_blocked(const TopologyWork<Real>& work, const FrontPoint<Real>& point);

} // namespace dsc
