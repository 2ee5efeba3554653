// SPDX-License-Identifier: MIT
// Constrained Delaunay by flips (C. L. Lawson, "Software for C1 surface interpolation", 1977). An
// edge is flipped only where the in-circle test is certain: each flip lowers the lifted surface, so
// the flips come to an end without a slack.
#pragma once

#include "dsc/complex/circulate.h"
#include "dsc/geometry/predicates.h"
#include "dsc/initial/build/zone.h"
#include "dsc/operations/edge_flip.h"

#include <vector>

namespace dsc::initial {

/// Whether the edge opposite to `corner` is not constrained and certainly not Delaunay.
template <class Real>
bool wants_flip(const Complex<Real>& complex, Corner corner) {
    const Corner other = complex.twin(corner);
    if (complex.phase_at(corner) != complex.phase_at(other)) {
        return false; // interface, or the domain boundary
    }
    const auto at = [&](Corner c) -> Point<double> {
        return complex.position(Vertex{complex.vertex(c)}).template cast<double>();
    };
    return certainly_in_circle(at(corner), at(next(corner)), at(prev(corner)), at(other));
}

/// Flips until all edges opposite to the corners on `stack`, and those that the flips touch, are
/// constrained Delaunay; empties the stack. Vertices whose stars change are unsettled.
template <class Real>
void legalise(Complex<Real>& complex, std::vector<Corner>& stack) {
    const Submesh whole = whole_submesh(complex);
    while (!stack.empty()) {
        const Corner corner = stack.back();
        stack.pop_back();
        if (!complex.is_alive(Triangle{triangle_of(corner)}) || !wants_flip(complex, corner)) {
            continue;
        }
        const Corner other = complex.twin(corner);
        if (edge_flip(complex, whole, corner) != Verdict::legal) {
            continue;
        }
        for (const Corner c : {corner, other}) {
            stack.push_back(c);
            stack.push_back(prev(c));
            complex.vertices[complex.vertex(c)].slot = unsettled;
            complex.vertices[complex.vertex(next(c))].slot = unsettled;
        }
    }
}

/// Restores the Delaunay property after the star of a vertex has changed.
template <class Real>
void legalise_star(Complex<Real>& complex, std::uint32_t vertex, std::vector<Corner>& stack) {
    for_each_corner(complex, Vertex{vertex}, [&](Corner c) {
        stack.push_back(c);
        stack.push_back(next(c));
        complex.vertices[complex.vertex(c)].slot = unsettled;
        complex.vertices[complex.vertex(next(c))].slot = unsettled;
        complex.vertices[complex.vertex(prev(c))].slot = unsettled;
    });
    legalise(complex, stack);
}

} // namespace dsc::initial
