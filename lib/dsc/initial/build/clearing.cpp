// SPDX-License-Identifier: MIT
#include "dsc/initial/build/clearing.h"

#include "dsc/geometry/distance.h"
#include "dsc/initial/build/delaunay.h"
#include "dsc/initial/build/star_quality.h"

#include <algorithm>
#include <cmath>

namespace dsc::initial {

namespace {

std::uint32_t clamped(double value, std::uint32_t low, std::uint32_t high) {
    return static_cast<std::uint32_t>(
        std::clamp(value, static_cast<double>(low), static_cast<double>(high)));
}

// Collapses a vertex of one phase into the neighbour that leaves the best triangles.
template <class Real>
bool remove_vertex(Complex<Real>& complex, std::uint32_t vertex, std::vector<Corner>& stack) {
    Ring<Real> ring;
    if (!gather(complex, Region{}, vertex, ring)) {
        return false;
    }
    const CollapseChoice best = best_collapse(ring);
    if (best.spoke == no_id || !collapse_along(complex, ring, best.spoke)) {
        return false;
    }
    legalise_star(complex, ring.link[best.spoke], stack);
    return true;
}

// Removes the inner vertices of the lattice within reach of the piece from a to b.
template <class Real>
std::size_t clear_piece(Complex<Real>& complex, const Lattice& lattice, const Point<double>& a,
                        const Point<double>& b, double reach, std::vector<Corner>& stack) {
    std::size_t removed = 0;
    const auto row_of = [&](double y) { return (y - lattice.low.y()) / lattice.height; };
    const auto column_of = [&](double x) { return (x - lattice.low.x()) / lattice.spacing; };
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
            if (squared_distance<double>(p, nearest_point<double>(p, a, b)) < reach * reach &&
                complex.is_alive(Vertex{id}) && remove_vertex(complex, id, stack)) {
                ++removed;
            }
        }
    }
    return removed;
}

// A vertex of the lattice by its row and column, and the distance to its neighbours on its side.
struct SideVertex {
    std::uint32_t row;
    std::uint32_t column;
    double spacing;
};

// The vertices of the lattice on either side of a point on a side of the domain; none elsewhere.
std::vector<SideVertex> side_vertices_near(const Lattice& lattice, const Point<double>& p) {
    std::vector<SideVertex> near;
    for (const std::uint32_t row : {0U, lattice.rows}) {
        if (p.y() == lattice.y(row)) {
            // Vertex k of an odd row lies at k - 1/2, except for the two at the corners.
            const std::uint32_t last = lattice.vertices_in_row(row) - 1;
            const double place = (p.x() - lattice.low.x()) / lattice.spacing;
            const std::uint32_t from = clamped(std::floor(place), 0, last);
            for (std::uint32_t column = from; column <= std::min(from + 2, last); ++column) {
                near.push_back({row, column, lattice.spacing});
            }
        }
    }
    for (const bool right : {false, true}) {
        if (p.x() == (right ? lattice.high.x() : lattice.low.x())) {
            const double place = (p.y() - lattice.low.y()) / lattice.height;
            const std::uint32_t from = clamped(std::floor(place), 0, lattice.rows);
            for (std::uint32_t row = from; row <= std::min(from + 1, lattice.rows); ++row) {
                near.push_back({row, right ? lattice.vertices_in_row(row) - 1 : 0, lattice.height});
            }
        }
    }
    return near;
}

bool is_corner(const Lattice& lattice, const SideVertex& v) {
    return (v.row == 0 || v.row == lattice.rows) &&
           (v.column == 0 || v.column + 1 == lattice.vertices_in_row(v.row));
}

} // namespace

template <class Real>
std::size_t clear_lattice(Complex<Real>& complex, const Lattice& lattice,
                          std::span<const Path> paths, double clearance) {
    std::size_t removed = 0;
    std::vector<Corner> stack;
    if (lattice.rows < 2) {
        return 0;
    }
    for (const Path& path : paths) {
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            const double reach = clearance * (path[i + 1] - path[i]).norm();
            removed += clear_piece(complex, lattice, path[i], path[i + 1], reach, stack);
        }
    }
    return removed;
}

template <class Real>
std::size_t clear_sides(Complex<Real>& complex, const Lattice& lattice, std::span<const Path> paths,
                        double clearance) {
    std::size_t removed = 0;
    std::vector<Corner> stack;
    for (const Path& path : paths) {
        for (const Point<double>& end : {path.front(), path.back()}) {
            for (const SideVertex& v : side_vertices_near(lattice, end)) {
                const std::uint32_t id = lattice.vertex(v.row, v.column);
                const Point<double> p(lattice.x(v.row, v.column), lattice.y(v.row));
                if (p != end && (p - end).norm() < clearance * v.spacing &&
                    !is_corner(lattice, v) && complex.is_alive(Vertex{id}) &&
                    remove_vertex(complex, id, stack)) {
                    ++removed;
                }
            }
        }
    }
    return removed;
}

template std::size_t clear_lattice(Complex<double>&, const Lattice&, std::span<const Path>, double);
template std::size_t clear_lattice(Complex<float>&, const Lattice&, std::span<const Path>, double);
template std::size_t clear_sides(Complex<double>&, const Lattice&, std::span<const Path>, double);
template std::size_t clear_sides(Complex<float>&, const Lattice&, std::span<const Path>, double);

} // namespace dsc::initial
