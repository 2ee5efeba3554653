// SPDX-License-Identifier: MIT
// The curve of a front between its vertices: chords lag behind their arcs.
#pragma once

#include "topology/junctions/sectors.h"
#include "topology/region.h"

namespace dsc {

/// The last corner of a sector at its vertex. O(degree).
template <class Real>
[[nodiscard]] Corner last_of(const Complex<Real>& complex, const Sector<Real>& sector);

/// The unit vector halfway between the two edges of a sector. O(1).
template <class Real>
[[nodiscard]] Point<Real> middle_of(const Sector<Real>& sector);

/// The normal of a front at a vertex, into its sector: that of the parabola through both neighbours
/// by chord length, since the bisector would lean towards the longer edge; the bisector where the
/// front has a corner. It is that of the front at the time of the simulation: vertices that met
/// another front ahead of the time would tilt it. O(degrees).
template <class Real>
[[nodiscard]] Point<Real> normal_now(const TopologyWork<Real>& work, std::uint32_t v,
                                     const Sector<Real>& sector);

/// A point of a front, and the unit normal there, to the left of the edge.
template <class Real>
struct CurvePoint {
    Point<Real> place;
    Point<Real> normal;
};

/// At a share of an edge, on the cubic on which new vertices lie, where the front is at the time of
/// the simulation, though some of its vertices are ahead. `other_speed`: along the normal in a
/// sub-step, if the front's own is unknown. O(degrees).
template <class Real>
[[nodiscard]] CurvePoint<Real> curve_now(const TopologyWork<Real>& work, Corner edge, Real share,
                                         Real other_speed);

} // namespace dsc
