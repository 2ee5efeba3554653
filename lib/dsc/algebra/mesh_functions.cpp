// SPDX-License-Identifier: MIT
#include "dsc/algebra/mesh_functions.h"

#include "dsc/complex/interface_pair.h"
#include "dsc/complex/ranges.h"
#include "dsc/geometry/predicates.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dsc {

namespace {

template <class Real>
bool is_interface_corner(const Complex<Real>& complex, Corner c) {
    return is_interface_pair(complex.phase_at(c), complex.phase_at(complex.twin(c)));
}

// True if `test(corner)` holds for one of the edges at `v`, each named by a corner opposite to it.
template <class Real, class Test>
bool any_edge_at(const Complex<Real>& complex, Vertex v, Test test) {
    bool found = false;
    for_each_corner(complex, v, [&](Corner c) {
        found = found || test(prev(c)) || (is_border(complex.twin(next(c))) && test(next(c)));
    });
    return found;
}

template <class Real, class Test>
bool any_edge_of(Triangle t, Test test) {
    return test(corner_of(t.id, 0)) || test(corner_of(t.id, 1)) || test(corner_of(t.id, 2));
}

} // namespace

template <class Real>
int orientation(const Complex<Real>& complex, Triangle t) {
    const auto v = complex.vertices_of(t);
    return dsc::orientation(complex.position(v[0]), complex.position(v[1]), complex.position(v[2]));
}

template <class Real>
bool is_valid_simplex(const Complex<Real>& complex, Vertex v) {
    return complex.is_alive(v);
}
template <class Real>
bool is_valid_simplex(const Complex<Real>& complex, Edge e) {
    return complex.is_alive(e);
}
template <class Real>
bool is_valid_simplex(const Complex<Real>& complex, Triangle t) {
    return complex.is_alive(t);
}

template <class Real>
Phase phase(const Complex<Real>& complex, Triangle t) {
    return complex.phase(t);
}

template <class Real>
bool is_boundary(const Complex<Real>& complex, Vertex v) {
    return any_edge_at(complex, v, [&](Corner c) { return is_border(complex.twin(c)); });
}
template <class Real>
bool is_boundary(const Complex<Real>& complex, Edge e) {
    return is_border(complex.twin(e.id));
}
template <class Real>
bool is_boundary(const Complex<Real>& complex, Triangle t) {
    return any_edge_of<Real>(t, [&](Corner c) { return is_border(complex.twin(c)); });
}

template <class Real>
bool is_interface(const Complex<Real>& complex, Vertex v) {
    return any_edge_at(complex, v, [&](Corner c) { return is_interface_corner(complex, c); });
}
template <class Real>
bool is_interface(const Complex<Real>& complex, Edge e) {
    return is_interface_corner(complex, e.id);
}
template <class Real>
bool is_interface(const Complex<Real>& complex, Triangle t) {
    return any_edge_of<Real>(t, [&](Corner c) { return is_interface_corner(complex, c); });
}

template <class Real>
bool is_submesh_boundary(const Complex<Real>& complex, const Region& region, Vertex v) {
    if (!owns(complex, region, v.id)) {
        return false;
    }
    bool found = false;
    for_each_corner(complex, v, [&](Corner c) {
        found = found || !owns_triangle(complex, region, triangle_of(c));
    });
    return found;
}

template <class Real>
bool is_submesh_boundary(const Complex<Real>& complex, const Region& region, Edge e) {
    const Corner across = complex.twin(e.id);
    return !is_border(across) && owns_triangle(complex, region, triangle_of(e.id)) !=
                                     owns_triangle(complex, region, triangle_of(across));
}

template <class Real>
SimplexSet interface_of(const Complex<Real>& complex) {
    std::vector<Vertex> vertices;
    std::vector<Edge> found;
    for (const Edge e : edges(complex)) {
        if (is_interface(complex, e)) {
            found.push_back(e);
            const auto ends = complex.vertices_of(e);
            vertices.insert(vertices.end(), ends.begin(), ends.end());
        }
    }
    return SimplexSet(std::move(vertices), std::move(found), {});
}

template <class Real>
std::vector<Phase> phases(const Complex<Real>& complex) {
    std::vector<Phase> found;
    for (const Triangle t : triangles(complex)) {
        const Phase phase = complex.phase(t);
        const auto place = std::lower_bound(found.begin(), found.end(), phase);
        if (place == found.end() || *place != phase) {
            found.insert(place, phase);
        }
    }
    return found;
}

template <class Real>
double phase_area(const Complex<Real>& complex, Phase phase) {
    // Neumaier's sum: the rounding error of each addition is accumulated separately.
    double sum = 0;
    double lost = 0;
    for (const Triangle t : triangles(complex, phase)) {
        const auto v = complex.vertices_of(t);
        const Point<double> a = complex.position(v[0]).template cast<double>();
        const Point<double> b = complex.position(v[1]).template cast<double>();
        const Point<double> c = complex.position(v[2]).template cast<double>();
        const double area =
            0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
        const double next_sum = sum + area;
        lost += std::abs(sum) >= std::abs(area) ? (sum - next_sum) + area : (area - next_sum) + sum;
        sum = next_sum;
    }
    return sum + lost;
}

#define DSC_INSTANTIATE_SIMPLEX(Real, Simplex)                                                     \
    template bool is_valid_simplex(const Complex<Real>&, Simplex);                                 \
    template bool is_boundary(const Complex<Real>&, Simplex);                                      \
    template bool is_interface(const Complex<Real>&, Simplex);
#define DSC_INSTANTIATE(Real)                                                                      \
    template int orientation(const Complex<Real>&, Triangle);                                      \
    template Phase phase(const Complex<Real>&, Triangle);                                          \
    template bool is_submesh_boundary(const Complex<Real>&, const Region&, Vertex);                \
    template bool is_submesh_boundary(const Complex<Real>&, const Region&, Edge);                  \
    template SimplexSet interface_of(const Complex<Real>&);                                        \
    template std::vector<Phase> phases(const Complex<Real>&);                                      \
    template double phase_area(const Complex<Real>&, Phase);                                       \
    DSC_INSTANTIATE_SIMPLEX(Real, Vertex)                                                          \
    DSC_INSTANTIATE_SIMPLEX(Real, Edge)                                                            \
    DSC_INSTANTIATE_SIMPLEX(Real, Triangle)
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE
#undef DSC_INSTANTIATE_SIMPLEX

} // namespace dsc
