// SPDX-License-Identifier: MIT
#include "geometric_flows/curve_network.h"

#include "dsc/complex/circulate.h"
#include "dsc/geometry/side.h"

#include <algorithm>
#include <cmath>

namespace dsc {

namespace {

/// Edges are taken to be at least this long, so that the matrix stays finite where two vertices of
/// an intermediate stage coincide. Its square is still a normal number.
constexpr double shortest_edge = 1e-150;
/// The smallest length in a step, relative to the distance that curvature moves a curve in it. A
/// piece whose edges are this short has a drag of 1e-12 of their stiffness, and collapses to its
/// centre. A drag below the rounding error, 1e-16, would make the matrix singular, and stop all
/// curves.
constexpr double shortest_share = 1e-6;

double length_of(const CurveEdge& edge, std::span<const Vector2> positions, double shortest) {
    return std::max(norm(positions[edge.to] - positions[edge.from]), shortest);
}

Freedom operator+(const Freedom& one, const Freedom& other) {
    return {one.xx + other.xx, one.xy + other.xy, one.yy + other.yy};
}

Freedom operator*(double factor, const Freedom& of) {
    return {factor * of.xx, factor * of.xy, factor * of.yy};
}

/// The projection onto a unit vector.
Freedom along(const Vector2& t) { return {t.x * t.x, t.x * t.y, t.y * t.y}; }

constexpr Block block_of(const Freedom& f) { return {f.xx, f.xy, f.xy, f.yy}; }

constexpr Freedom anywhere{};
constexpr Freedom nowhere{0, 0, 0};

Freedom rest_of(const Freedom& one) { return anywhere + -1.0 * one; }

/// The drag along a curve between junctions, relative to that across it: enough to determine the
/// position of a piece that has collapsed onto a straight line.
constexpr double drag_along = 1e-9;

} // namespace

template <class Real>
Freedom freedom_of(const InterfaceView<Real>& view, std::size_t i) {
    if ((view.flags[i] & interface_locked) != 0) {
        return nowhere;
    }
    if (!view.is_on_boundary(i)) {
        return anywhere;
    }
    const Complex<Real>& complex = view.complex;
    if (complex.is_boundary_feature(view.vertices[i])) {
        return nowhere;
    }
    Vector2 before;
    Vector2 after;
    const Vector2 here = vector_of(complex.position(view.vertices[i]));
    const auto way_to = [&](Corner c) {
        return vector_of(complex.position(Vertex{complex.vertex(c)})) - here;
    };
    for_each_corner(complex, view.vertices[i], [&](Corner c) {
        if (is_border(complex.twin(prev(c)))) {
            after = way_to(next(c));
        }
        if (is_border(complex.twin(next(c)))) {
            before = way_to(prev(c));
        }
    });
    if (after.x * before.y == after.y * before.x && dot(after, before) < 0) {
        return along(after / norm(after));
    }
    const Point<double> at(here.x, here.y);
    const Point<double> from(here.x + before.x, here.y + before.y);
    const Point<double> to(here.x + after.x, here.y + after.y);
    if (side_at<double>(from, at, to, false) == Side::feature) {
        return nowhere;
    }
    const Point<double> tangent = tangent_of_side<double>(from, at, to);
    return along({tangent.x(), tangent.y()});
}

void CurveSystem::begin(const CurveGraph& graph) {
    graph_ = &graph;
    solver_.begin(graph);
    const CurveNetwork& network = graph.network();
    fastest_ = 0;
    for (const CurveEdge& edge : network.edges) {
        if (edge.forces.drag > 0) {
            fastest_ = std::max(fastest_, edge.forces.tension / edge.forces.drag);
        }
    }
    const std::size_t n = network.positions.size();
    own_.resize(n);
    between_.resize(n);
    diagonal_.resize(n);
    coupling_.resize(network.edges.size());
}

void CurveSystem::Drag::add(double more, const Vector2& outwards) {
    const bool is_first = size == 0;
    size += more;
    tangent = is_first ? outwards : tangent - outwards;
}

// The drag acts across the curve, but in all directions at the tip of a spike.
Freedom CurveSystem::Drag::across() const {
    if (size == 0) {
        return nowhere;
    }
    const double length = norm(tangent);
    return length < 1e-3 ? size * anywhere
                         : size * (rest_of(along(tangent / length)) + drag_along * anywhere);
}

// For the displacements d: (drag / dt) d + A d = -A x, where A x is the sum of the tensions at each
// vertex, restricted to the directions in which the vertices can move.
//
// The tension of an edge that is stretched in the step grows with its length. If the vertices of a
// curve resisted motion along it, a junction that slides would stretch those next to it alone, and
// not balance its tensions: an error of the order of sqrt(dt). Without resistance, the whole curve
// stretches evenly, which is an error of the order of dt.
void CurveSystem::assemble(const CurvePart& part, std::span<const Vector2> positions, double dt,
                           std::span<Vector2> forces) {
    const CurveNetwork& network = graph_->network();
    const double shortest = std::max(shortest_share * std::sqrt(dt * fastest_), shortest_edge);
    for (const std::uint32_t i : part.vertices) {
        own_[i] = nowhere;
        between_[i] = {};
        forces[i] = {};
    }
    for (const std::uint32_t e : part.edges) {
        const CurveEdge& edge = network.edges[e];
        const Vector2 way = positions[edge.to] - positions[edge.from];
        const double length = length_of(edge, positions, shortest);
        const Vector2 direction = way / length;
        const double stiffness = edge.forces.tension / length;
        const double half = edge.forces.drag * length / (2 * dt);
        const auto add_at = [&](std::uint32_t i, double sign) {
            if (graph_->is_junction(i) != part.are_junctions) {
                return; // it belongs to another part
            }
            Freedom drag = half * anywhere;
            if (network.is_junction[i] != 0) {
                // A junction that moves along one of its curves does not move the curve.
                drag = half * rest_of(along(direction));
            } else if (network.is_between[i] != 0 && edge.forces.tension > 0) {
                between_[i].add(half, sign * direction);
                drag = nowhere;
            }
            own_[i] = own_[i] + (stiffness * anywhere + drag);
            forces[i] += sign * stiffness * way;
        };
        add_at(edge.from, 1);
        add_at(edge.to, -1);
        const Freedom& one = network.freedom[edge.from];
        const Freedom& other = network.freedom[edge.to];
        coupling_[e] = {-stiffness, 0, 0, -stiffness};
        if (!one.is_full() || !other.is_full()) {
            coupling_[e] = block_of(one) * coupling_[e] * block_of(other);
        }
    }
    if (part.are_junctions) {
        for (const EndForce& end : network.ends) {
            forces[end.vertex] += end.force;
        }
    }
    for (const std::uint32_t i : part.vertices) {
        const Freedom& free = network.freedom[i];
        diagonal_[i] = block_of(own_[i] + between_[i].across());
        if (!free.is_full()) {
            diagonal_[i] = block_of(free) * diagonal_[i] * block_of(free);
            diagonal_[i] += block_of(rest_of(free));
            forces[i] = free.of(forces[i]);
        }
    }
}

void CurveSystem::step(std::span<const Vector2> positions, double dt, const InShares& in_shares,
                       std::vector<Vector2>& displacements, const PressureRows& rows) {
    displacements.resize(positions.size());
    graph_->for_each_share(in_shares, [&](std::size_t share) {
        assemble(graph_->part(share), positions, dt, displacements);
        solver_.eliminate(share, diagonal_, coupling_);
        solver_.reduce(share, displacements);
        if (!rows.gains.empty()) {
            solver_.reduce(share, displacements, rows);
        }
    });
    assemble(graph_->junctions(), positions, dt, displacements);
    solver_.factorise_junctions(diagonal_, rows);
    solver_.finish(displacements, in_shares, rows);
}

template Freedom freedom_of(const InterfaceView<double>&, std::size_t);
template Freedom freedom_of(const InterfaceView<float>&, std::size_t);

} // namespace dsc
