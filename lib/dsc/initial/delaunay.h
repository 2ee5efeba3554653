// SPDX-License-Identifier: MIT
// Constrained Delaunay by flips (C. L. Lawson, "Software for C1 surface interpolation", 1977), with
// the exact in-circle test: each flip lowers the lifted surface, so the flips come to an end. The
// slack that movement needs [tolerances.h] is for inexact tests only.
#pragma once

#include "dsc/base/predicates.h"
#include "dsc/initial/star.h"
#include "dsc/operations/edge_flip.h"

#include <vector>

namespace dsc::initial {

/// Whether the edge opposite to `corner` is not constrained and a flip would make it Delaunay.
template <class Real>
bool wants_flip(const Complex<Real>& complex, Corner corner) {
    const Corner other = complex.twin(corner);
    if (complex.phase_at(corner) != complex.phase_at(other)) {
        return false; // interface, or the domain boundary
    }
    const auto at = [&](Corner c) { return complex.position(Vertex{complex.vertex(c)}); };
    return in_circle<Real>(at(corner), at(next(corner)), at(prev(corner)), at(other)) > 0;
}

/// Flips until all edges opposite to the corners on `stack`, and those that the flips touch, are
/// constrained Delaunay; empties the stack. Returns the number of flips.
template <class Real>
std::size_t legalise(Complex<Real>& complex, std::vector<Corner>& stack) {
    const Submesh whole = whole_submesh(complex);
    std::size_t flips = 0;
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
        ++flips;
        for (const Corner c : {corner, prev(corner), other, prev(other)}) {
            stack.push_back(c);
        }
    }
    return flips;
}

/// Puts the link of a vertex and its spokes on the stack.
template <class Real>
void push_star(const Complex<Real>& complex, std::uint32_t vertex, std::vector<Corner>& stack) {
    visit_star(complex, vertex, [&](Corner c) {
        stack.push_back(c);
        stack.push_back(next(c));
    });
}

} // namespace dsc::initial
