// SPDX-License-Identifier: MIT
#include "dsc/initial/build/insertion.h"

#include "dsc/base/error.h"
#include "dsc/complex/walk.h"
#include "dsc/geometry/distance.h"
#include "dsc/initial/build/delaunay.h"
#include "dsc/initial/build/star_quality.h"
#include "dsc/operations/edge_collapse.h"

#include <algorithm>
#include <cmath>

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

namespace {

std::uint32_t clamped(double value, std::uint32_t low, std::uint32_t high) {
    return static_cast<std::uint32_t>(
        std::clamp(value, static_cast<double>(low), static_cast<double>(high)));
}

// Collapses an inner vertex of one phase into the neighbour that leaves the best triangles.
template <class Real>
bool remove_vertex(Complex<Real>& complex, std::uint32_t vertex, std::vector<Corner>& stack) {
    Ring<Real> ring;
    if (!gather(complex, Region{}, vertex, ring) || !ring.closed) {
        return false;
    }
    const CollapseChoice best = best_collapse(ring);
    if (best.spoke == no_id) {
        return false;
    }
    const std::uint32_t keep = ring.link[best.spoke];
    // The spoke is opposite to the previous corner of the triangle that begins with it.
    const Corner corner = prev(ring.corner[best.spoke]);
    if (edge_collapse(complex, whole_submesh(complex), corner, rewire::Vanishing::next) !=
        Verdict::legal) {
        return false;
    }
    legalise_star(complex, keep, stack);
    return true;
}

} // namespace

template <class Real>
std::size_t clear_lattice(Complex<Real>& complex, const Lattice& lattice,
                          std::span<const Outline> outlines, double clearance) {
    std::size_t removed = 0;
    std::vector<Corner> stack;
    if (lattice.rows < 2) {
        return 0;
    }
    for (const Outline& outline : outlines) {
        const std::size_t n = outline.points.size();
        for (std::size_t i = 0; i < n; ++i) {
            const Point<double>& a = outline.points[i];
            const Point<double>& b = outline.points[i + 1 < n ? i + 1 : 0];
            const double reach = clearance * (b - a).norm();
            const auto row_of = [&](double y) { return (y - lattice.low.y()) / lattice.height; };
            const auto column_of = [&](double x) {
                return (x - lattice.low.x()) / lattice.spacing;
            };
            const std::uint32_t first_row =
                clamped(std::floor(row_of(std::min(a.y(), b.y()) - reach)), 1, lattice.rows - 1);
            const std::uint32_t last_row =
                clamped(std::ceil(row_of(std::max(a.y(), b.y()) + reach)), 1, lattice.rows - 1);
            for (std::uint32_t row = first_row; row <= last_row; ++row) {
                const std::uint32_t last = lattice.vertices_in_row(row) - 1;
                if (last < 2) {
                    continue;
                }
                const std::uint32_t from =
                    clamped(std::floor(column_of(std::min(a.x(), b.x()) - reach)), 1, last - 1);
                const std::uint32_t to =
                    clamped(std::ceil(column_of(std::max(a.x(), b.x()) + reach)) + 1, 1, last - 1);
                for (std::uint32_t column = from; column <= to; ++column) {
                    const std::uint32_t id = lattice.vertex(row, column);
                    const Point<double> p(lattice.x(row, column), lattice.y(row));
                    if (squared_distance<double>(p, nearest_point<double>(p, a, b)) <
                            reach * reach &&
                        complex.is_alive(Vertex{id}) && remove_vertex(complex, id, stack)) {
                        ++removed;
                    }
                }
            }
        }
    }
    return removed;
}

template <class Real>
std::vector<std::vector<std::uint32_t>>
insert_outlines(Complex<Real>& complex, const Lattice& lattice, std::span<const Outline> outlines) {
    std::vector<std::vector<std::uint32_t>> chains;
    std::vector<Corner> stack;
    for (const Outline& outline : outlines) {
        auto& chain = chains.emplace_back();
        chain.reserve(outline.points.size());
        std::uint32_t near = lattice.triangle_near(outline.points.front());
        while (!complex.is_alive(Triangle{near})) {
            // It was removed. The triangles of the lattice at the corners of the domain are left.
            near = near + 1 < complex.triangle_bound() ? near + 1 : 1;
        }
        for (const Point<double>& place : outline.points) {
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
template std::size_t clear_lattice(Complex<double>&, const Lattice&, std::span<const Outline>,
                                   double);
template std::size_t clear_lattice(Complex<float>&, const Lattice&, std::span<const Outline>,
                                   double);
template std::vector<std::vector<std::uint32_t>> insert_outlines(Complex<double>&, const Lattice&,
                                                                 std::span<const Outline>);
template std::vector<std::vector<std::uint32_t>> insert_outlines(Complex<float>&, const Lattice&,
                                                                 std::span<const Outline>);

} // namespace dsc::initial
