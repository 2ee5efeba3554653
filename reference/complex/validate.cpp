// SPDX-License-Identifier: MIT
#include "reference/complex/validate.h"

#include "reference/complex/algebra.h"

#include <algorithm>
#include <string>

namespace dsc::reference {

namespace {

template <std::size_t N>
std::string name(const std::array<Vertex, N>& vertices) {
    std::string text = "<";
    for (Vertex v : vertices) {
        text += std::to_string(v.id);
        text += v == vertices.back() ? '>' : ' ';
    }
    return text;
}

std::string name(const EdgeKey& e) { return name(e.v); }
std::string name(const TriangleKey& t) { return name(t.v); }
std::string name(Vertex v) { return name(std::array<Vertex, 1>{v}); }

/// Section 3.2: around a vertex the triangles form a disc, or a sector of one: its link is one
/// closed or one open polyline.
bool is_manifold(const Complex& K, Vertex v) {
    const SimplexSet L = link(K, v);
    if (L.vertices.empty())
        return false;
    std::size_t ends = 0;
    for (Vertex w : L.vertices) {
        const auto touches = [&](const EdgeKey& e) { return has_vertex(e, w); };
        const auto degree = std::ranges::count_if(L.edges, touches);
        if (degree < 1 || degree > 2)
            return false;
        ends += degree == 1 ? 1U : 0U;
    }
    // Connected: walk from one vertex over edges to all reachable vertices.
    std::set<Vertex> reached{*L.vertices.begin()};
    for (std::size_t before = 0; before != reached.size();) {
        before = reached.size();
        for (const EdgeKey& e : L.edges) {
            if (reached.contains(e.v[0]) || reached.contains(e.v[1])) {
                reached.insert(e.v.begin(), e.v.end());
            }
        }
    }
    return reached.size() == L.vertices.size() && (ends == 0 || ends == 2);
}

} // namespace

std::vector<std::string> validate(const Complex& K) {
    std::vector<std::string> faults;
    const auto check = [&](bool good, const auto& simplex, const char* fault) {
        if (!good)
            faults.push_back(name(simplex) + " " + fault);
    };
    if (K.phases().size() != K.triangles().size()) {
        faults.emplace_back("the number of phases differs from that of triangles");
    }
    for (const auto& item : K.triangles()) {
        const TriangleKey& t = item.first;
        check(K.orientation(t) > 0, t, "is inverted or has no area");
        check(K.phases().contains(t), t, "has no phase");
        for (const EdgeKey& e : edges_of(t)) {
            check(K.is_valid_simplex(e) && K.triangles_at(e).contains(t), e,
                  "is missing, or does not know a triangle");
        }
        for (Vertex v : t.v) {
            check(K.is_valid_simplex(v) && K.triangles_at(v).contains(t), v,
                  "is missing, or does not know a triangle");
        }
    }
    for (const auto& [e, T] : K.edges()) {
        check(T.size() == 1 || T.size() == 2, e, "has no triangle, or more than two");
        for (const TriangleKey& t : T) {
            check(K.is_valid_simplex(t), e, "has a triangle that is not there");
        }
        for (Vertex v : e.v) {
            check(K.is_valid_simplex(v) && K.edges_at(v).contains(e), v,
                  "is missing, or does not know an edge");
        }
    }
    for (Vertex v : K.vertices()) {
        for (const EdgeKey& e : K.edges_at(v)) {
            check(K.is_valid_simplex(e), v, "has an edge that is not there");
        }
        for (const TriangleKey& t : K.triangles_at(v)) {
            check(K.is_valid_simplex(t), v, "has a triangle that is not there");
        }
        check(K.coord(v).allFinite(), v, "has a coordinate that is not finite");
        if (faults.empty()) {
            check(is_manifold(K, v), v, "is not manifold");
        }
    }
    return faults;
}

} // namespace dsc::reference
