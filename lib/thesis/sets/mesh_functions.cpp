// SPDX-License-Identifier: MIT
#include "thesis/sets/mesh_functions.h"

#include "dsc/complex/circulate.h"
#include "dsc/complex/ranges.h"
#include "dsc/geometry/predicates.h"

#include <utility>
#include <vector>

namespace dsc {

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

#define DSC_INSTANTIATE(Real)                                                                      \
    template int orientation(const Complex<Real>&, Triangle);                                      \
    template bool is_valid_simplex(const Complex<Real>&, Vertex);                                  \
    template bool is_valid_simplex(const Complex<Real>&, Edge);                                    \
    template bool is_valid_simplex(const Complex<Real>&, Triangle);                                \
    template Phase phase(const Complex<Real>&, Triangle);                                          \
    template bool is_submesh_boundary(const Complex<Real>&, const Region&, Vertex);                \
    template bool is_submesh_boundary(const Complex<Real>&, const Region&, Edge);                  \
    template SimplexSet interface_of(const Complex<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
