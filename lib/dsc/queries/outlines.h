// SPDX-License-Identifier: MIT
// Where phases meet, as curves: ordered lists of vertices, derived from the phases (thesis, section
// 8.6). `interface_curves` cuts the whole interface at its junctions; `outlines` gives the closed
// loops around one phase, or around several taken together.
#pragma once

#include "dsc/complex/circulate.h"
#include "dsc/complex/ranges.h"

#include <utility>
#include <vector>

namespace dsc {

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
/// but `renumber` may change their order. O(triangles). Thread-safe while nobody writes.
template <class Real>
[[nodiscard]] std::vector<InterfaceCurve> interface_curves(const Complex<Real>& complex);

/// A closed curve; the first vertex is not repeated at the end.
using VertexLoop = std::vector<Vertex>;

/// The outlines of the phases for which `belongs(phase)` holds, taken together: counter-clockwise
/// around them, clockwise around holes, with edges of the domain boundary where they reach it.
/// Where two triangles of these phases meet only at a vertex, two outlines touch, or one passes
/// through it twice: at each vertex they continue with the next edge of the same fan of triangles.
///
/// Outlines come in the order of their smallest corner (of the triangles inside) and begin where
/// the edge opposite to it does. O(triangles). Thread-safe while nobody writes.
template <class Real, class Belongs>
[[nodiscard]] std::vector<VertexLoop> outlines_where(const Complex<Real>& complex,
                                                     Belongs belongs) {
    std::vector<VertexLoop> loops;
    const auto is_inside = [&](Phase phase) { return phase != border_phase && belongs(phase); };
    const auto is_edge = [&](Corner c) {
        return is_inside(complex.phase_at(c)) && !is_inside(complex.phase_at(complex.twin(c)));
    };
    std::vector<std::uint8_t> done(4 * std::size_t{complex.triangle_bound()}, 0);
    for (const Triangle t : triangles(complex)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            Corner c = corner_of(t.id, i);
            if (done[c] != 0 || !is_edge(c)) {
                continue;
            }
            VertexLoop loop;
            while (done[c] == 0) {
                done[c] = 1;
                loop.push_back(Vertex{complex.vertex(next(c))});
                c = next_along(complex, c, is_edge);
            }
            loops.push_back(std::move(loop));
        }
    }
    return loops;
}

/// The outlines of one phase.
template <class Real>
[[nodiscard]] std::vector<VertexLoop> outlines(const Complex<Real>& complex, Phase phase) {
    return outlines_where(complex, [phase](Phase other) { return other == phase; });
}

} // namespace dsc
