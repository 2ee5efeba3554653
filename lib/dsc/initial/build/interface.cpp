// SPDX-License-Identifier: MIT
#include "dsc/initial/build/interface.h"

#include "dsc/base/error.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/circulate.h"
#include "dsc/geometry/points.h"
#include "dsc/geometry/predicates.h"
#include "dsc/initial/build/insertion.h"
#include "dsc/initial/build/star_quality.h"
#include "dsc/operations/edge_flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

namespace dsc::initial {

namespace {

std::uint32_t clamped(double value, std::uint32_t low, std::uint32_t high) {
    return static_cast<std::uint32_t>(
        std::clamp(value, static_cast<double>(low), static_cast<double>(high)));
}

// Collapses an inner vertex of one phase into the neighbour that leaves the best triangles.
template <class Real>
void remove_vertex(Complex<Real>& complex, std::uint32_t vertex, std::vector<Corner>& stack) {
    Star<Real> star;
    if (gather(complex, Region{}, vertex, star)) {
        collapse_along(complex, star, best_collapse(star).incident_edge, stack);
    }
}

// Removes the inner vertices of the lattice within reach of the piece from a to b.
template <class Real>
void clear_piece(Complex<Real>& complex, const Lattice& lattice, const Point<double>& a,
                 const Point<double>& b, double reach, std::vector<Corner>& stack) {
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
                complex.is_alive(Vertex{id})) {
                remove_vertex(complex, id, stack);
            }
        }
    }
}

using Pair = std::array<std::uint32_t, 2>;

// Finds the edges that the segment crosses, up to its end or to the first vertex on it.
struct Crossings {
    std::uint32_t end = no_id;
    std::deque<Pair> edges; // ends right and left of the segment
};

template <class Real>
class Recovery {
public:
    explicit Recovery(Complex<Real>& complex) : complex_(complex) {}

    // Appends the vertices after p, q included, and makes all edges between them.
    void recover(std::uint32_t p, std::uint32_t q, Chain& chain) {
        while (p != q) {
            std::uint32_t end = q;
            if (!complex_.find_edge(Vertex{p}, Vertex{q}).is_valid()) {
                Crossings crossings = trace(p, q);
                end = crossings.end;
                flip_away(p, end, crossings.edges);
            }
            chain.push_back(end);
            p = end;
        }
    }

    std::vector<std::uint32_t> touched;

private:
    [[nodiscard]] int side(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return orientation<Real>(complex_.position(Vertex{a}), complex_.position(Vertex{b}),
                                 complex_.position(Vertex{c}));
    }

    [[nodiscard]] bool is_ahead(std::uint32_t p, std::uint32_t q, std::uint32_t v) const {
        const Point<Real> direction = complex_.position(Vertex{q}) - complex_.position(Vertex{p});
        return direction.dot(complex_.position(Vertex{v}) - complex_.position(Vertex{p})) > 0;
    }

    Crossings trace(std::uint32_t p, std::uint32_t q) const {
        Crossings crossings;
        Corner into = no_id;
        for_each_corner(complex_, Vertex{p}, [&](Corner c) {
            const std::uint32_t a = complex_.vertex(next(c));
            const std::uint32_t b = complex_.vertex(prev(c));
            for (const std::uint32_t v : {a, b}) {
                if (side(p, q, v) == 0 && is_ahead(p, q, v)) {
                    crossings.end = v;
                }
            }
            if (side(p, q, a) < 0 && side(p, q, b) > 0) {
                into = c;
            }
        });
        if (crossings.end != no_id) {
            return crossings; // the edge to a vertex on the segment exists already
        }
        while (into != no_id) {
            crossings.edges.push_back({complex_.vertex(next(into)), complex_.vertex(prev(into))});
            const Corner other = complex_.twin(into);
            if (is_border(other)) {
                break;
            }
            const std::uint32_t apex = complex_.vertex(other);
            const int sign = apex == q ? 0 : side(p, q, apex);
            if (sign == 0) {
                crossings.end = apex;
                return crossings;
            }
            // Counter-clockwise about `other`, first the left and then the right end of the edge
            // just crossed.
            into = sign > 0 ? next(other) : prev(other);
        }
        throw InvariantError(
            "initial_complex: the edges that cross a segment of the interface lead "
            "to the domain boundary instead of its end");
    }

    void flip_away(std::uint32_t p, std::uint32_t q, std::deque<Pair>& edges) {
        const Submesh whole = Submesh(complex_);
        // Each flip of a strictly convex quadrilateral makes progress; there always is one.
        std::size_t patience = 64 + 16 * edges.size() * edges.size();
        while (!edges.empty()) {
            if (patience-- == 0) {
                throw InvariantError(
                    "initial_complex: edges still cross a segment of the interface after the "
                    "largest number of flips");
            }
            const auto [right, left] = edges.front();
            edges.pop_front();
            const Corner corner = complex_.find_half_edge(Vertex{right}, Vertex{left});
            const Corner other = corner == no_id ? border_corner : complex_.twin(corner);
            if (is_border(other)) {
                throw InvariantError("initial_complex: an edge that crosses a segment of the "
                                     "interface is lost, or lies on the domain boundary");
            }
            const std::uint32_t a = complex_.vertex(corner);
            const std::uint32_t d = complex_.vertex(other);
            if (edge_flip(whole, corner) != Verdict::legal) {
                edges.push_back({right, left});
                continue;
            }
            touched.insert(touched.end(), {a, d, right, left});
            if (a == p || a == q || d == p || d == q) {
                continue;
            }
            const int side_a = side(p, q, a);
            if (side_a * side(p, q, d) < 0) {
                edges.push_back(side_a < 0 ? Pair{a, d} : Pair{d, a});
            }
        }
    }

    Complex<Real>& complex_;
};

} // namespace

template <class Real>
void clear_lattice(Complex<Real>& complex, const Lattice& lattice,
                   std::span<const CheckedPath> paths, double clearance) {
    std::vector<Corner> stack;
    if (lattice.rows < 2) {
        return;
    }
    for (const CheckedPath& each : paths) {
        const std::vector<Point<double>>& path = each.points;
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            const double reach = clearance * (path[i + 1] - path[i]).norm();
            clear_piece(complex, lattice, path[i], path[i + 1], reach, stack);
        }
    }
}

template <class Real>
Chains insert_paths(Complex<Real>& complex, const Lattice& lattice,
                    std::span<const CheckedPath> paths) {
    Chains chains;
    std::vector<Corner> stack;
    for (const CheckedPath& each : paths) {
        const std::vector<Point<double>>& path = each.points;
        auto& chain = chains.emplace_back();
        chain.reserve(path.size());
        std::uint32_t near = lattice.triangle_near(path.front());
        while (!complex.is_alive(Triangle{near})) {
            // This triangle was removed: try the next one. The lattice's triangles at the corners
            // of the domain always remain.
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

template <class Real>
std::vector<std::uint32_t> recover_segments(Complex<Real>& complex, Chains& chains) {
    Recovery<Real> recovery(complex);
    for (auto& chain : chains) {
        Chain whole;
        whole.reserve(chain.size());
        whole.push_back(chain.front());
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            recovery.recover(chain[i], chain[i + 1], whole);
        }
        chain = std::move(whole);
    }
    return std::move(recovery.touched);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void clear_lattice(Complex<Real>&, const Lattice&, std::span<const CheckedPath>,      \
                                double);                                                           \
    template Chains insert_paths(Complex<Real>&, const Lattice&, std::span<const CheckedPath>);    \
    template std::vector<std::uint32_t> recover_segments(Complex<Real>&, Chains&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc::initial
