// SPDX-License-Identifier: MIT
// Point location inside one phase, and insertion, which keeps the triangulation constrained
// Delaunay.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/initial/build/chains.h"
#include "dsc/initial/build/lattice.h"

#include <span>
#include <vector>

namespace dsc::initial {

/// Where a point lies.
enum class Place : std::uint8_t {
    triangle, ///< strictly inside the triangle of `corner`
    edge,     ///< inside the edge opposite to `corner`
    vertex,   ///< on the vertex at `corner`
    beyond,   ///< beyond the constrained edge opposite to `corner`, where the walk stopped
};

struct Location {
    Place place = Place::beyond;
    Corner corner = border_corner;
};

/// Walks from a living triangle towards the point. Stops at edges of the domain, and at the
/// interface. O(triangles on the way).
template <class Real>
Location locate(const Complex<Real>& complex, std::uint32_t start, const Point<Real>& point);

/// Puts a new vertex there, or returns the one that is there already; restores the Delaunay
/// property. `location` must not be `beyond`. O(degree), except for long chains of flips.
template <class Real>
std::uint32_t insert_point(Complex<Real>& complex, const Location& location,
                           const Point<Real>& point, std::vector<Corner>& stack);

/// Inserts all points of the paths; for each path the ids of its vertices, in order.
template <class Real>
Chains insert_paths(Complex<Real>& complex, const Lattice& lattice, std::span<const Path> paths);

} // namespace dsc::initial
