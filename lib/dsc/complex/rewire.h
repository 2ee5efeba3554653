// SPDX-License-Identifier: MIT
// Connectivity, positions and phases change here, except where insertion, removal, replay and local
// retriangulation write whole triangles. Each function changes the complex, informs its attributes
// and notes the edit in a log. There are no guards here: lib/dsc/operations decides what is legal.
// O(1), collapse O(degree). Thread-safe for submeshes that own disjoint regions, each with a log of
// its own: a triangle that straddles two of them is never rewritten, except for the neighbour slot
// that faces the calling submesh.
#pragma once

#include "dsc/base/types.h"
#include "dsc/complex/complex.h"
#include "dsc/complex/records.h"
#include "dsc/geometry/points.h"
#include "dsc/geometry/triangle.h"

namespace dsc {

/// Gives the fields at `v`, the vertex attributes that sample the plane, the values at `place`, a
/// point of its star: linear in the triangle that holds it. To be called before `v` moves; other
/// attributes are not touched. `with_interface`: the interface moves `v`, not smoothing, and fields
/// that the interface advects keep their values. O(degree).
template <class Real>
void resample_fields(Complex<Real>& complex, Vertex v, const Point<Real>& place,
                     bool with_interface);

} // namespace dsc

namespace dsc::rewire {

/// Appends the record that `edit()` makes, if the log keeps records.
template <class MakeEdit>
void note(EditLog& log, MakeEdit edit) {
    if (log.readers > 0) [[unlikely]] {
        log.records.push_back(edit());
    }
}

/// The part of the first triangle in the area of both, for attributes that distribute a quantity.
template <class Real>
double area_share(const Complex<Real>& complex, const std::array<std::uint32_t, 3>& one,
                  const std::array<std::uint32_t, 3>& other) {
    const auto size = [&](const std::array<std::uint32_t, 3>& v) {
        return static_cast<double>(area<Real>(complex.position(Vertex{v[0]}),
                                              complex.position(Vertex{v[1]}),
                                              complex.position(Vertex{v[2]})));
    };
    const double first = size(one);
    return first > 0 ? first / (first + size(other)) : 0.0; // both may round to 0
}

/// Makes two corners each other's twins. The border keeps no record of its neighbours.
template <class Real>
void link(Complex<Real>& complex, Corner a, Corner b) {
    // The border is not updated: several submeshes would write there at once.
    if (!is_border(a)) {
        complex.triangles[triangle_of(a)].n[index_of(a)] = b;
    }
    if (!is_border(b)) {
        complex.triangles[triangle_of(b)].n[index_of(b)] = a;
    }
}

/// Flips the edge opposite to `c`, which has two triangles. Before: t = (a, b, w) with a at c, and
/// u = (d, w, b). After: t = (a, b, d), u = (d, w, a). Vertex a stays at c.
template <class Real>
void flip(Complex<Real>& complex, EditLog& log, Corner c) {
    const Corner o = complex.twin(c);
    const std::uint32_t t = triangle_of(c);
    const std::uint32_t u = triangle_of(o);
    const Corner tb = next(c);
    const Corner tw = prev(c);
    const Corner uw = next(o);
    const Corner ub = prev(o);
    auto& tr = complex.triangles[t];
    auto& ur = complex.triangles[u];
    const std::uint32_t a = tr.v[index_of(c)];
    const std::uint32_t b = tr.v[index_of(tb)];
    const std::uint32_t w = tr.v[index_of(tw)];
    const std::uint32_t d = ur.v[index_of(o)];
    const Corner wa = tr.n[index_of(tb)]; // across (w, a)
    const Corner bd = ur.n[index_of(uw)]; // across (b, d)
    tr.v[index_of(tw)] = d;
    ur.v[index_of(ub)] = a;
    link(complex, c, bd);
    link(complex, o, wa);
    tr.n[index_of(tb)] = uw;
    ur.n[index_of(uw)] = tb;
    complex.vertices[b].corner = tb;
    complex.vertices[w].corner = uw;
    // Edge data are stored at the corners opposite to the edge, which changed for two edges.
    complex.attributes.copy_edge(c, uw);
    complex.attributes.copy_edge(o, tb);
    complex.attributes.reset_edge(tb);
    complex.attributes.reset_edge(uw);
    complex.attributes.flip_triangles(t, u, [&] {
        return area_share(complex, {a, b, d}, {d, w, a});
    });
    ++log.counts.flips;
    note(log, [&] {
        return Edit{.kind = EditKind::flip,
                    .corner = c,
                    .ends = {Vertex{b}, Vertex{w}},
                    .apexes = {Vertex{a}, Vertex{d}}};
    });
}

/// The position of a new vertex on the edge between `a` (0) and `b` (1): the parameter of the
/// nearest point of the edge, exactly one half at the midpoint.
template <class Real>
[[nodiscard, gnu::noinline]] double split_fraction(const Point<Real>& place, const Point<Real>& a,
                                                   const Point<Real>& b) {
    return place == midpoint<Real>(a, b) ? 0.5
                                         : static_cast<double>(nearest_fraction<Real>(place, a, b));
}

/// Blends the attributes of `m`, a new vertex of the edge from `a` to `b`, by `split_fraction`.
/// Fields take the value at the place of `m`, which may lie beside the edge.
template <class Real>
[[gnu::noinline]] void blend_at(Complex<Real>& complex, Vertex m, Vertex a, Vertex b) {
    const Point<Real> place = complex.position(m);
    const Point<Real> from = complex.position(a);
    const Point<Real> to = complex.position(b);
    const double fraction = split_fraction<Real>(place, from, to);
    complex.attributes.blend_vertex(m.id, a.id, b.id, fraction);
    if (fraction != 0.5 || place != midpoint<Real>(from, to)) {
        const Point<Real> on_edge = from + static_cast<Real>(fraction) * (to - from);
        auto& record = complex.vertices[m.id];
        record.x = on_edge.x();
        record.y = on_edge.y();
        resample_fields<Real>(complex, m, place, true);
        record.x = place.x();
        record.y = place.y();
    }
}

/// Splits the edge opposite to `c` at the new vertex `m`. `t2` and `u2` are new triangles; `u2` is
/// not used if the edge is on the domain boundary. Before: t = (a, b, w), u = (d, w, b). After: t =
/// (a, b, m), t2 = (a, m, w), u = (d, w, m), u2 = (d, m, b). Vertex attributes are blended by
/// `blend_at`.
template <class Real>
void split(Complex<Real>& complex, EditLog& log, Corner c, std::uint32_t m,
           const Point<Real>& place, std::uint32_t t2, std::uint32_t u2) {
    const Corner o = complex.twin(c);
    const std::uint32_t b = complex.vertex(next(c));
    const std::uint32_t w = complex.vertex(prev(c));
    auto& attributes = complex.attributes;
    complex.vertices[m].x = place.x();
    complex.vertices[m].y = place.y();
    // The triangle at the corner, (apex, start, end), becomes (apex, start, m), and `made` (apex,
    // m, end).
    const auto cut = [&](Corner at, std::uint32_t made) {
        const Corner at_start = next(at);
        auto& kept = complex.triangles[triangle_of(at)];
        auto& other = complex.triangles[made];
        const std::uint32_t apex = kept.v[index_of(at)];
        const std::uint32_t start = kept.v[index_of(at_start)];
        const std::uint32_t end = kept.v[index_of(prev(at))];
        const Corner beyond = kept.n[index_of(at_start)]; // across (end, apex)
        other = {{apex, m, end}, {border_corner, border_corner, border_corner}, kept.phase, 0};
        attributes.split_triangle(made, triangle_of(at), [&] {
            return area_share(complex, {apex, m, end}, {apex, start, m});
        });
        attributes.copy_edge(corner_of(made, 0), at);       // (m, end): half of the edge
        attributes.copy_edge(corner_of(made, 1), at_start); // (end, apex)
        attributes.reset_edge(corner_of(made, 2));          // (apex, m)
        attributes.reset_edge(at_start);
        kept.v[index_of(prev(at))] = m;
        link(complex, corner_of(made, 1), beyond);
        kept.n[index_of(at_start)] = corner_of(made, 2);
        other.n[2] = at_start;
    };
    cut(c, t2);
    complex.vertices[m].corner = prev(c);
    complex.vertices[w].corner = corner_of(t2, 2);
    complex.vertices[b].corner = next(c);
    if (!is_border(o)) {
        cut(o, u2);
        link(complex, c, corner_of(u2, 0));
        link(complex, o, corner_of(t2, 0));
    }
    if (!attributes.empty(SimplexKind::vertex)) [[unlikely]] {
        blend_at(complex, Vertex{m}, Vertex{b}, Vertex{w});
    }
    const bool on_interface = is_interface_pair(complex.phase_at(c), complex.phase_at(o));
    ++(on_interface ? log.counts.interface_splits : log.counts.splits);
    note(log, [&] {
        return Edit{
            .kind = EditKind::split,
            .on_interface = on_interface,
            .corner = c,
            .vertex = Vertex{m},
            .ends = {Vertex{b}, Vertex{w}},
            .apexes = {Vertex{complex.vertex(c)}, Vertex{is_border(o) ? no_id : complex.vertex(o)}},
            .made = {t2, is_border(o) ? no_id : u2},
            .x = static_cast<double>(place.x()),
            .y = static_cast<double>(place.y())};
    });
}

/// Closes the gap where a triangle at the collapsed edge vanishes: its two outer neighbours are
/// linked.
template <class Real>
void close_gap(Complex<Real>& complex, Corner outer_a, Corner outer_b, std::uint32_t apex,
               std::uint32_t base) {
    if (!is_border(outer_a) && is_border(outer_b)) {
        complex.triangles[triangle_of(outer_a)].n[index_of(outer_a)] = border_corner;
    } else if (!is_border(outer_b) && is_border(outer_a)) {
        complex.triangles[triangle_of(outer_b)].n[index_of(outer_b)] = border_corner;
    } else {
        link(complex, outer_a, outer_b);
    }
    const Corner kept = is_border(outer_a) ? outer_b : outer_a;
    // The corner `kept` is opposite to the edge (apex, base).
    const bool apex_next = complex.vertex(next(kept)) == apex;
    complex.vertices[apex].corner = apex_next ? next(kept) : prev(kept);
    complex.vertices[base].corner = apex_next ? prev(kept) : next(kept);
}

/// The end of a collapsing edge that vanishes, seen from the corner opposite to the edge.
enum class Vanishing : std::uint8_t { next, prev };

/// Collapses the edge opposite to `c`: the vanishing end v leaves its triangles to the other end;
/// the one or two triangles at the edge and v itself go back to the pool. v must lie inside the
/// domain, or the edge on its boundary.
template <class Real>
void collapse(Complex<Real>& complex, EditLog& log, Corner c, Vanishing end, IdPool& pool) {
    const Corner o = complex.twin(c);
    const bool ccw = end == Vanishing::next;
    const std::uint32_t v = complex.vertex(ccw ? next(c) : prev(c));
    const std::uint32_t keep = complex.vertex(ccw ? prev(c) : next(c));
    const std::uint32_t t = triangle_of(c);
    const std::uint32_t u = triangle_of(o);
    const bool on_interface = is_interface_pair(complex.phase_at(c), complex.phase_at(o));
    ++(on_interface ? log.counts.interface_collapses : log.counts.collapses);
    note(log, [&] {
        return Edit{.kind = EditKind::collapse,
                    .on_interface = on_interface,
                    .corner = c,
                    .vertex = Vertex{v},
                    .ends = {Vertex{v}, Vertex{keep}},
                    .apexes = {Vertex{complex.vertex(c)},
                               Vertex{is_border(o) ? no_id : complex.vertex(o)}}};
    });
    // Visits the triangles about v from t on, away from the edge, up to the other triangle at the
    // edge or to the border.
    for (Corner across = complex.twin(ccw ? prev(c) : next(c));
         !is_border(across) && triangle_of(across) != u;) {
        const Corner here = ccw ? next(across) : prev(across);
        complex.triangles[triangle_of(here)].v[index_of(here)] = keep;
        across = complex.twin(ccw ? next(here) : prev(here));
    }
    // Two edges become one: the data of the kept edge stay, those of the vanishing edge are
    // dropped.
    const auto close = [&](Corner apex, Corner at_v, Corner at_keep) {
        const Corner beyond_keep = complex.twin(at_v); // across (keep, apex)
        const Corner beyond_v = complex.twin(at_keep); // across (v, apex)
        if (!is_border(beyond_v)) {
            complex.attributes.copy_edge(beyond_v, at_v);
        }
        // The neighbour that is part of the star: it belongs to the submesh.
        if (const Corner heir = is_border(beyond_v) ? beyond_keep : beyond_v; !is_border(heir)) {
            complex.attributes.merge_triangle(triangle_of(heir), triangle_of(apex));
        }
        close_gap(complex, beyond_keep, beyond_v, complex.vertex(apex), keep);
    };
    close(c, ccw ? next(c) : prev(c), ccw ? prev(c) : next(c));
    if (!is_border(o)) {
        close(o, ccw ? prev(o) : next(o), ccw ? next(o) : prev(o));
        complex.give_triangle(pool, u);
    }
    complex.give_triangle(pool, t);
    complex.give_vertex(pool, v);
}

/// Moves a vertex; another submesh may be reading its position. A vertex that a step moves stays
/// within its star, and its fields take the values at the new place. A vertex that the application
/// moves may go anywhere and keeps its values.
template <class Real>
void move(Complex<Real>& complex, EditLog& log, std::uint32_t v, Real x, Real y,
          MoveReason reason) {
    auto& record = complex.vertices[v];
    if (reason != MoveReason::application && !complex.attributes.empty(SimplexKind::vertex))
        [[unlikely]] {
        resample_fields<Real>(complex, Vertex{v}, {x, y}, reason != MoveReason::smoothing);
    }
    write_shared(record.x, x);
    write_shared(record.y, y);
    if (reason == MoveReason::flow) {
        ++log.counts.moves;
    } else if (reason == MoveReason::smoothing) {
        ++log.counts.smoothed;
    }
    note(log, [&] {
        return Edit{.kind = EditKind::move,
                    .reason = reason,
                    .vertex = Vertex{v},
                    .x = static_cast<double>(x),
                    .y = static_cast<double>(y)};
    });
}

/// Gives a triangle another phase.
template <class Real>
void relabel(Complex<Real>& complex, EditLog& log, Triangle t, Phase phase) {
    auto& record = complex.triangles[t.id];
    const Phase before = record.phase;
    record.phase = phase;
    ++log.counts.relabelled;
    note(log, [&] {
        return Edit{.kind = EditKind::relabel,
                    .corner = corner_of(t.id, 0),
                    .ends = {Vertex{record.v[0]}, Vertex{record.v[1]}},
                    .apexes = {Vertex{record.v[2]}, Vertex{}},
                    .made = {before, phase}};
    });
}

} // namespace dsc::rewire
