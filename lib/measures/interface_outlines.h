// SPDX-License-Identifier: MIT
// The outlines of a complex, for measures.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/motion/interpolation.h"
#include "shapes/outline.h"

#include <optional>

namespace dsc::scenes {

struct OutlineOptions {
    /// The curve between two vertices: with `Reading::cubic` each edge becomes `samples` chords of
    /// its cubic, whose distance from the cubic is 1 / samples^2 of that of the edge.
    Reading reading = Reading::chords;
    int samples = 32;
    std::optional<Phase> phase = {}; ///< of this phase; none: of all but the exterior
};

/// The closed curves around a phase, or between the exterior and all others, counter-clockwise
/// around the enclosed region; they include edges on the domain boundary. O(n).
template <class Real>
[[nodiscard]] std::vector<Outline> interface_outlines(const Complex<Real>& complex,
                                                      const OutlineOptions& options = {});

} // namespace dsc::scenes
