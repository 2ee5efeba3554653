// SPDX-License-Identifier: MIT
#include "dsc3/operations/interface_flip.h"

#include "dsc3/geometry/tet.h"
#include "dsc3/operations/edge_removal.h"

#include <algorithm>
#include <cmath>

namespace dsc3 {

namespace {

// Whether the interface has the edge (c, d) already, or a or b would keep fewer than three faces.
bool breaks_manifold(const Complex& complex, Workspace& work, std::uint32_t a, std::uint32_t b,
                     std::uint32_t c, std::uint32_t d) {
    gather(complex, c, work.other);
    gather(complex, work.other, work.other_interface_star);
    if (work.other_interface_star.has_edge_to(d)) {
        return true;
    }
    for (const std::uint32_t v : {a, b}) {
        gather(complex, v, work.other);
        gather(complex, work.other, work.other_interface_star);
        if (work.other_interface_star.size() < 4) {
            return true;
        }
    }
    return false;
}

// The tet joins the phase of a neighbour and takes its attributes.
void join(Complex& complex, std::uint32_t tet, std::uint32_t neighbour) {
    complex.phases[tet] = complex.phases[neighbour];
    complex.attributes.copy_triangle(tet, neighbour);
}

// If the tet (a, b, c, d) exists, changing its phase moves the interface to its other two faces.
Verdict reassign(Complex& complex, Workspace& work, std::uint32_t tet, std::uint32_t c,
                 std::uint32_t d, std::uint32_t neighbour) {
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t v = complex.tets[tet].v[i];
        if (v != c && v != d && complex.phase_at(complex.tets[tet].n[i]) != complex.phases[tet]) {
            return Verdict::changes_topology;
        }
    }
    join(complex, tet, neighbour);
    note_edit(complex, work.rewiring);
    work.rewiring.changed.push_back(tet);
    ++work.counts.reassigned;
    return Verdict::legal;
}

bool is_flat(const Point& m, const Point& n, Real min_cos) {
    return m.dot(n) >= min_cos * m.norm() * n.norm();
}

// Of caps: the smallest angle, the factor by which a flip must raise it, and the cosine of the
// largest angle between the faces afterwards.
constexpr Real cap_degrees = 12;
constexpr Real cap_gain = 1.5;
constexpr Real cap_cos = 0.9;

// Whether one of the faces at (a, b) is a cap whose flip moves the interface by less than `gap`.
bool is_cap_to_flip(const Point& a, const Point& b, const Point& c, const Point& d, Real gap) {
    const Point across = (b - a).cross(d - c);
    if (!(gap > 0) || !(std::abs((c - a).dot(across)) <= gap * across.norm())) {
        return false;
    }
    const Real before = std::min(min_angle_degrees(a, b, c), min_angle_degrees(a, b, d));
    const Real after = std::min(min_angle_degrees(a, c, d), min_angle_degrees(b, c, d));
    if (before >= cap_degrees || after <= cap_gain * before) {
        return false;
    }
    const Point of_c = (b - a).cross(c - a);
    const Point of_d = (d - a).cross(b - a);
    const Point& larger = of_c.squaredNorm() > of_d.squaredNorm() ? of_c : of_d;
    const Point after_a = (d - a).cross(c - a);
    const Point after_b = (c - b).cross(d - b);
    return is_flat(after_a, after_b, cap_cos) && is_flat(after_a, larger, cap_cos) &&
           is_flat(after_b, larger, cap_cos);
}

} // namespace

bool wants_flip(const Point& a, const Point& b, const Point& c, const Point& d, Real slack) {
    const Real cos_c = (a - c).dot(b - c);
    const Real cos_d = (a - d).dot(b - d);
    if (cos_c > 0 && cos_d > 0) {
        return false;
    }
    const Real sin_c = (a - c).cross(b - c).norm();
    const Real sin_d = (a - d).cross(b - d).norm();
    return sin_c * cos_d + cos_c * sin_d < -slack * (sin_c * sin_d + std::abs(cos_c * cos_d));
}

Verdict interface_flip(Complex& complex, Workspace& work, const EdgeAt& edge,
                       const FlipRules& rules) {
    Ring& ring = work.ring;
    const auto [tet, a, b] = edge;
    if (!gather(complex, edge, ring)) {
        return Verdict::no_gain;
    }
    if (!ring.closed) {
        return Verdict::on_boundary;
    }
    std::array<std::uint32_t, 2> cut{};
    std::uint32_t cuts = 0;
    for (std::uint32_t i = 0; i < ring.size; ++i) {
        const std::uint32_t before = ring.tets[i == 0 ? ring.size - 1 : i - 1];
        if (complex.phases[ring.tets[i]] != complex.phases[before]) {
            if (cuts == 2) {
                return Verdict::changes_topology;
            }
            cut[cuts++] = i;
        }
    }
    if (cuts != 2) {
        return Verdict::changes_topology;
    }
    const std::uint32_t c = ring.vertices[cut[0]];
    const std::uint32_t d = ring.vertices[cut[1]];
    const Point& pa = complex.at(a);
    const Point& pb = complex.at(b);
    const Point& pc = complex.at(c);
    const Point& pd = complex.at(d);
    if (!wants_flip(pa, pb, pc, pd, rules.slack)) {
        return Verdict::no_gain;
    }
    const Point before_c = (pb - pa).cross(pc - pa);
    const Point before_d = (pd - pa).cross(pb - pa);
    const Point after_a = (pd - pa).cross(pc - pa);
    const Point after_b = (pc - pb).cross(pd - pb);
    if ((!is_flat(before_c, before_d, rules.min_cos) || !is_flat(after_a, after_b, rules.min_cos) ||
         !is_flat(after_a, before_c, rules.min_cos) ||
         !is_flat(after_b, before_c, rules.min_cos)) &&
        !is_cap_to_flip(pa, pb, pc, pd, rules.cap_gap)) {
        return Verdict::inverts;
    }
    if (!owns(work.rewiring, c)) {
        return Verdict::on_submesh_boundary;
    }
    if (breaks_manifold(complex, work, a, b, c, d)) {
        return Verdict::changes_topology;
    }
    const Real worst = worst_quality(complex, ring);
    const Real floor = std::max(std::min(rules.floor, std::max(worst, 1e-4)), quality_floor);
    work.rewiring.made.clear();
    for (std::uint32_t side = 0; side < 2; ++side) {
        const std::uint32_t first = cut[side];
        const std::uint32_t size = (cut[1 - side] + ring.size - first) % ring.size + 1;
        if (size == 2) {
            return reassign(complex, work, ring.tets[first], c, d, ring.tets[cut[1 - side]]);
        }
        if (size > polygon_limit) {
            return Verdict::no_gain;
        }
        std::array<std::uint32_t, polygon_limit> polygon{};
        for (std::uint32_t i = 0; i < size; ++i) {
            polygon[i] = ring.vertices[(first + i) % ring.size];
        }
        const std::span<const std::uint32_t> piece(polygon.data(), size);
        if (!(best_triangulation(complex, work, a, b, piece, floor) > floor)) {
            return Verdict::no_gain;
        }
        append_triangulation(work, a, b, piece, complex.phases[ring.tets[first]]);
    }
    replace(complex, work.rewiring, {ring.tets.data(), ring.size}, work.rewiring.made);
    ++work.counts.interface_flips;
    return Verdict::legal;
}

Verdict reassign_sliver(Complex& complex, Workspace& work, const EdgeAt& edge) {
    const auto [t, a, b] = edge;
    const TetRecord& tet = complex.tets[t];
    const Phase phase = complex.phases[t];
    std::array<std::uint32_t, 2> opposite{no_id, no_id};
    Phase beyond = border_phase;
    std::uint32_t neighbour = border_tet;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const Phase next = complex.phase_at(tet.n[i]);
        if (tet.v[i] == a || tet.v[i] == b) {
            if (next != phase) {
                return Verdict::changes_topology;
            }
        } else {
            if (next == phase || next == border_phase || (opposite[0] != no_id && next != beyond)) {
                return Verdict::changes_topology;
            }
            beyond = next;
            neighbour = tet_of(tet.n[i]);
            opposite[opposite[0] == no_id ? 0 : 1] = tet.v[i];
        }
    }
    const auto [c, d] = opposite;
    const Point& pa = complex.at(a);
    const Point& pb = complex.at(b);
    const Point& pc = complex.at(c);
    const Point& pd = complex.at(d);
    if (std::min(min_angle_degrees(pa, pc, pd), min_angle_degrees(pb, pc, pd)) <
        0.8 * std::min(min_angle_degrees(pa, pb, pc), min_angle_degrees(pa, pb, pd))) {
        return Verdict::no_gain;
    }
    if (!is_flat((pb - pa).cross(pc - pa), (pd - pa).cross(pb - pa), 0.9)) {
        return Verdict::inverts;
    }
    if (breaks_manifold(complex, work, a, b, c, d)) {
        return Verdict::changes_topology;
    }
    constexpr Real gain = 1.02;
    complex.phases[t] = beyond;
    const Verdict verdict = edge_removal_guard(complex, work, edge, gain);
    if (verdict != Verdict::legal) {
        complex.phases[t] = phase;
        return verdict;
    }
    join(complex, t, neighbour);
    ++work.counts.reassigned;
    return edge_removal(complex, work, edge, gain);
}

} // namespace dsc3
