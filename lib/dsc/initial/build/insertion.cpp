// SPDX-License-Identifier: MIT
#include "dsc/initial/build/insertion.h"

#include "dsc/base/error.h"
#include "dsc/complex/walk.h"
#include "dsc/initial/build/delaunay.h"

namespace dsc::initial {

template <class Real>
Location locate(const Complex<Real>& complex, std::uint32_t start, const Point<Real>& point) {
    const WalkEnd end =
        walk(complex, Triangle{start}, point, 8 * complex.triangles.size() + 64,
             [&](Corner c) { return complex.phase_at(c) == complex.phase_at(complex.twin(c)); });
    switch (end.kind) {
    case WalkEnd::Kind::triangle: return {Place::triangle, end.corner};
    case WalkEnd::Kind::edge: return {Place::edge, end.corner};
    case WalkEnd::Kind::vertex: return {Place::vertex, end.corner};
    case WalkEnd::Kind::stopped: return {Place::beyond, end.corner};
    case WalkEnd::Kind::lost: break;
    }
    throw InvariantError("locate: the walk does not arrive");
}

template <class Real>
std::uint32_t insert_point(Complex<Real>& complex, const Location& location,
                           const Point<Real>& point, std::vector<Corner>& stack) {
    if (location.place == Place::beyond) {
        throw InvariantError("insert_point: the point was not located");
    }
    if (location.place == Place::vertex) {
        return complex.vertex(location.corner);
    }
    Corner corner = location.corner;
    if (location.place == Place::triangle) {
        while (is_border(complex.twin(corner))) {
            corner = next(corner);
        }
    }
    const Corner other = complex.twin(corner);
    const std::uint32_t m = complex.take_vertex(complex.ids);
    const std::uint32_t t2 = complex.take_triangle(complex.ids);
    const std::uint32_t u2 = is_border(other) ? no_id : complex.take_triangle(complex.ids);
    rewire::split(complex, complex.journal, corner, m, point, t2, u2);
    if (location.place == Place::triangle) {
        // One into three: split an edge as if m were on it, then flip the edge from m into the
        // triangle beyond back to its old place. That triangle is u2 now, and u lies on this side.
        rewire::flip(complex, complex.journal, next(other));
        complex.triangles[triangle_of(other)].phase = complex.phase_at(corner);
    }
    legalise_star(complex, m, stack);
    return m;
}

template <class Real>
Chains insert_paths(Complex<Real>& complex, const Lattice& lattice, std::span<const Path> paths) {
    Chains chains;
    std::vector<Corner> stack;
    for (const Path& path : paths) {
        auto& chain = chains.emplace_back();
        chain.reserve(path.size());
        std::uint32_t near = lattice.triangle_near(path.front());
        while (!complex.is_alive(Triangle{near})) {
            // It was removed. The triangles of the lattice at the corners of the domain are left.
            near = near + 1 < complex.triangle_bound() ? near + 1 : 1;
        }
        for (const Point<double>& place : path) {
            const Point<Real> point = place.template cast<Real>();
            const std::uint32_t id =
                insert_point(complex, locate(complex, near, point), point, stack);
            chain.push_back(id);
            near = triangle_of(complex.vertices[id].corner);
        }
    }
    return chains;
}

template Location locate(const Complex<double>&, std::uint32_t, const Point<double>&);
template Location locate(const Complex<float>&, std::uint32_t, const Point<float>&);
template std::uint32_t insert_point(Complex<double>&, const Location&, const Point<double>&,
                                    std::vector<Corner>&);
template std::uint32_t insert_point(Complex<float>&, const Location&, const Point<float>&,
                                    std::vector<Corner>&);
template Chains insert_paths(Complex<double>&, const Lattice&, std::span<const Path>);
template Chains insert_paths(Complex<float>&, const Lattice&, std::span<const Path>);

} // namespace dsc::initial
