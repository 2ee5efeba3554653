// SPDX-License-Identifier: MIT
// Where phases meet, as curves derived from the phases (thesis, section 8.6). `interface_curves`
// cuts the whole interface at its junctions; `outlines` gives the closed loops around one phase, or
// around several taken together. Thread-safe while nobody writes.
#pragma once

#include "dsc/complex/circulate.h"
#include "dsc/complex/ranges.h"

#include <span>
#include <utility>
#include <vector>

namespace dsc {

/// Calls `visit(std::span<const Corner>)` for each closed loop of the half-edges for which
/// `is_edge(corner)` holds: those around a region, with the region on their left and not on their
/// right. At each vertex a loop continues with the next edge of the same fan of triangles. Each
/// half-edge is named by the corner opposite to it, in the triangle inside; a loop begins with its
/// smallest corner, and loops come in the order of these. O(triangles).
template <class Real, class IsEdge, class Visit>
void for_each_loop(const Complex<Real>& complex, IsEdge is_edge, Visit visit) {
    std::vector<std::uint8_t> done(4 * std::size_t{complex.triangle_bound()}, 0);
    std::vector<Corner> loop;
    for (const Triangle t : triangles(complex)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            Corner c = corner_of(t.id, i);
            if (done[c] != 0 || !is_edge(c)) {
                continue;
            }
            loop.clear();
            for (; done[c] == 0; c = next_along(complex, c, is_edge)) {
                done[c] = 1;
                loop.push_back(c);
            }
            visit(std::span<const Corner>(loop));
        }
    }
}

/// The loops around the components of all phases, the exterior included, counter-clockwise around
/// each.
template <class Real, class Visit>
void for_each_outline(const Complex<Real>& complex, Visit visit) {
    for_each_loop(
        complex, [&](Corner c) { return complex.phase_at(c) != complex.phase_at(complex.twin(c)); },
        visit);
}

/// A piece of the interface with the same two phases along its whole length.
struct InterfaceCurve {
    /// In order; each is joined to the one before by an interface edge. A closed curve does not
    /// repeat its first vertex. An open one has two vertices or more; they are distinct, except for
    /// the ends of a curve that returns to its junction.
    std::vector<Vertex> vertices;
    bool is_closed = false;       ///< without ends
    Phase left = exterior_phase;  ///< the larger one; at the domain boundary, the phase inside
    Phase right = exterior_phase; ///< `border_phase` at the domain boundary

    friend bool operator==(const InterfaceCurve&, const InterfaceCurve&) = default;
};

/// The interface as curves. Each interface edge is in exactly one of them: edges between two
/// phases, and edges of the domain boundary with a phase other than `exterior_phase` inside. A
/// curve ends at vertices with more or fewer than two interface edges (junctions, points where a
/// phase touches itself), and a curve between two phases ends at the domain boundary. The domain
/// boundary has separate curves of its own; they continue through its corners.
///
/// Curves come in the order of the smallest corner of the triangles on their left; a closed curve
/// begins where the edge opposite to that corner does. So the same complex gives the same lists,
/// but `renumber` may change their order. O(triangles).
template <class Real>
[[nodiscard]] std::vector<InterfaceCurve> interface_curves(const Complex<Real>& complex);

/// A closed curve; the first vertex is not repeated at the end.
using VertexLoop = std::vector<Vertex>;

/// The outlines of the phases for which `belongs(phase)` holds, taken together: counter-clockwise
/// around them, clockwise around holes, with edges of the domain boundary where they reach it.
/// Where two triangles of these phases meet only at a vertex, two outlines touch, or one passes
/// through it twice. In the order of `for_each_loop`. O(triangles).
template <class Real, class Belongs>
[[nodiscard]] std::vector<VertexLoop> outlines_where(const Complex<Real>& complex,
                                                     Belongs belongs) {
    std::vector<VertexLoop> loops;
    const auto is_inside = [&](Phase phase) { return phase != border_phase && belongs(phase); };
    const auto is_edge = [&](Corner c) {
        return is_inside(complex.phase_at(c)) && !is_inside(complex.phase_at(complex.twin(c)));
    };
    for_each_loop(complex, is_edge, [&](std::span<const Corner> corners) {
        VertexLoop& loop = loops.emplace_back();
        for (const Corner c : corners) {
            loop.push_back(Vertex{complex.vertex(next(c))});
        }
    });
    return loops;
}

/// The outlines of one phase.
template <class Real>
[[nodiscard]] std::vector<VertexLoop> outlines(const Complex<Real>& complex, Phase phase) {
    return outlines_where(complex, [phase](Phase other) { return other == phase; });
}

} // namespace dsc
