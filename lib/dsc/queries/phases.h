// SPDX-License-Identifier: MIT
// Phases, and what is derived from them (thesis, section 8.6): the interface, the domain boundary,
// and the connected components. Handles must be alive. Thread-safe while nobody writes.
#pragma once

#include "dsc/complex/ranges.h"

#include <vector>

namespace dsc {

/// An edge is on the domain boundary if it has one triangle, a vertex if it has such an edge. The
/// form for a triangle asks whether one of its edges is. O(1); O(degree) for a vertex.
template <class Real>
[[nodiscard]] bool is_boundary(const Complex<Real>& complex, Vertex v);
template <class Real>
[[nodiscard]] bool is_boundary(const Complex<Real>& complex, Edge e);
template <class Real>
[[nodiscard]] bool is_boundary(const Complex<Real>& complex, Triangle t);

/// An edge is on the interface if its two triangles differ in phase, or if it is on the domain
/// boundary and its triangle's phase is not `exterior_phase` (figure 8.3); a vertex if it has such
/// an edge. The interface has no triangles (thesis, section 4.3): the form for a triangle asks
/// whether one of its edges is on it. O(1); O(degree) for a vertex.
template <class Real>
[[nodiscard]] bool is_interface(const Complex<Real>& complex, Vertex v);
template <class Real>
[[nodiscard]] bool is_interface(const Complex<Real>& complex, Edge e);
template <class Real>
[[nodiscard]] bool is_interface(const Complex<Real>& complex, Triangle t);

/// The phases that occur, ascending. O(n).
template <class Real>
[[nodiscard]] std::vector<Phase> phases(const Complex<Real>& complex);

/// The area of all triangles of a phase, summed with compensation in double. O(n).
template <class Real>
[[nodiscard]] double phase_area(const Complex<Real>& complex, Phase phase);

/// One connected component of a phase. Triangles of a phase that share an edge are in the same
/// component; those that share a vertex alone are not.
struct Component {
    Phase phase = exterior_phase; ///< of all its triangles
    std::uint32_t triangles = 0;  ///< how many
    /// Closed curves around it, the outer one included. Holes that touch at a vertex share one.
    std::uint32_t outlines = 0;
    bool touches_border = false; ///< an edge of the domain boundary belongs to it
    double area = 0;             ///< in squared units of the domain

    /// The outlines without the outer one.
    [[nodiscard]] std::uint32_t holes() const { return outlines - 1; }
};

/// All components of a complex, and which of them each triangle belongs to.
struct Components {
    std::vector<Component> list; ///< in the order of the smallest triangle of each
    /// The position in `list` of each triangle's component, by id; `no_id` where no triangle lives.
    std::vector<std::uint32_t> of;
};

/// The components of all phases, the exterior included. O(triangles).
template <class Real>
[[nodiscard]] Components components(const Complex<Real>& complex);

/// Numbers the connected parts, in the order of the smallest triangle of each. Two triangles that
/// share an edge are in one part if `joins(corner)` holds for the corner opposite to it. Calls
/// `visit(part, triangle)` for each triangle, part by part. Returns the parts by id of the
/// triangle; `no_id` where none lives. O(triangles).
template <class Real, class Joins, class Visit>
std::vector<std::uint32_t> label_parts(const Complex<Real>& complex, Joins joins, Visit visit) {
    std::vector<std::uint32_t> part_of(complex.triangle_bound(), no_id);
    std::vector<std::uint32_t> waiting;
    std::uint32_t part = 0;
    for (const Triangle first : triangles(complex)) {
        if (part_of[first.id] != no_id) {
            continue;
        }
        part_of[first.id] = part;
        waiting.push_back(first.id);
        while (!waiting.empty()) {
            const std::uint32_t t = waiting.back();
            waiting.pop_back();
            visit(part, Triangle{t});
            for (std::uint32_t i = 0; i < 3; ++i) {
                const Corner c = corner_of(t, i);
                const std::uint32_t other = triangle_of(complex.twin(c));
                if (other != border_triangle && part_of[other] == no_id && joins(c)) {
                    part_of[other] = part;
                    waiting.push_back(other);
                }
            }
        }
        ++part;
    }
    return part_of;
}

} // namespace dsc
