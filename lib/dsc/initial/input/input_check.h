// SPDX-License-Identifier: MIT
// What the initial complex is asked for, checked and made ready: outlines rounded to the scalar,
// cut into pieces and counter-clockwise.
#pragma once

#include "dsc/initial/build/lattice.h"
#include "dsc/initial/initial_complex.h"

namespace dsc::initial {

/// A checked outline, counter-clockwise, with no edge longer than the target; no two outlines cross
/// or touch. Coordinates are representable in the scalar of the complex.
struct Outline {
    std::vector<Point<double>> points;
    Phase phase = exterior_phase;
};

struct CheckedInput {
    Lattice lattice;
    std::vector<Outline> outlines;
};

/// An outline may come as close to the sides of the domain as this share of the edge length.
inline constexpr double least_margin = 1e-3;
/// More triangles than this are taken for a mistake; ids would end at 2^30.
inline constexpr double most_triangles = 5e8;
/// Squares of lengths, and products of two of these, must not leave the range of doubles by so much
/// that comparisons of qualities lose their meaning; nor may one over this. A simulation asks for
/// more: `least_edge_length` in base/tolerances.h.
inline constexpr double least_initial_edge_length = 1e-100;
/// An edge length must span so many steps of the scalar at the largest coordinate.
inline constexpr double least_steps = 64;

/// Throws InputError as `initial_complex` documents.
template <class Real>
CheckedInput check_input(const Rectangle& domain, std::span<const Shape> shapes,
                         const InitialOptions& options);

} // namespace dsc::initial
