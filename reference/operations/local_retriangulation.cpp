// SPDX-License-Identifier: MIT
#include "reference/operations/local_retriangulation.h"

#include "dsc/base/verdict.h"
#include "reference/complex/algebra.h"
#include "reference/operations/ear_clipping.h"

#include <algorithm>
#include <map>

namespace dsc::reference {

namespace {

/// PhaseFilter: removes the triangles of phases other than that of `t`.
void phase_filter(const TriangleKey& t, SimplexSet& R, const Complex& K) {
    std::erase_if(R.triangles, [&](const TriangleKey& s) { return K.phase(s) != K.phase(t); });
}

/// BoundaryFilter: removes the vertices and edges of the mesh boundary.
void boundary_filter(SimplexSet& R, const Complex& K) {
    std::erase_if(R.vertices, [&](Vertex v) { return K.is_boundary(v); });
    std::erase_if(R.edges, [&](const EdgeKey& e) { return K.is_boundary(e); });
}

/// SubmeshBoundaryFilter: removes the vertices and edges of the submesh boundary.
void submesh_boundary_filter(SimplexSet& R, const Complex& K) {
    std::erase_if(R.vertices, [&](Vertex v) { return K.is_submesh_boundary(v); });
    std::erase_if(R.edges, [&](const EdgeKey& e) { return K.is_submesh_boundary(e); });
}

/// The vertices of R' = closure(R) \ R in counter-clockwise order from the smallest; empty if R' is
/// not one simple polygon. Section 7.6: the set algebra cannot express an order, so it is taken
/// from the oriented triangles of R.
std::vector<Vertex> polygon_of(const SimplexSet& R_, const SimplexSet& R, const Complex& K) {
    std::map<Vertex, Vertex> successor;
    std::size_t followed = 0;
    for (const TriangleKey& t : R.triangles) {
        const OrientedTriangle& o = K.oriented(t);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vertex a = o[i];
            const Vertex b = o[(i + 1) % 3];
            if (R_.contains(edge_key(a, b))) {
                successor[a] = b;
                ++followed;
            }
        }
    }
    // An edge visited from both sides is a loose end inside R.
    if (R_.vertices.empty() || followed != R_.edges.size()) {
        return {};
    }
    // The walk must return to its start exactly when all vertices have been visited: then there is
    // one loop that does not touch itself, and no other vertex.
    std::vector<Vertex> polygon;
    Vertex v = *R_.vertices.begin();
    do {
        const auto next = successor.find(v);
        if (next == successor.end() || polygon.size() == R_.vertices.size()) {
            return {};
        }
        polygon.push_back(v);
        v = next->second;
    } while (v != polygon.front());
    return polygon.size() == R_.vertices.size() ? polygon : std::vector<Vertex>{};
}

} // namespace

Verdict local_retriangulation(const TriangleKey& t, Complex& K) {
    if (!K.is_valid_simplex(t))
        return Verdict::not_a_simplex;
    const auto submesh_boundary = [&](Vertex v) { return K.is_submesh_boundary(v); };
    const auto interface = [&](Vertex v) { return K.is_interface(v); };
    const auto locked = [&](Vertex v) { return K.locked.contains(v) && !K.is_boundary(v); };
    if (std::ranges::any_of(t.v, submesh_boundary))
        return Verdict::on_submesh_boundary;
    if (std::ranges::any_of(t.v, interface))
        return Verdict::on_interface;
    if (std::ranges::any_of(t.v, locked))
        return Verdict::locked;

    SimplexSet R = star(K, closure(t));
    phase_filter(t, R, K);
    boundary_filter(R, K);
    submesh_boundary_filter(R, K);
    const SimplexSet R_ = closure(R) - R;
    const std::vector<Vertex> polygon = polygon_of(R_, R, K);
    if (polygon.empty())
        return Verdict::not_a_simple_polygon;

    std::vector<Point<double>> coords;
    coords.reserve(polygon.size());
    for (Vertex v : polygon)
        coords.push_back(K.coord(v));
    const auto ears = ear_clipping(coords);
    if (!ears)
        return Verdict::inverts;

    const Phase p = K.phase(t);
    K.remove(R);
    for (const auto& [a, b, c] : *ears) {
        K.set_phase(K.insert(polygon[a], polygon[b], polygon[c]), p);
    }
    return Verdict::legal;
}

} // namespace dsc::reference
