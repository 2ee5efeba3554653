// SPDX-License-Identifier: MIT
// From a complex to the outlines that are measured.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/motion/interpolation.h"
#include "shapes/outline.h"

#include <optional>

namespace dsc::scenes {

struct OutlineOptions {
    /// How the curve runs between two vertices: with `Reading::cubic` each edge becomes `samples`
    /// chords of its cubic, which lie 1 / samples^2 times as far from it as the edge itself.
    Reading reading = Reading::chords;
    int samples = 32;
    std::optional<Phase> phase = {}; ///< around this phase; none: around all but the exterior
};

/// The closed curves around a phase, or between the exterior and all others, counter-clockwise
/// around what they enclose; its domain edges belong to them. O(n).
template <class Real>
[[nodiscard]] std::vector<Outline> interface_outlines(const Complex<Real>& complex,
                                                      const OutlineOptions& options = {});

} // namespace dsc::scenes
