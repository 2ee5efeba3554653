// SPDX-License-Identifier: MIT
// What the initial complex of a network of curves is asked for, checked and made ready: rounded to
// the scalar and cut into pieces.
#pragma once

#include "dsc/initial/input/domain_check.h"

namespace dsc::initial {

/// A curve without an edge longer than the target; a closed one repeats its first point at the end.
/// Two of them, or two parts of one, have nothing in common but ends. Coordinates are representable
/// in the scalar of the complex.
struct CheckedCurve {
    std::vector<Point<double>> points;
    Phase left = exterior_phase;
    Phase right = exterior_phase;
};

struct CheckedCurves {
    Lattice lattice;
    std::vector<CheckedCurve> curves;
};

/// Throws InputError as `initial_complex` documents, except for phases that contradict each other:
/// `fill_faces` finds these.
template <class Real>
CheckedCurves check_curves(const Rectangle& domain, std::span<const Curve> curves,
                           const InitialOptions& options);

} // namespace dsc::initial
