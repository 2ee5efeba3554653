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

// Collapses an inner vertex of one phase into the neighbour that leaves the best triangles.
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

template std::size_t clear_lattice(Complex<double>&, const Lattice&, std::span<const Path>, double);
template std::size_t clear_lattice(Complex<float>&, const Lattice&, std::span<const Path>, double);

} // namespace dsc::initial
