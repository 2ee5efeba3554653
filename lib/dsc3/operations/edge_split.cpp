// SPDX-License-Identifier: MIT
#include "dsc3/operations/edge_split.h"

#include "dsc3/geometry/tet.h"
#include "dsc3/operations/smoothing.h"

#include <algorithm>

namespace dsc3 {

Vertex edge_split(Complex& complex, Workspace& work, const EdgeAt& edge, Point place) {
    Ring& ring = work.ring;
    if (!gather(complex, edge, ring)) {
        return {};
    }
    const std::uint32_t fixed = ring.closed ? 0 : complex.fixed_along(edge.a, edge.b);
    keep_on_sides(place, complex.at(edge.a), fixed);
    // The two faces of the domain boundary at the edge fix these: all three on an oblique side.
    const auto at_face = [&](std::uint32_t t, std::uint32_t opposite) {
        return fixed_at(complex, corner_of(t, index_in(complex.tets[t], opposite)));
    };
    const std::uint32_t last = ring.size - 1;
    const std::uint32_t sides = ring.closed ? 0
                                            : at_face(ring.tets[0], ring.vertices[1]) |
                                                  at_face(ring.tets[last], ring.vertices[last]);
    auto& made = work.rewiring.made;
    made.clear();
    bool on_interface = false;
    for (std::uint32_t i = 0; i < ring.size; ++i) {
        const std::uint32_t t = ring.tets[i];
        on_interface |= complex.phases[t] != complex.phases[ring.tets[0]];
        NewTet one{complex.tets[t].v, complex.phases[t]};
        NewTet two = one;
        one.v[index_in(complex.tets[t], edge.a)] = no_id;
        two.v[index_in(complex.tets[t], edge.b)] = no_id;
        for (const NewTet* tet : {&one, &two}) {
            std::array<Point, 4> p;
            for (std::uint32_t k = 0; k < 4; ++k) {
                p[k] = tet->v[k] == no_id ? place : complex.at(tet->v[k]);
            }
            if (!(quality(p[0], p[1], p[2], p[3]) > quality_floor)) {
                return {};
            }
        }
        made.push_back(one);
        made.push_back(two);
    }
    const std::uint32_t v =
        take_vertex(complex, work.rewiring, place, (on_interface ? vertex_interface : 0U) | sides);
    if (!complex.attributes.empty(dsc::SimplexKind::vertex)) {
        const Point way = complex.at(edge.b) - complex.at(edge.a);
        const Real fraction = (place - complex.at(edge.a)).dot(way) / way.squaredNorm();
        complex.attributes.blend_vertex(v, edge.a, edge.b, std::clamp(fraction, Real(0), Real(1)));
    }
    for (NewTet& tet : made) {
        *std::find(tet.v.begin(), tet.v.end(), no_id) = v;
    }
    // On the boundary two faces become four.
    replace(complex, work.rewiring, {ring.tets.data(), ring.size}, made, ring.closed ? 0 : 6);
    if (on_interface) {
        work.rewiring.interface.push_back(v);
    }
    ++(on_interface ? work.counts.interface_splits : work.counts.splits);
    return Vertex{v};
}

Verdict improving_split(Complex& complex, Workspace& work, const EdgeAt& edge, Real gain) {
    const Ring& ring = work.ring;
    if (!gather(complex, edge, work.ring)) {
        return Verdict::no_gain;
    }
    if (!ring.closed) {
        return Verdict::on_boundary;
    }
    if (!has_one_phase(complex, ring)) {
        return Verdict::on_interface;
    }
    Point place = midpoint(complex.at(edge.a), complex.at(edge.b));
    StarQuality& star = work.quality;
    star.gather(complex, edge, ring, place);
    constexpr int iterations = 12;
    const Real quality = raise_worst(star, star.worst(place), place, iterations);
    if (!(quality > gain * worst_quality(complex, ring) + 1e-6)) {
        return Verdict::no_gain;
    }
    return edge_split(complex, work, edge, place).is_valid() ? Verdict::legal : Verdict::inverts;
}

bool nudge(Complex& complex, Workspace& work, Vertex vertex, const Point& place, Real floor) {
    gather(complex, vertex.id, work.star);
    work.quality.gather(complex, work.star);
    const Point from = complex.position(vertex);
    Point target = place;
    keep_on_sides(target, from, complex.vertices[vertex.id].flags);
    for (Real fraction = 1; fraction > 0.1; fraction /= 2) {
        const Point to = fraction == 1 ? target : Point(from + fraction * (target - from));
        if (work.quality.worst(to) > floor) {
            complex.vertices[vertex.id].position = to;
            note_edit(complex, work.rewiring);
            return fraction == 1;
        }
    }
    return false;
}

} // namespace dsc3
