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

/// The same curves as interpolated between their vertices: with `Reading::cubic` each edge becomes
/// `samples` chords of its cubic; their distance from it is 1 / samples^2 of that of the edge
/// itself. O(n).
template <class Real>
[[nodiscard]] std::vector<Outline> interface_outlines(const Complex<Real>& complex, Reading reading,
                                                      int samples = 32);

} // namespace dsc::scenes
