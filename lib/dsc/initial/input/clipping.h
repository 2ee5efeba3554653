// SPDX-License-Identifier: MIT
// Outlines of shapes, clipped at the sides of the domain.
#pragma once

#include "dsc/initial/build/lattice.h"
#include "dsc/initial/initial_complex.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dsc::initial {

/// An outline or a hole of a shape; the first point is not repeated.
struct Loop {
    std::uint32_t shape = 0;
    std::string name;                   ///< in messages
    std::vector<Point<double>> points;  ///< representable in the scalar
    std::vector<std::uint32_t> numbers; ///< of these points, as the caller counts them
};

/// Whether a comes before b from left to right; of two points with equal x, the lower one comes
/// first.
[[nodiscard]] bool is_left_of(const Point<double>& a, const Point<double>& b);

/// Whether the edge between two points lies on a side of the domain.
[[nodiscard]] bool is_along_side(const Lattice& lattice, const Point<double>& a,
                                 const Point<double>& b);

/// What clipping found.
struct Clipped {
    std::size_t loops = 0;   ///< that were cut
    bool is_at_side = false; ///< a loop was cut, or lies within the tolerance of a side
};

/// Cuts off parts beyond the sides of the domain, moves points that are closer to a side than
/// `tolerance` onto it, and removes loops that become empty. O(points).
template <class Real>
Clipped clip_to_domain(std::vector<Loop>& loops, const Lattice& lattice, double tolerance);

} // namespace dsc::initial
