// SPDX-License-Identifier: MIT
#include "reference/operations/triangle_collapse.h"

#include "dsc/base/verdict.h"
#include "reference/complex/algebra.h"
#include "reference/complex/geometry.h"

#include <algorithm>
#include <map>

namespace dsc::reference {

namespace {

/// Whether the new vertex can have the position of all fixed vertices, and the given position.
bool can_stay(const std::set<Vertex>& fixed, const std::optional<Point<double>>& place,
              const Complex& K) {
    return fixed.size() <= 1 &&
           (!place || std::ranges::all_of(fixed, [&](Vertex v) { return K.coord(v) == *place; }));
}

/// Whether the edges are those of one simple polygon, or of one simple path if `is_open`.
bool is_simple_curve(const std::set<EdgeKey>& edges, bool is_open) {
    std::map<Vertex, std::set<Vertex>> next_to;
    for (const EdgeKey& e : edges) {
        next_to[e.v[0]].insert(e.v[1]);
        next_to[e.v[1]].insert(e.v[0]);
    }
    std::size_t ends = 0;
    for (const auto& [v, neighbours] : next_to) {
        if (neighbours.size() > 2)
            return false;
        ends += neighbours.size() == 1 ? 1U : 0U;
    }
    // A connected curve without branches is a path if it has ends, and a polygon if it has none.
    std::set<Vertex> reached;
    std::vector<Vertex> waiting{next_to.begin()->first};
    while (!waiting.empty()) {
        const Vertex v = waiting.back();
        waiting.pop_back();
        if (reached.insert(v).second)
            waiting.insert(waiting.end(), next_to[v].begin(), next_to[v].end());
    }
    return reached.size() == next_to.size() && ends == (is_open ? 2U : 0U);
}

} // namespace

Verdict triangle_collapse(const TriangleKey& t, Complex& K,
                          const std::optional<Point<double>>& place, bool may_change_interface) {
    if (!K.is_valid_simplex(t))
        return Verdict::not_a_simplex;
    std::set<Vertex> fixed;
    const auto fix = [&](auto test) {
        std::ranges::copy_if(t.v, std::inserter(fixed, fixed.end()), test);
        return can_stay(fixed, place, K);
    };
    if (!fix([&](Vertex v) { return K.is_boundary(v); }))
        return Verdict::on_boundary;
    if (std::ranges::any_of(t.v, [&](Vertex v) { return K.is_submesh_boundary(v); }))
        return Verdict::on_submesh_boundary;
    const bool is_open = !fixed.empty();
    const auto on_interface = [&](Vertex v) { return K.is_interface(v); };
    if (!may_change_interface && !fix(on_interface))
        return Verdict::on_interface;
    if (!fix([&](Vertex v) { return K.locked.contains(v); }))
        return Verdict::locked;
    if (fixed.empty() && std::ranges::count_if(t.v, on_interface) == 1)
        fixed.insert(*std::ranges::find_if(t.v, on_interface));

    const Point<double> p = place ? *place
                            : fixed.empty()
                                ? (K.coord(t.v[0]) + K.coord(t.v[1]) + K.coord(t.v[2])) / 3
                                : K.coord(*fixed.begin());
    // The triangles that share one vertex with t, and those that share an edge.
    const SimplexSet S = filter(2, star(K, closure(t)));
    SimplexSet T;
    for (const EdgeKey& e : boundary(t).edges)
        T = T | filter(2, star(K, e));
    const SimplexSet T_ = S - T;

    // The edges to be joined to the new vertex are those opposite to t. The new vertex has a disc
    // around it, or half a disc on the boundary, if and only if they form one curve and each
    // belongs to one triangle only.
    std::set<EdgeKey> opposite;
    std::vector<std::pair<EdgeKey, TriangleKey>> renewed;
    for (const TriangleKey& s : T_.triangles) {
        const auto outside = [&](Vertex v) { return !has_vertex(t, v); };
        std::vector<Vertex> rest;
        std::ranges::copy_if(s.v, std::back_inserter(rest), outside);
        renewed.emplace_back(edge_key(rest[0], rest[1]), s);
        opposite.insert(renewed.back().first);
    }
    if (opposite.empty() || opposite.size() != renewed.size() ||
        !is_simple_curve(opposite, is_open))
        return Verdict::changes_topology;

    const auto inverted = [&](const TriangleKey& s) {
        const Vertex v = *std::ranges::find_if(s.v, [&](Vertex u) { return has_vertex(t, u); });
        return orientation_if(K, s, v, p) <= 0;
    };
    if (std::ranges::any_of(T_.triangles, inverted))
        return Verdict::inverts;

    const bool is_locked = std::ranges::any_of(t.v, [&](Vertex v) { return K.locked.contains(v); });
    const Vertex m = K.insert(p);
    if (is_locked)
        K.locked.insert(m);
    for (const auto& [e, s] : renewed) {
        const Phase phase = K.phase(s);
        K.remove(s);
        K.set_phase(K.insert(m, e.v[0], e.v[1]), phase);
    }
    for (const Vertex v : t.v) {
        K.locked.erase(v);
        K.remove(star(K, v));
    }
    return Verdict::legal;
}

} // namespace dsc::reference
