// SPDX-License-Identifier: MIT
#include "thesis/sets/algebra.h"

#include "dsc/complex/ranges.h"

#include <utility>

namespace dsc {

namespace {

// Simplices in any order; the constructor of SimplexSet sorts them once at the end.
struct Collector {
    std::vector<Vertex> vertices;
    std::vector<Edge> edges;
    std::vector<Triangle> triangles;

    SimplexSet take() {
        return SimplexSet(std::move(vertices), std::move(edges), std::move(triangles));
    }
};

// Each relation is written once, for one simplex: relation_of(complex, simplex, out). The code
// below the table derives from it the forms for a single simplex and for a set.
struct Boundary {
    template <class Real>
    static void add(const Complex<Real>&, Vertex, Collector&) {}
    template <class Real>
    static void add(const Complex<Real>& complex, Edge e, Collector& out) {
        const auto v = complex.vertices_of(e);
        out.vertices.insert(out.vertices.end(), v.begin(), v.end());
    }
    template <class Real>
    static void add(const Complex<Real>& complex, Triangle t, Collector& out) {
        const auto e = complex.edges_of(t);
        out.edges.insert(out.edges.end(), e.begin(), e.end());
    }
};

struct FullBoundary {
    template <class Real>
    static void add(const Complex<Real>&, Vertex, Collector&) {}
    template <class Real>
    static void add(const Complex<Real>& complex, Edge e, Collector& out) {
        Boundary::add(complex, e, out);
    }
    template <class Real>
    static void add(const Complex<Real>& complex, Triangle t, Collector& out) {
        Boundary::add(complex, t, out);
        const auto v = complex.vertices_of(t);
        out.vertices.insert(out.vertices.end(), v.begin(), v.end());
    }
};

struct StarRule {
    template <class Real>
    static void add(const Complex<Real>& complex, Vertex v, Collector& out) {
        out.vertices.push_back(v);
        for_each_corner(complex, v, [&](Corner c) {
            out.triangles.push_back(Triangle{triangle_of(c)});
            // The edge where this triangle begins, counter-clockwise; at the last triangle of an
            // open star, also the edge where it ends.
            out.edges.push_back(complex.edge(prev(c)));
            if (is_border(complex.twin(next(c)))) {
                out.edges.push_back(complex.edge(next(c)));
            }
        });
    }
    template <class Real>
    static void add(const Complex<Real>& complex, Edge e, Collector& out) {
        out.edges.push_back(e);
        out.triangles.push_back(Triangle{triangle_of(e.id)});
        const Corner across = complex.twin(e.id);
        if (!is_border(across)) {
            out.triangles.push_back(Triangle{triangle_of(across)});
        }
    }
    template <class Real>
    static void add(const Complex<Real>&, Triangle t, Collector& out) {
        out.triangles.push_back(t);
    }
};

struct Closure {
    template <class Real>
    static void add(const Complex<Real>&, Vertex v, Collector& out) {
        out.vertices.push_back(v);
    }
    template <class Real>
    static void add(const Complex<Real>& complex, Edge e, Collector& out) {
        out.edges.push_back(e);
        FullBoundary::add(complex, e, out);
    }
    template <class Real>
    static void add(const Complex<Real>& complex, Triangle t, Collector& out) {
        out.triangles.push_back(t);
        FullBoundary::add(complex, t, out);
    }
};

struct Link {
    template <class Real>
    static void add(const Complex<Real>& complex, Vertex v, Collector& out) {
        for_each_corner(complex, v, [&](Corner c) {
            out.edges.push_back(complex.edge(c));
            out.vertices.push_back(Vertex{complex.vertex(next(c))});
            if (is_border(complex.twin(next(c)))) {
                out.vertices.push_back(Vertex{complex.vertex(prev(c))});
            }
        });
    }
    template <class Real>
    static void add(const Complex<Real>& complex, Edge e, Collector& out) {
        // Every other face of the closure of the star contains an end of the edge, and so is in the
        // star of the closure.
        out.vertices.push_back(Vertex{complex.vertex(e.id)});
        const Corner across = complex.twin(e.id);
        if (!is_border(across)) {
            out.vertices.push_back(Vertex{complex.vertex(across)});
        }
    }
    template <class Real>
    static void add(const Complex<Real>&, Triangle, Collector&) {}
};

template <class Relation, class Real, class Simplex>
SimplexSet of_simplex(const Complex<Real>& complex, Simplex simplex) {
    Collector out;
    if (complex.is_alive(simplex)) {
        Relation::add(complex, simplex, out);
    }
    return out.take();
}

// op(Sigma) is the union of op(sigma) over its members (thesis, section 3.1).
template <class Relation, class Real>
SimplexSet of_set(const Complex<Real>& complex, const SimplexSet& set) {
    Collector out;
    const auto add_all = [&](const auto& simplices) {
        for (const auto simplex : simplices) {
            if (complex.is_alive(simplex)) {
                Relation::add(complex, simplex, out);
            }
        }
    };
    add_all(set.vertices());
    add_all(set.edges());
    add_all(set.triangles());
    return out.take();
}

} // namespace

template <class Real>
SimplexSet boundary(const Complex<Real>& complex, Vertex v) {
    return of_simplex<Boundary>(complex, v);
}
template <class Real>
SimplexSet boundary(const Complex<Real>& complex, Edge e) {
    return of_simplex<Boundary>(complex, e);
}
template <class Real>
SimplexSet boundary(const Complex<Real>& complex, Triangle t) {
    return of_simplex<Boundary>(complex, t);
}
template <class Real>
SimplexSet boundary(const Complex<Real>& complex, const SimplexSet& set) {
    return of_set<Boundary>(complex, set);
}

template <class Real>
SimplexSet full_boundary(const Complex<Real>& complex, Vertex v) {
    return of_simplex<FullBoundary>(complex, v);
}
template <class Real>
SimplexSet full_boundary(const Complex<Real>& complex, Edge e) {
    return of_simplex<FullBoundary>(complex, e);
}
template <class Real>
SimplexSet full_boundary(const Complex<Real>& complex, Triangle t) {
    return of_simplex<FullBoundary>(complex, t);
}

template <class Real>
SimplexSet star(const Complex<Real>& complex, Vertex v) {
    return of_simplex<StarRule>(complex, v);
}
template <class Real>
SimplexSet star(const Complex<Real>& complex, Edge e) {
    return of_simplex<StarRule>(complex, e);
}
template <class Real>
SimplexSet star(const Complex<Real>& complex, Triangle t) {
    return of_simplex<StarRule>(complex, t);
}
template <class Real>
SimplexSet star(const Complex<Real>& complex, const SimplexSet& set) {
    return of_set<StarRule>(complex, set);
}

template <class Real>
SimplexSet closure(const Complex<Real>& complex, Vertex v) {
    return of_simplex<Closure>(complex, v);
}
template <class Real>
SimplexSet closure(const Complex<Real>& complex, Edge e) {
    return of_simplex<Closure>(complex, e);
}
template <class Real>
SimplexSet closure(const Complex<Real>& complex, Triangle t) {
    return of_simplex<Closure>(complex, t);
}
template <class Real>
SimplexSet closure(const Complex<Real>& complex, const SimplexSet& set) {
    return of_set<Closure>(complex, set);
}

template <class Real>
SimplexSet link(const Complex<Real>& complex, Vertex v) {
    return of_simplex<Link>(complex, v);
}
template <class Real>
SimplexSet link(const Complex<Real>& complex, Edge e) {
    return of_simplex<Link>(complex, e);
}
template <class Real>
SimplexSet link(const Complex<Real>& complex, Triangle t) {
    return of_simplex<Link>(complex, t);
}
template <class Real>
SimplexSet link(const Complex<Real>& complex, const SimplexSet& set) {
    return of_set<Link>(complex, set);
}

template <class Real>
SimplexSet all_simplices(const Complex<Real>& complex) {
    Collector out;
    for (const Vertex v : vertices(complex)) {
        out.vertices.push_back(v);
    }
    for (const Edge e : edges(complex)) {
        out.edges.push_back(e);
    }
    for (const Triangle t : triangles(complex)) {
        out.triangles.push_back(t);
    }
    return out.take();
}

#define DSC_INSTANTIATE_SIMPLEX(Real, Simplex)                                                     \
    template SimplexSet boundary(const Complex<Real>&, Simplex);                                   \
    template SimplexSet full_boundary(const Complex<Real>&, Simplex);                              \
    template SimplexSet star(const Complex<Real>&, Simplex);                                       \
    template SimplexSet closure(const Complex<Real>&, Simplex);                                    \
    template SimplexSet link(const Complex<Real>&, Simplex);
#define DSC_INSTANTIATE(Real)                                                                      \
    DSC_INSTANTIATE_SIMPLEX(Real, Vertex)                                                          \
    DSC_INSTANTIATE_SIMPLEX(Real, Edge)                                                            \
    DSC_INSTANTIATE_SIMPLEX(Real, Triangle)                                                        \
    template SimplexSet boundary(const Complex<Real>&, const SimplexSet&);                         \
    template SimplexSet star(const Complex<Real>&, const SimplexSet&);                             \
    template SimplexSet closure(const Complex<Real>&, const SimplexSet&);                          \
    template SimplexSet link(const Complex<Real>&, const SimplexSet&);                             \
    template SimplexSet all_simplices(const Complex<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE
#undef DSC_INSTANTIATE_SIMPLEX

} // namespace dsc
