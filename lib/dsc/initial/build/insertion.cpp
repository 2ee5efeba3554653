// SPDX-License-Identifier: MIT
#include "dsc/initial/build/insertion.h"

#include "dsc/base/error.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/circulate.h"
#include "dsc/geometry/predicates.h"
#include "dsc/operations/edge_flip.h"

namespace dsc::initial {

namespace {

// Whether the edge opposite to `corner` is not constrained and certainly not Delaunay.
template <class Real>
bool wants_flip(const Complex<Real>& complex, Corner corner) {
    if (is_constrained(complex, corner)) {
        return false;
    }
    const auto at = [&](Corner c) -> Point<double> {
        return complex.position(Vertex{complex.vertex(c)}).template cast<double>();
    };
    return certainly_in_circle(at(corner), at(next(corner)), at(prev(corner)),
                               at(complex.twin(corner)));
}

// Flips until all edges opposite to the corners on `stack`, and those that the flips touch, are
// constrained Delaunay; empties the stack.
template <class Real>
void legalise(Complex<Real>& complex, std::vector<Corner>& stack) {
    const Submesh whole = Submesh(complex);
    while (!stack.empty()) {
        const Corner corner = stack.back();
        stack.pop_back();
        if (!complex.is_alive(Triangle{triangle_of(corner)}) || !wants_flip(complex, corner)) {
            continue;
        }
        const Corner other = complex.twin(corner);
        if (edge_flip(whole, corner) != Verdict::legal) {
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

} // namespace

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

template <class Real>
WalkEnd locate(const Complex<Real>& complex, std::uint32_t start, const Point<Real>& point) {
    const WalkEnd end = walk(complex, Triangle{start}, point, 8 * complex.triangles.size() + 64,
                             [&](Corner c) { return !is_constrained(complex, c); });
    if (end.kind == WalkEnd::Kind::lost) {
        throw InvariantError("initial_complex: no triangle found at " + to_text(point));
    }
    return end;
}

template <class Real>
std::uint32_t insert_point(Complex<Real>& complex, const WalkEnd& place, const Point<Real>& point,
                           std::vector<Corner>& stack) {
    if (place.kind == WalkEnd::Kind::stopped || place.kind == WalkEnd::Kind::lost) {
        throw InvariantError("initial_complex: no place found for the point " + to_text(point));
    }
    if (place.kind == WalkEnd::Kind::vertex) {
        return complex.vertex(place.corner);
    }
    Corner corner = place.corner;
    if (place.kind == WalkEnd::Kind::triangle) {
        while (is_border(complex.twin(corner))) {
            corner = next(corner);
        }
    }
    const Corner other = complex.twin(corner);
    const std::uint32_t m = complex.take_vertex(complex.ids);
    const std::uint32_t t2 = complex.take_triangle(complex.ids);
    const std::uint32_t u2 = is_border(other) ? no_id : complex.take_triangle(complex.ids);
    rewire::split(complex, complex.journal, corner, m, point, t2, u2);
    if (place.kind == WalkEnd::Kind::triangle) {
        // Divides a triangle into three: splits an edge as if m were on it, then flips the edge
        // from m into the triangle beyond, which restores the split edge. The triangle beyond is
        // then u2, and u lies on this side.
        rewire::flip(complex, complex.journal, next(other));
        complex.triangles[triangle_of(other)].phase = complex.phase_at(corner);
    }
    legalise_star(complex, m, stack);
    return m;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void legalise_star(Complex<Real>&, std::uint32_t, std::vector<Corner>&);              \
    template WalkEnd locate(const Complex<Real>&, std::uint32_t, const Point<Real>&);              \
    template std::uint32_t insert_point(Complex<Real>&, const WalkEnd&, const Point<Real>&,        \
                                        std::vector<Corner>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc::initial
