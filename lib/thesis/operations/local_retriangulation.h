// SPDX-License-Identifier: MIT
// Local retriangulation (thesis, sections 4.2 and 7.3): the triangles around one triangle are
// removed and the polygon that they leave is triangulated again, without the vertices that were
// inside.
#pragma once

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/submesh.h"

#include <cstdint>
#include <string_view>

namespace dsc {

/// The method by which a polygon is cut into triangles.
enum class RetriangulationMethod : std::uint8_t {
    ear_clipping, ///< the thesis's method; may leave slivers
    /// Ear clipping, then flips until it is the constrained Delaunay triangulation (C. L. Lawson,
    /// "Software for C1 surface interpolation", 1977), as the thesis asks in chapter 13.
    delaunay,
};

[[nodiscard]] constexpr std::string_view to_string(RetriangulationMethod method) {
    return method == RetriangulationMethod::ear_clipping ? "ear_clipping" : "delaunay";
}

/// Whether the surroundings of the triangle may be retriangulated: none of its vertices is on the
/// interface or on the submesh boundary, none that would vanish is locked, and the trace is one
/// simple polygon that ears can be cut from (thesis, section 6.5). Vertices of the domain boundary
/// stay. O(n^2) for a polygon of n. Exact.
template <class Real>
Verdict local_retriangulation_guard(const Complex<Real>& complex, Triangle triangle,
                                    const Region& region = {});

/// What a retriangulation did.
struct RetriangulationResult {
    Verdict verdict = Verdict::legal;    ///< `legal`, or what stopped it
    std::uint32_t vertices_removed = 0;  ///< those that were inside
    std::uint32_t triangles_removed = 0; ///< old minus new ones
};

namespace detail {
template <class Real>
RetriangulationResult local_retriangulation(const Submesh<Real>& submesh, Triangle triangle,
                                            RetriangulationMethod method);
} // namespace detail

/// Retriangulates if that is legal. The new triangles reuse ids of the old ones, the given
/// triangle's first, and inherit its phase and attributes; new edges get the attributes' defaults,
/// the polygon's keep theirs. Never needs a free id. Thread-safe for disjoint submeshes; allocates
/// only until the scratch of the calling thread has grown to the largest polygon.
RetriangulationResult
local_retriangulation(Editable auto&& where, Triangle triangle,
                      RetriangulationMethod method = RetriangulationMethod::ear_clipping) {
    return detail::local_retriangulation(Submesh(where), triangle, method);
}

} // namespace dsc
