// SPDX-License-Identifier: MIT
// From a complex to the figures that judge it.
#pragma once

#include "dsc/complex/complex.h"
#include "scenes/outline.h"

namespace dsc::scenes {

/// The closed curves between the exterior phase and all others, counter-clockwise around these;
/// domain edges of other phases belong to them. O(n).
template <class Real>
[[nodiscard]] std::vector<Outline> interface_outlines(const Complex<Real>& complex);

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
