// SPDX-License-Identifier: MIT
// Movement: vertices go as far towards their destinations as possible without inverting a triangle
// (thesis, section 5.1).
#pragma once

#include "reference/complex/complex.h"

#include <map>

namespace dsc::reference {

/// Altitude over base, with the base opposite to the moving vertex, that a move must leave to every
/// triangle (or half of what the triangle had, if that is less): small enough to let vertices pass
/// close by edges, large enough that what remains can be repaired.
inline constexpr double min_altitude = 0.02;

/// The vertices that are under way, with their destinations.
using Destinations = std::map<Vertex, Point<double>>;

/// The largest fraction s in [0, 1] of the way of `v` to `destination` that is safe for all its
/// triangles. Linear in s, for the area of a triangle is linear in one of its vertices.
double movable_fraction(const Complex& K, Vertex v, const Point<double>& destination);

/// Moves `v` by that fraction, certified by exact orientation. True if it arrived.
bool move_vertex(Vertex v, const Point<double>& destination, Complex& K);

/// Moves every vertex as far as possible and strikes those that arrived off the list.
void movement(Destinations& under_way, Complex& K);

} // namespace dsc::reference
