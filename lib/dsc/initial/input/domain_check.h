// SPDX-License-Identifier: MIT
// What shapes and curves have in common: the domain, the options and their limits.
#pragma once

#include "dsc/initial/build/lattice.h"
#include "dsc/initial/initial_complex.h"

#include <algorithm>

namespace dsc::initial {

/// The interface may come as close to the sides of the domain as this share of the edge length.
inline constexpr double least_margin = 1e-3;
/// More triangles than this are taken for a mistake; ids would end at 2^30.
inline constexpr double most_triangles = 5e8;
/// The interface may be cut into so many pieces.
inline constexpr double most_pieces = most_triangles / 4;
/// Squares of lengths, and products of two of these, must not leave the range of doubles by so much
/// that comparisons of qualities lose their meaning; nor may one over this. A simulation asks for
/// more: `least_edge_length` in base/tolerances.h.
inline constexpr double least_initial_edge_length = 1e-100;
/// An edge length must span so many steps of the scalar at the largest coordinate.
inline constexpr double least_steps = 64;

/// Throws InputError as `initial_complex` documents; otherwise the lattice that fits.
template <class Real>
Lattice check_domain(const Rectangle& domain, const InitialOptions& options);

/// The distance of a point from the nearest side of the domain; negative outside.
inline double distance_to_sides(const Lattice& lattice, const Point<double>& p) {
    return std::min({p.x() - lattice.low.x(), lattice.high.x() - p.x(), p.y() - lattice.low.y(),
                     lattice.high.y() - p.y()});
}

} // namespace dsc::initial
