// SPDX-License-Identifier: MIT
// The target length of edges, kept at each vertex: an attribute of the complex, so that it follows
// splits, renumbering and copies. Measured for the whole mesh at the start, and after what the
// update of single stars does not see.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/sizes/options.h"

#include <limits>

namespace dsc {

/// What is known at a vertex. New ones that are on no edge know nothing.
template <class Real>
struct VertexSize {
    Real length = std::numeric_limits<Real>::infinity();   ///< target of edges
    Real distance = std::numeric_limits<Real>::infinity(); ///< to the interface; kept if needed
};

template <class Real>
void archive(Archive& archive, VertexSize<Real>& size) {
    archive(size.length, size.distance);
}

/// The attribute that holds the targets.
template <class Real>
using SizeField = VertexAttribute<VertexSize<Real>>;

/// The attribute, created if there is none yet.
template <class Real>
SizeField<Real>& size_field(Complex<Real>& complex);

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
