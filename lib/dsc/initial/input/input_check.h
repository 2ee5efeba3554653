// SPDX-License-Identifier: MIT
// What the initial complex is asked for, checked and made ready: outlines rounded to the scalar,
// cut into pieces and counter-clockwise.
#pragma once

#include "dsc/initial/input/domain_check.h"

namespace dsc::initial {

/// A checked outline, counter-clockwise, with no edge longer than the target and its first point
/// repeated at the end; no two outlines cross or touch. Coordinates are representable in the scalar
/// of the complex.
struct Outline {
    std::vector<Point<double>> points;
    Phase phase = exterior_phase;
};

struct CheckedInput {
    Lattice lattice;
    std::vector<Outline> outlines;
};

/// Throws InputError as `initial_complex` documents.
template <class Real>
CheckedInput check_input(const Rectangle& domain, std::span<const Shape> shapes,
                         const InitialOptions& options);

} // namespace dsc::initial
