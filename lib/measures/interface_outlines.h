// SPDX-License-Identifier: MIT
// From a complex to the outlines that are measured.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/motion/interpolation.h"
#include "shapes/outline.h"

namespace dsc::scenes {

/// The closed curves between the exterior phase and all others, counter-clockwise around these;
/// domain edges of other phases belong to them. O(n).
template <class Real>
[[nodiscard]] std::vector<Outline> interface_outlines(const Complex<Real>& complex);

/// The same curves read between their vertices: with `Reading::cubic` each edge becomes `samples`
/// chords of its cubic, which differ from it by 1 / samples^2 of what the edge itself does. O(n).
template <class Real>
[[nodiscard]] std::vector<Outline> interface_outlines(const Complex<Real>& complex, Reading reading,
                                                      int samples = 32);

} // namespace dsc::scenes
