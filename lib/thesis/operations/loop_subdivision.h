// SPDX-License-Identifier: MIT
// Loop subdivision (thesis, sections 4.2 and 7.2): a triangle cut in four at the midpoints of its
// edges, and the triangles across them in two.
#pragma once

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/submesh.h"

#include <array>

namespace dsc {

/// Whether the triangle may be subdivided: none of its edges may be on the interface or on the
/// submesh boundary; edges of the domain boundary are split as well (thesis, section 6.5). O(1).
/// Exact.
template <class Real>
Verdict loop_subdivision_guard(const Complex<Real>& complex, Triangle triangle,
                               const Region& region = {});

/// What a subdivision did.
struct LoopSubdivisionResult {
    Verdict verdict = Verdict::legal; ///< `legal`, or what stopped it
    /// If legal: the new vertices a, b, c on the edges opposite to the triangle's vertices v[0],
    /// v[1], v[2] (figure 7.2).
    std::array<Vertex, 3> vertices{};
};

namespace detail {
template <class Real>
LoopSubdivisionResult loop_subdivision(const Submesh<Real>& submesh, Triangle triangle);
} // namespace detail

/// Subdivides the triangle if that is legal. The part in the middle keeps its id. The parts inherit
/// phase and triangle attributes, the halves of an edge its attributes; new edges get the defaults,
/// the attributes of new vertices are blended at the midpoint. O(1). Thread-safe for disjoint
/// submeshes.
LoopSubdivisionResult loop_subdivision(Editable auto&& where, Triangle triangle) {
    return detail::loop_subdivision(Submesh(where), triangle);
}

} // namespace dsc
