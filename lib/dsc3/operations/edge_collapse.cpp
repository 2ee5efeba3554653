// SPDX-License-Identifier: MIT
#include "dsc3/operations/edge_collapse.h"

#include "dsc3/geometry/tet.h"

#include <algorithm>
#include <cmath>

namespace dsc3 {

namespace {

// A collapse in a star below the floor is also allowed if it raises the worst quality by this
// factor; otherwise nothing could improve such stars.
constexpr Real escape = 1.5;

bool is_near(const Complex& complex, const InterfaceStar& interface_star, std::uint32_t target,
             Real deviation) {
    if (!std::isfinite(deviation)) {
        return true;
    }
    const Point& p = complex.at(interface_star.centre);
    const Point& t = complex.at(target);
    for (const StarFace& face : interface_star.faces) {
        if (face.x == target || face.y == target) {
            continue;
        }
        const Point& x = complex.at(face.x);
        const Point& y = complex.at(face.y);
        const Point plane = (x - t).cross(y - t);
        const Real square = plane.squaredNorm();
        if (!(square > 0)) {
            continue;
        }
        // Barycentric coordinates of the projection of p on the new face (t, x, y). The tolerance
        // allows points slightly outside the face, because neighbouring faces are not coplanar.
        const Real of_t = (x - p).cross(y - p).dot(plane) / square;
        const Real of_x = (y - p).cross(t - p).dot(plane) / square;
        constexpr Real beside = -0.05;
        if (of_t >= beside && of_x >= beside && 1 - of_t - of_x >= beside &&
            std::abs((p - t).dot(plane)) <= deviation * std::sqrt(square)) {
            return true;
        }
    }
    return false;
}

// The same for a vertex on a junction curve, without which the curve goes from the target to the
// next vertex in a straight line, if the rules limit it.
bool is_near_curve(const Complex& complex, const InterfaceStar& interface_star,
                   std::uint32_t target, const CollapseRules& rules) {
    if (!std::isfinite(std::min(rules.curve_deviation, rules.longest_on_curve))) {
        return true;
    }
    const auto next = std::find_if(
        interface_star.edges.begin(), interface_star.edges.end(),
        [&](const StarEdge& edge) { return edge.is_on_curve() && edge.vertex != target; });
    const Point way = complex.at(next->vertex) - complex.at(target);
    const Point p = complex.at(interface_star.centre) - complex.at(target);
    const Real length = way.norm();
    return length <= rules.longest_on_curve &&
           (!std::isfinite(rules.curve_deviation) ||
            (way.dot(p) >= 0 && way.cross(p).norm() <= rules.curve_deviation * length));
}

// A sheet stays a sheet, a curve a curve, and neither turns much.
Verdict surface_guard(const Complex& complex, Workspace& work, std::uint32_t target,
                      const CollapseRules& rules) {
    InterfaceStar& interface_star = work.interface_star;
    gather(complex, work.star, interface_star);
    const Stratum stratum = classify(interface_star);
    const StarEdge* const edge = interface_star.edge_to(target);
    if (edge == nullptr) {
        return Verdict::on_interface;
    }
    const bool is_least = interface_star.size() < 4;
    if (stratum == Stratum::point || (stratum == Stratum::curve && !edge->is_on_curve()) ||
        (is_least && stratum != Stratum::sheet)) {
        return Verdict::changes_topology;
    }
    const Point& from = complex.at(interface_star.centre);
    const Point& to = complex.at(target);
    for (const StarFace& face : interface_star.faces) {
        if (face.x == target || face.y == target) {
            continue;
        }
        const Point& x = complex.at(face.x);
        const Point& y = complex.at(face.y);
        const Point before = (x - from).cross(y - from);
        const Point after = (x - to).cross(y - to);
        if (before.dot(after) < rules.min_cos * before.norm() * after.norm()) {
            return Verdict::inverts;
        }
    }
    if (!(stratum == Stratum::sheet ? is_near(complex, interface_star, target, rules.deviation)
                                    : is_near_curve(complex, interface_star, target, rules))) {
        return Verdict::no_gain;
    }
    gather(complex, target, work.other);
    gather(complex, work.other, work.other_interface_star);
    // A vertex between three faces vanishes only beside a curve or a point, where nothing else
    // could remove it.
    if (classify(work.other_interface_star) == Stratum::sheet && is_least) {
        return Verdict::changes_topology;
    }
    std::uint32_t common = 0;
    for (const StarEdge& one : interface_star.edges) {
        if (const StarEdge* other = work.other_interface_star.edge_to(one.vertex)) {
            ++common;
            if (one.is_on_curve() && other->is_on_curve()) { // two curves would become one
                return Verdict::changes_topology;
            }
        }
    }
    if (common != edge->faces) {
        return Verdict::changes_topology;
    }
    const auto& of_target = work.other_interface_star.faces;
    for (const StarFace& face : interface_star.faces) { // a tet that is all of its phase there
        if (std::any_of(of_target.begin(), of_target.end(), [&](const StarFace& other) {
                return (other.x == face.x && other.y == face.y) ||
                       (other.x == face.y && other.y == face.x);
            })) {
            return Verdict::changes_topology;
        }
    }
    for (const StarFace& face : interface_star.faces) { // vertices beside the edge lose a face
        if (face.x != target && face.y != target) {
            continue;
        }
        const std::uint32_t v = face.x == target ? face.y : face.x;
        if (!owns(work.rewiring, v)) {
            return Verdict::on_submesh_boundary;
        }
        gather(complex, v, work.other);
        gather(complex, work.other, work.other_interface_star);
        if (work.other_interface_star.size() < 4) {
            return Verdict::changes_topology;
        }
    }
    return Verdict::legal;
}

} // namespace

Verdict edge_collapse_guard(const Complex& complex, Workspace& work, Vertex vanishing,
                            Vertex target, const CollapseRules& rules) {
    if (!complex.is_alive(vanishing) || !complex.is_alive(target) || vanishing == target) {
        return Verdict::not_a_simplex;
    }
    const std::uint32_t fixed = complex.fixed_along(vanishing.id, vanishing.id);
    if ((complex.fixed_along(vanishing.id, target.id) & fixed) != fixed) {
        return Verdict::on_boundary;
    }
    const bool on_interface = complex.is_interface(vanishing);
    if (on_interface && !complex.is_interface(target)) {
        return Verdict::on_interface;
    }
    work.rewiring.stars.gather(complex, vanishing.id, work.star);
    StarQuality& quality = work.quality;
    quality.gather(complex, work.star, target.id);
    if (!quality.leaves_out()) {
        return Verdict::not_a_simplex;
    }
    const Real before = quality.worst(complex.position(vanishing));
    const Real needed = before < rules.floor
                            ? std::max(escape * before, std::min(rules.floor, Real(1e-7)))
                            : std::max(rules.floor, std::min(1.001 * before + 1e-9, rules.enough));
    if (!(quality.worst_of_others(complex.position(target)) > needed)) {
        return Verdict::inverts;
    }
    return on_interface || fixed != 0 ? surface_guard(complex, work, target.id, rules)
                                      : Verdict::legal;
}

Verdict edge_collapse(Complex& complex, Workspace& work, Vertex vanishing, Vertex target,
                      const CollapseRules& rules) {
    const Verdict verdict = edge_collapse_guard(complex, work, vanishing, target, rules);
    if (verdict != Verdict::legal) {
        return verdict;
    }
    auto& old = work.rewiring.old;
    auto& made = work.rewiring.made;
    old.clear();
    made.clear();
    // Faces on the sides: before the collapse at the vertex, after it at the target.
    std::uint32_t unmatched = 0;
    for (const Corner corner : work.star.corners) {
        const std::uint32_t t = tet_of(corner);
        old.push_back(t);
        for (const std::uint32_t i : face_indices[index_of(corner)]) {
            if (is_border(complex.tets[t].n[i])) {
                const auto face = complex.face(corner_of(t, i));
                const bool vanishes = std::find(face.begin(), face.end(), target.id) != face.end();
                unmatched += vanishes ? 1U : 2U;
            }
        }
        if (!has_vertex(complex.tets[t], target.id)) {
            made.push_back({complex.tets[t].v, complex.phases[t]});
            made.back().v[index_of(corner)] = target.id;
        }
    }
    ++(complex.is_interface(vanishing) ? work.counts.interface_collapses : work.counts.collapses);
    replace(complex, work.rewiring, old, made, unmatched);
    give_vertex(complex, work.rewiring, vanishing.id);
    return Verdict::legal;
}

} // namespace dsc3
