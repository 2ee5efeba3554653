// SPDX-License-Identifier: MIT
// From a complex to the figures that judge it.
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

struct MeshQuality {
    double min_quality = 1; ///< equation 4
    double min_angle_deg = 60;
    double median_angle_deg = 60; ///< of the triangles' smallest angles
    std::uint64_t inverted = 0;   ///< not strictly positive, by the exact predicate
};

/// O(n).
template <class Real>
[[nodiscard]] MeshQuality measure_quality(const Complex<Real>& complex);

/// Only `min_quality` and `inverted`: cheap enough for every step. O(n).
template <class Real>
[[nodiscard]] MeshQuality measure_worst(const Complex<Real>& complex);

} // namespace dsc::scenes
