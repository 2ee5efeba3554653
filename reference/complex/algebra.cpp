// SPDX-License-Identifier: MIT
#include "reference/complex/algebra.h"

namespace dsc::reference {

namespace {

void add_faces(SimplexSet& set, const EdgeKey& e) {
    for (Vertex v : e.v)
        set.insert(v);
}

void add_faces(SimplexSet& set, const TriangleKey& t) {
    for (Vertex v : t.v)
        set.insert(v);
    for (const EdgeKey& e : edges_of(t))
        set.insert(e);
}

void add_star(SimplexSet& set, const Complex& K, Vertex v) {
    set.insert(v);
    set.edges.insert(K.edges_at(v).begin(), K.edges_at(v).end());
    set.triangles.insert(K.triangles_at(v).begin(), K.triangles_at(v).end());
}

void add_star(SimplexSet& set, const Complex& K, const EdgeKey& e) {
    set.insert(e);
    set.triangles.insert(K.triangles_at(e).begin(), K.triangles_at(e).end());
}

template <class Simplex>
SimplexSet link_of(const Complex& K, const Simplex& simplex) {
    return closure(star(K, simplex)) - star(K, closure(simplex));
}

} // namespace

SimplexSet boundary(Vertex) { return {}; }

SimplexSet boundary(const EdgeKey& e) {
    SimplexSet set;
    add_faces(set, e);
    return set;
}

SimplexSet boundary(const TriangleKey& t) {
    SimplexSet set;
    for (const EdgeKey& e : edges_of(t))
        set.insert(e);
    return set;
}

SimplexSet full_boundary(Vertex) { return {}; }

SimplexSet full_boundary(const EdgeKey& e) { return boundary(e); }

SimplexSet full_boundary(const TriangleKey& t) {
    SimplexSet set;
    add_faces(set, t);
    return set;
}

SimplexSet closure(Vertex v) {
    SimplexSet set;
    set.insert(v);
    return set;
}

SimplexSet closure(const EdgeKey& e) {
    SimplexSet set = full_boundary(e);
    set.insert(e);
    return set;
}

SimplexSet closure(const TriangleKey& t) {
    SimplexSet set = full_boundary(t);
    set.insert(t);
    return set;
}

SimplexSet closure(const SimplexSet& set) {
    SimplexSet result = set;
    for (const EdgeKey& e : set.edges)
        add_faces(result, e);
    for (const TriangleKey& t : set.triangles)
        add_faces(result, t);
    return result;
}

SimplexSet star(const Complex& K, Vertex v) {
    SimplexSet set;
    add_star(set, K, v);
    return set;
}

SimplexSet star(const Complex& K, const EdgeKey& e) {
    SimplexSet set;
    add_star(set, K, e);
    return set;
}

SimplexSet star(const Complex&, const TriangleKey& t) {
    SimplexSet set;
    set.insert(t);
    return set;
}

SimplexSet star(const Complex& K, const SimplexSet& set) {
    SimplexSet result;
    for (Vertex v : set.vertices)
        add_star(result, K, v);
    for (const EdgeKey& e : set.edges)
        add_star(result, K, e);
    for (const TriangleKey& t : set.triangles)
        result.insert(t);
    return result;
}

SimplexSet link(const Complex& K, Vertex v) { return link_of(K, v); }
SimplexSet link(const Complex& K, const EdgeKey& e) { return link_of(K, e); }
SimplexSet link(const Complex& K, const TriangleKey& t) { return link_of(K, t); }

SimplexSet link(const Complex& K, const SimplexSet& set) {
    SimplexSet result;
    for (Vertex v : set.vertices)
        result.insert(link(K, v));
    for (const EdgeKey& e : set.edges)
        result.insert(link(K, e));
    for (const TriangleKey& t : set.triangles)
        result.insert(link(K, t));
    return result;
}

SimplexSet skeleton(int k, const SimplexSet& set) {
    SimplexSet result;
    if (k >= 0)
        result.vertices = set.vertices;
    if (k >= 1)
        result.edges = set.edges;
    if (k >= 2)
        result.triangles = set.triangles;
    return result;
}

SimplexSet filter(int k, const SimplexSet& set) {
    SimplexSet result;
    if (k == 0)
        result.vertices = set.vertices;
    if (k == 1)
        result.edges = set.edges;
    if (k == 2)
        result.triangles = set.triangles;
    return result;
}

} // namespace dsc::reference
