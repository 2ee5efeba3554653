// SPDX-License-Identifier: MIT
// What a vertex of a front sees across a film: a vertex or an edge of another front, which comes
// closer.
#pragma once

#include "topology/junctions/sectors.h"
#include "topology/region.h"

#include <optional>

namespace dsc {

/// Where fronts meet.
template <class Real>
struct Encounter {
    Point<Real> place = Point<Real>::Zero();
    Real shares = 0; ///< of a sub-step from now
};

/// A vertex of a front, and what it sees across a film.
template <class Real>
struct Sight {
    std::uint32_t v = no_id;                    ///< the vertex
    std::uint32_t q = no_id;                    ///< a vertex of the other front...
    Corner edge = no_id;                        ///< ...or the edge on which its foot lies,
    Real share = 0;                             ///< at this share of it
    Point<Real> front_q = Point<Real>::Zero();  ///< the point of the other front's curve there
    Real gap = 0;                               ///< the distance of the two fronts
    Phase film = 0;                             ///< between them
    Phase one = 0;                              ///< beyond v
    Phase other = 0;                            ///< beyond q
    Point<Real> normal_v = Point<Real>::Zero(); ///< of the fronts, into the film
    Point<Real> normal_q = Point<Real>::Zero(); ///< the same at q
    Real speed_v = 0;                           ///< ways along the normals in a whole sub-step
    Real speed_q = 0;                           ///< the same at q
    Real lead_v = 0;                ///< by which v is ahead of its front, along its normal
    Real lead_q = 0;                ///< the same at q
    bool is_on_boundary = false;    ///< both lie on the domain boundary
    bool is_passed = false;         ///< q is the end of a seam that v belongs to
    bool is_squeezed = false;       ///< v and q are the ends of a front that vanishes...
    Encounter<Real> vanishing = {}; ///< ...there
};

/// The nearest that meets the vertex now, or would in the next sub-step. Only reads; allocates only
/// at the few vertices that another front is near to. O(degrees).
template <class Real>
[[nodiscard]] std::optional<Sight<Real>> see_front(const TopologyWork<Real>& work, std::uint32_t v);

/// Edges of the domain boundary between the ends of two fronts that see each other along it.
inline constexpr int edges_along_boundary = 4;

} // namespace dsc
