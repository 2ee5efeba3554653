// SPDX-License-Identifier: MIT
// Two edges of the interface that face each other across a film: whether they do, and whether the
// flow squeezes the film.
#pragma once

#include "topology/region.h"

namespace dsc {

/// Whether the two half-edges face each other across a film of the phase on their left. O(1).
template <class Real>
[[nodiscard]] bool faces(const Complex<Real>& complex, Corner one, Corner other);

/// Whether both half-edges lie on a seam. Where a film has opened, the two ends of its seam also
/// face each other, at a distance as small as the film's thickness. The phase between them is not a
/// film, unless the ends block each other. O(1).
template <class Real>
[[nodiscard]] bool are_ends_of_seam(const TopologyWork<Real>& work, Corner one, Corner other);

/// Whether the flow takes area from the film between the two half-edges, or they block each other;
/// `other` on the domain boundary is replaced by the mirror image of `one`. O(1).
template <class Real>
[[nodiscard]] bool is_squeezed(const TopologyWork<Real>& work, Corner one, Corner other);

} // namespace dsc
