// SPDX-License-Identifier: MIT
// How good the triangles of a mesh are.
#pragma once

#include "dsc/complex/complex.h"

namespace dsc::scenes {

struct MeshQuality {
    double min_quality = 1; ///< equation 4
    double min_angle_deg = 60;
    double median_angle_deg = 60; ///< of the triangles' smallest angles
    std::uint64_t inverted = 0;   ///< not strictly positive, by the exact predicate
};

/// The quality of all triangles. O(n).
template <class Real>
[[nodiscard]] MeshQuality measure_quality(const Complex<Real>& complex);

/// The same with `min_quality` and `inverted` only: cheap enough for every step. O(n).
template <class Real>
[[nodiscard]] MeshQuality measure_worst(const Complex<Real>& complex);

} // namespace dsc::scenes
