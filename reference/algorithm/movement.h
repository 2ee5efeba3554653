// SPDX-License-Identifier: MIT
// Movement: vertices move as far towards their destinations as possible without inverting a
// triangle (thesis, section 5.1).
#pragma once

#include "reference/complex/complex.h"

#include <map>

namespace dsc::reference {

/// Lower bound of altitude over base, with the base opposite to the moving vertex, of every
/// triangle after a move (or half of its value before, if that is less): small enough to let
/// vertices pass close to edges, large enough that the triangles can be repaired.
inline constexpr double min_altitude = 0.02;

/// The vertices that have not arrived, with their destinations.
using Destinations = std::map<Vertex, Point<double>>;

/// The largest fraction s in [0, 1] of the displacement of `v` to `destination` that is safe for
/// all its triangles. The area of a triangle is linear in s.
double movable_fraction(const Complex& K, Vertex v, const Point<double>& destination);

/// Moves `v` by that fraction, checked by exact orientation. Returns whether it arrived.
bool move_vertex(Vertex v, const Point<double>& destination, Complex& K);

/// Moves every vertex as far as possible and removes those that arrived from the list.
void movement(Destinations& under_way, Complex& K);

} // namespace dsc::reference
