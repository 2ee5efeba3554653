// SPDX-License-Identifier: MIT
// Connected components of phases. Triangles of one phase that share an edge are in the same
// component; those that share a vertex alone are not.
#pragma once

#include "dsc/complex/circulate.h"
#include "dsc/complex/ranges.h"

#include <span>
#include <vector>

namespace dsc {

/// One connected component of a phase.
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

/// The components of all phases, the exterior included. O(triangles). Thread-safe while nobody
/// writes.
template <class Real>
[[nodiscard]] Components components(const Complex<Real>& complex);

/// Calls `visit(std::span<const Corner>)` for each outline of each component, counter-clockwise
/// around it: the corners opposite to its half-edges, in order, each in the triangle on the inside.
/// Outlines come in the order of their smallest corner. O(triangles).
template <class Real, class Visit>
void for_each_outline(const Complex<Real>& complex, Visit visit) {
    const auto is_edge = [&](Corner c) {
        return complex.phase_at(c) != complex.phase_at(complex.twin(c));
    };
    std::vector<std::uint8_t> done(4 * std::size_t{complex.triangle_bound()}, 0);
    std::vector<Corner> outline;
    for (const Triangle t : triangles(complex)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            Corner c = corner_of(t.id, i);
            if (done[c] != 0 || !is_edge(c)) {
                continue;
            }
            outline.clear();
            while (done[c] == 0) {
                done[c] = 1;
                outline.push_back(c);
                c = next_along(complex, c, is_edge);
            }
            visit(std::span<const Corner>(outline));
        }
    }
}

} // namespace dsc
