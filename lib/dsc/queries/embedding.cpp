// SPDX-License-Identifier: MIT
#include "dsc/queries/embedding.h"

#include "dsc/geometry/contacts.h"
#include "dsc/geometry/predicates.h"
#include "dsc/queries/phases.h"

#include <vector>

namespace dsc {

namespace {

// The edges of the boundary, each with its triangle on the left.
struct Boundary {
    std::vector<Point<double>> points;     // where edge i begins
    std::vector<NetworkLine> edges;        // edge i: from point i to the next one of its loop
    std::vector<Vertex> vertices;          // at point i
    std::vector<std::uint32_t> components; // of edge i
    std::vector<std::uint32_t> loops;      // the first edge of each

    [[nodiscard]] std::string name(std::uint32_t edge) const {
        return "boundary edge " + std::to_string(vertices[edge].id) + "-" +
               std::to_string(vertices[edges[edge].to].id);
    }
};

template <class Real>
Boundary collect_boundary(const Complex<Real>& complex,
                          const std::vector<std::uint32_t>& component) {
    Boundary boundary;
    const auto is_edge = [&](Corner c) { return is_border(complex.twin(c)); };
    const HalfEdges half_edges(complex, is_edge);
    for_each_loop(complex, half_edges, is_edge, [&](std::span<const Corner> loop) {
        const auto first = static_cast<std::uint32_t>(boundary.edges.size());
        boundary.loops.push_back(first);
        for (const Corner c : loop) {
            const Vertex from{complex.vertex(next(c))};
            const auto edge = static_cast<std::uint32_t>(boundary.edges.size());
            boundary.points.push_back(complex.position(from).template cast<double>());
            boundary.edges.push_back({edge, edge + 1});
            boundary.vertices.push_back(from);
            boundary.components.push_back(component[triangle_of(c)]);
        }
        boundary.edges.back().to = first;
    });
    return boundary;
}

// The winding number of the boundaries of the other components about the start of an edge.
int winding_of_others(const Boundary& boundary, std::uint32_t edge) {
    int winding = 0;
    const Point<double>& p = boundary.points[edge];
    for (std::size_t i = 0; i < boundary.edges.size(); ++i) {
        if (boundary.components[i] == boundary.components[edge]) {
            continue;
        }
        const Point<double>& a = boundary.points[i];
        const Point<double>& b = boundary.points[boundary.edges[i].to];
        if (a.y() <= p.y() && p.y() < b.y()) {
            winding += orientation<double>(a, b, p) > 0 ? 1 : 0;
        } else if (b.y() <= p.y() && p.y() < a.y()) {
            winding -= orientation<double>(a, b, p) < 0 ? 1 : 0;
        }
    }
    return winding;
}

} // namespace

template <class Real>
std::string find_overlap(const Complex<Real>& complex, ValidationReport& report) {
    const Parts parts = label_parts(complex, [](Triangle) { return std::array{true, true, true}; });
    report.components = parts.count;
    const Boundary boundary = collect_boundary(complex, parts.of);
    report.boundary_loops = boundary.loops.size();
    report.edges = (3 * report.triangles + boundary.edges.size()) / 2;
    report.euler_characteristic = static_cast<std::int64_t>(report.vertices + report.triangles) -
                                  static_cast<std::int64_t>(report.unused_vertices + report.edges);
    const std::int64_t expected = 2 * static_cast<std::int64_t>(report.components) -
                                  static_cast<std::int64_t>(report.boundary_loops);
    if (report.euler_characteristic != expected) {
        return "Euler characteristic: V - E + T is " + std::to_string(report.euler_characteristic) +
               " instead of " + std::to_string(expected) + " for " +
               std::to_string(report.components) + " components with " +
               std::to_string(report.boundary_loops) +
               " boundary loops: it cannot be embedded in the plane";
    }
    // Edges that share a vertex meet only there, because the half disc around it does not overlap
    // itself.
    if (const auto contact = find_contact(boundary.points, boundary.edges)) {
        return boundary.name(contact->line) + " meets " + boundary.name(contact->other) +
               ": the domain overlaps itself";
    }
    for (const std::uint32_t loop : boundary.loops) {
        if (report.components > 1 && winding_of_others(boundary, loop) != 0) {
            return boundary.name(loop) + " lies inside another component: they overlap";
        }
    }
    return {};
}

template std::string find_overlap(const Complex<double>&, ValidationReport&);
template std::string find_overlap(const Complex<float>&, ValidationReport&);

} // namespace dsc
