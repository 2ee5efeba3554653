// SPDX-License-Identifier: MIT
// Whether contact distances suit the phases of a complex.
#pragma once

#include "dsc/complex/complex.h"
#include "topology/options.h"

namespace dsc {

/// Throws InputError if a contact distance of several edge lengths (`is_wide`) is larger than one
/// of its two phases: than the diameter of a disc with the area of that phase. Phases without a
/// triangle do not count. O(triangles + pairs) if there is such a distance, else O(pairs).
template <class Real>
void check_contact(const Complex<Real>& complex, const TopologyOptions<Real>& options,
                   Real edge_length);

/// Whether any contact distance differs between the two options. O(pairs).
template <class Real>
[[nodiscard]] bool differ_in_contact(const TopologyOptions<Real>& one,
                                     const TopologyOptions<Real>& other);

} // namespace dsc
