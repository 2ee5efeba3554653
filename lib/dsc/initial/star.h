// SPDX-License-Identifier: MIT
// Walking about a vertex of any degree.
#pragma once

#include "dsc/complex/complex.h"

namespace dsc::initial {

/// Calls visit(corner at the vertex) for each triangle of its star: counter-clockwise, an open star
/// from its clockwise end. O(degree).
template <class Real, class Visit>
void visit_star(const Complex<Real>& complex, std::uint32_t vertex, Visit visit) {
    Corner start = complex.vertices[vertex].corner;
    if (start == no_id) {
        return;
    }
    const Corner given = start;
    for (Corner back = complex.twin(prev(start)); !is_border(back);
         back = complex.twin(prev(start))) {
        start = prev(back);
        if (start == given) {
            break;
        }
    }
    Corner c = start;
    while (true) {
        visit(c);
        const Corner across = complex.twin(next(c));
        if (is_border(across)) {
            return;
        }
        c = next(across);
        if (c == start) {
            return;
        }
    }
}

/// Calls visit(vertex id) for each vertex of the link.
template <class Real, class Visit>
void visit_link(const Complex<Real>& complex, std::uint32_t vertex, Visit visit) {
    visit_star(complex, vertex, [&](Corner c) {
        visit(complex.vertex(next(c)));
        if (is_border(complex.twin(next(c)))) {
            visit(complex.vertex(prev(c)));
        }
    });
}

} // namespace dsc::initial
