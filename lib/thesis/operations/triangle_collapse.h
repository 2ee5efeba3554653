// SPDX-License-Identifier: MIT
// Triangle collapse (thesis, chapter 13, figure 13.1): the triangle and its three neighbours
// vanish, and its three vertices become one.
#pragma once

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/submesh.h"

#include <optional>

namespace dsc {

/// The changes of the interface that a triangle collapse may make.
enum class InterfaceRule : std::uint8_t {
    keep,   ///< at most one of the three vertices is on the interface, and it stays where it is
    change, ///< phases may meet, split or vanish; removes small triangles between two sheets
};

/// The position of the collapsed triangle, and the allowed changes.
template <class Real>
struct TriangleCollapseOptions {
    /// The position of the resulting vertex, in units of the domain. By default that of the vertex
    /// that may not move: on the domain boundary, on an interface that is kept, or locked. Without
    /// such a vertex, the place of the only one on the interface, or of the only feature; otherwise
    /// the centroid.
    std::optional<Point<Real>> place = {};
    InterfaceRule interface = InterfaceRule::keep; ///< whether phases may change
};

/// Whether the triangle may collapse. At most one of its vertices may be on the domain boundary, on
/// an interface that is kept, or locked, and the place must be there. Answers not_a_simplex,
/// on_boundary, on_submesh_boundary (unless the submesh owns the stars of all three vertices and
/// the place), on_interface, locked, changes_topology (a vertex outside would be joined to the new
/// one twice, or two triangles would fall onto each other) or inverts. Throws InputError if the
/// place is not finite. O(sum of degrees, squared). Exact.
template <class Real>
Verdict triangle_collapse_guard(const Complex<Real>& complex, Triangle triangle,
                                const TriangleCollapseOptions<Real>& options = {},
                                const Region& region = {});

/// What a triangle collapse did.
struct TriangleCollapseResult {
    Verdict verdict = Verdict::legal; ///< `legal`, or what stopped it
    Vertex vertex;                    ///< the one that remains, if legal
};

namespace detail {
template <class Real>
TriangleCollapseResult triangle_collapse(const Submesh<Real>& submesh, Triangle triangle,
                                         const TriangleCollapseOptions<Real>& options);
} // namespace detail

/// Collapses the triangle if that is legal: two edge collapses, as the thesis suggests, and a
/// movement, which are counted and logged as such. The vertex that may not move remains; if all may
/// move, the only one on the interface, the only feature, or the one with the smallest id. It keeps
/// its attributes; data of edges and triangles follow as in edge collapses. Never needs a free id.
/// Thread-safe for disjoint submeshes.
template <Editable Where>
TriangleCollapseResult
triangle_collapse(Where&& where, Triangle triangle,
                  const TriangleCollapseOptions<ScalarOf<Where>>& options = {}) {
    return detail::triangle_collapse(Submesh(where), triangle, options);
}

} // namespace dsc
