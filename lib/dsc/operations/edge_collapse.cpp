// SPDX-License-Identifier: MIT
#include "dsc/operations/edge_collapse.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/circulate.h"
#include "dsc/geometry/predicates.h"
#include "dsc/geometry/side.h"

namespace dsc {

namespace {

// True if link(v) and link(keep) have a vertex or an edge in common that is not in link(e), e being
// the edge from v to keep.
template <class Real>
bool links_meet_elsewhere(const Complex<Real>& complex, std::uint32_t v, std::uint32_t keep,
                          std::uint32_t apex_a, std::uint32_t apex_b) {
    const auto any_corner = [&](std::uint32_t centre, auto test) {
        return find_corner(complex, Vertex{centre}, [&](Corner c) {
                   return test(complex.vertex(next(c)), complex.vertex(prev(c)));
               }) != no_id;
    };
    const auto is_common = [&](std::uint32_t w) {
        return w != keep && w != apex_a && w != apex_b &&
               any_corner(keep, [w](std::uint32_t p, std::uint32_t q) { return p == w || q == w; });
    };
    // A common edge needs two common vertices: only (apex_a, apex_b) remains to be checked.
    const auto joins_apexes = [&](std::uint32_t p, std::uint32_t q) {
        return (p == apex_a && q == apex_b) || (p == apex_b && q == apex_a);
    };
    return any_corner(v, [&](auto p, auto q) { return is_common(p) || is_common(q); }) ||
           (apex_b != no_id && any_corner(v, joins_apexes) && any_corner(keep, joins_apexes));
}

} // namespace

template <class Real>
Verdict edge_collapse_guard(const Complex<Real>& complex, const Region& region, Corner corner,
                            rewire::Vanishing end, JunctionRule junctions, BoundaryRule boundary) {
    const bool ccw = end == rewire::Vanishing::next;
    const Corner other = complex.twin(corner);
    const std::uint32_t v = complex.vertex(ccw ? next(corner) : prev(corner));
    const std::uint32_t keep = complex.vertex(ccw ? prev(corner) : next(corner));
    // An edge outside the submesh is refused before anything else is tested: another submesh may be
    // rewriting the stars of its ends at this moment.
    if (!owns(complex, region, v) || !owns(complex, region, keep) ||
        (!owns_triangle(complex, region, triangle_of(corner)) &&
         (is_border(other) || !owns_triangle(complex, region, triangle_of(other))))) {
        return Verdict::on_submesh_boundary;
    }
    const StarSummary summary = inspect(complex, region, v);
    const auto at = [&](std::uint32_t id) { return complex.position(Vertex{id}); };

    const auto may_leave = [&](const Point<Real>& from, const Point<Real>& to) {
        return boundary == BoundaryRule::exact ? orientation<Real>(from, at(v), to) == 0
                                               : may_leave_side<Real>(from, at(v), to);
    };
    if (summary.on_boundary && (!is_border(other) || complex.is_boundary_feature(Vertex{v}) ||
                                !may_leave(at(summary.first), at(summary.last)))) {
        return Verdict::on_boundary;
    }
    if (!summary.owned) {
        return Verdict::on_submesh_boundary;
    }
    if (summary.interface_edges > 0 &&
        ((summary.interface_edges != 2 && junctions == JunctionRule::kept) ||
         (!is_interface_pair(complex.phase_at(corner), complex.phase_at(other)) &&
          !(junctions == JunctionRule::may_merge && is_border(other))))) {
        return Verdict::on_interface;
    }
    if (complex.is_locked(Vertex{v})) {
        return Verdict::locked;
    }
    if ((is_constrained(complex, next(corner)) && is_constrained(complex, prev(corner))) ||
        (!is_border(other) && is_constrained(complex, next(other)) &&
         is_constrained(complex, prev(other)))) {
        return Verdict::changes_topology;
    }
    const std::uint32_t apex_a = complex.vertex(corner);
    const std::uint32_t apex_b = is_border(other) ? no_id : complex.vertex(other);
    if (links_meet_elsewhere(complex, v, keep, apex_a, apex_b)) {
        return Verdict::changes_topology;
    }
    const auto turns_over = [&](Corner c) {
        const std::uint32_t p = complex.vertex(next(c));
        const std::uint32_t q = complex.vertex(prev(c));
        return p != keep && q != keep &&
               (orientation<Real>(at(keep), at(p), at(q)) <= 0 ||
                (boundary == BoundaryRule::smooth && is_flat<Real>(at(keep), at(p), at(q))));
    };
    return find_corner(complex, Vertex{v}, turns_over) == no_id ? Verdict::legal : Verdict::inverts;
}

template <class Real>
Verdict star_collapse_guard(const Complex<Real>& complex, const Star<Real>& star, std::uint32_t i) {
    if (complex.is_locked(Vertex{star.vertex})) {
        return Verdict::locked;
    }
    const std::uint32_t before = i == 0 ? star.size - 1 : i - 1;
    const auto px = static_cast<double>(star.x[i]);
    const auto py = static_cast<double>(star.y[i]);
    for (std::uint32_t j = 0; j < star.size; ++j) {
        if (j != i && j != before &&
            orientation(px, py, static_cast<double>(star.x[j]), static_cast<double>(star.y[j]),
                        static_cast<double>(star.x_next[j]),
                        static_cast<double>(star.y_next[j])) <= 0) {
            return Verdict::inverts;
        }
    }
    return Verdict::legal;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Verdict star_collapse_guard(const Complex<Real>&, const Star<Real>&, std::uint32_t);  \
    template Verdict edge_collapse_guard(const Complex<Real>&, const Region&, Corner,              \
                                         rewire::Vanishing, JunctionRule, BoundaryRule);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
