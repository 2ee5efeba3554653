// SPDX-License-Identifier: MIT
#include "dsc/queries/phases.h"

#include "dsc/base/types.h"
#include "dsc/complex/circulate.h"
#include "dsc/geometry/triangle.h"
#include "dsc/queries/outlines.h"

#include <algorithm>
#include <cmath>

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

template <class Real>
Components components(const Complex<Real>& complex) {
    Components result;
    const auto at = [&](Vertex v) {
        return Point<double>(complex.position(v).template cast<double>());
    };
    const auto across = [&](Corner c) { return complex.phase_at(complex.twin(c)); };
    result.of = label_parts(
        complex, [&](Corner c) { return across(c) == complex.phase_at(c); },
        [&](std::uint32_t part, Triangle t) {
            if (part == result.list.size()) {
                result.list.push_back({.phase = complex.phase(t)});
            }
            Component& component = result.list[part];
            const auto [a, b, c] = complex.vertices_of(t);
            ++component.triangles;
            component.area += area(at(a), at(b), at(c));
            component.touches_border = component.touches_border || is_boundary(complex, t);
        });
    for_each_outline(complex, [&](std::span<const Corner> outline) {
        ++result.list[result.of[triangle_of(outline.front())]].outlines;
    });
    return result;
}

#define DSC_INSTANTIATE_SIMPLEX(Real, Simplex)                                                     \
    template bool is_boundary(const Complex<Real>&, Simplex);                                      \
    template bool is_interface(const Complex<Real>&, Simplex);
#define DSC_INSTANTIATE(Real)                                                                      \
    template std::vector<Phase> phases(const Complex<Real>&);                                      \
    template double phase_area(const Complex<Real>&, Phase);                                       \
    template Components components(const Complex<Real>&);                                          \
    DSC_INSTANTIATE_SIMPLEX(Real, Vertex)                                                          \
    DSC_INSTANTIATE_SIMPLEX(Real, Edge)                                                            \
    DSC_INSTANTIATE_SIMPLEX(Real, Triangle)
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE
#undef DSC_INSTANTIATE_SIMPLEX

} // namespace dsc
