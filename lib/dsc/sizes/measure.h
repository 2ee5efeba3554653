// SPDX-License-Identifier: MIT
// The targets of a whole mesh: at the start, and after what the update of single stars does not
// see.
#pragma once

#include "dsc/sizes/field.h"

namespace dsc {

/// The larger side of the box around the vertices. O(vertices).
template <class Real>
Real extent_of(const Complex<Real>& complex);

/// Computes the targets of all vertices from nothing, and the distances to the interface if they
/// are needed; the targets are those of the attribute `size_field`. The same complex gives the same
/// bits. O(n log n).
template <class Real>
void measure_sizes(Complex<Real>& complex, const SizeOptions<Real>& sizes, Real edge_length,
                   Real time);

} // namespace dsc
