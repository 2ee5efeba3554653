// SPDX-License-Identifier: MIT
// Shapes that touch each other or the sides of the domain, as a network of curves. Shapes beyond
// the domain are clipped; borders that run along each other become one; each region gets the phase
// of the innermost shape, and each edge between two phases becomes part of a curve.
#pragma once

#include "dsc/initial/input/line.h"

#include <optional>

namespace dsc::initial {

struct ShapeNetwork {
    std::vector<Line> lines;           ///< curves, not yet checked
    Phase background = exterior_phase; ///< phase of the domain, if there is no curve
    bool has_outside = false;          ///< the last shape is the surroundings of the domain
};

/// The curves between the shapes. Empty if the shapes are simple polygons that lie apart, inside
/// the domain, and none of them is a hole of another: then they can be used unchanged.
///
/// Throws InputError where outlines cross, where shapes overlap of which none lies in the other,
/// and where a shape has the same phase as its surroundings. O(n log n) for n points at distances
/// that do not differ much.
template <class Real>
std::optional<ShapeNetwork> network_of(std::span<const Shape> shapes, const Lattice& lattice,
                                       const InitialOptions& options, InputReport& report);

} // namespace dsc::initial
