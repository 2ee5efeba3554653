// SPDX-License-Identifier: MIT
#include "fluid/field/snapshot_field.h"

#include <algorithm>

namespace dsc {

namespace {

// A point counts as inside down to this coordinate, so that rounding cannot make a search alternate
// between two triangles. The velocity is continuous, so either triangle is right.
constexpr double inside = -1e-12;

inline Barycentric coordinates(const MeshSnapshot& mesh, const SnapshotTriangle& t,
                               const Point<double>& x) {
    const Point<double>& c = mesh.nodes[t.nodes[2]];
    const Point<double> a = mesh.nodes[t.nodes[0]] - c;
    const Point<double> b = mesh.nodes[t.nodes[1]] - c;
    const Point<double> way = x - c;
    const double inverse = 1 / (a.x() * b.y() - a.y() * b.x());
    const double first = (way.x() * b.y() - way.y() * b.x()) * inverse;
    const double second = (a.x() * way.y() - a.y() * way.x()) * inverse;
    return {first, second, 1 - first - second};
}

// The best triangle for a point by a search of all, for walks that do not end: only in a Delaunay
// triangulation every walk ends.
Spot look_everywhere(const MeshSnapshot& mesh, const Point<double>& x) {
    Spot best;
    double largest = -std::numeric_limits<double>::infinity();
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Barycentric at = coordinates(mesh, mesh.triangles[t], x);
        if (const double smallest = *std::ranges::min_element(at); smallest > largest) {
            largest = smallest;
            best = {t, at};
        }
    }
    return best;
}

// Whether a search has reached an edge of the domain, beyond rounding.
bool is_beyond(const Barycentric& at) {
    constexpr double beyond = -1e-9;
    return std::ranges::any_of(at, [](double a) { return a < beyond; });
}

// A point of the triangle close to the nearest one, so that polynomials are not evaluated outside.
Spot pulled_in(Spot spot) {
    double sum = 0;
    for (double& a : spot.at) {
        a = std::max(a, 0.0);
        sum += a;
    }
    for (double& a : spot.at) {
        a /= sum;
    }
    return spot;
}

// A point behind an edge of the domain: a little outside, where a side is curved, or on the other
// side of a hole or notch.
Spot beside_boundary(const MeshSnapshot& mesh, const Point<double>& x, const Spot& end) {
    constexpr double near = -0.5;
    const bool is_near = std::ranges::all_of(end.at, [](double a) { return a > near; });
    const Spot found = is_near ? end : look_everywhere(mesh, x);
    return is_beyond(found.at) ? pulled_in(found) : found;
}

// Checks that all indices are in range.
bool has_valid_numbers(const FluidField& field) {
    const MeshSnapshot& mesh = field.mesh;
    const auto is_node = [&](std::uint32_t node) { return node < mesh.nodes.size(); };
    const auto is_triangle_or_none = [&](std::uint32_t t) {
        return t < mesh.triangles.size() || t == no_id;
    };
    return !mesh.triangles.empty() && mesh.vertex_bound <= mesh.nodes.size() &&
           mesh.triangle_at.size() == mesh.vertex_bound &&
           field.velocity.size() == mesh.nodes.size() &&
           field.pressure.size() == mesh.triangles.size() &&
           std::ranges::all_of(mesh.triangle_at, is_triangle_or_none) &&
           std::ranges::is_sorted(mesh.features) &&
           std::ranges::all_of(mesh.triangles,
                               [&](const SnapshotTriangle& t) {
                                   return std::ranges::all_of(t.nodes, is_node) &&
                                          std::ranges::all_of(t.across, is_triangle_or_none);
                               }) &&
           std::ranges::all_of(mesh.interface, [&](const SnapshotEdge& e) {
               return is_node(e.from) && is_node(e.to) && is_node(e.middle);
           });
}

} // namespace

MeshSnapshot snapshot_of(const Complex<double>& complex) {
    MeshSnapshot mesh;
    mesh.vertex_bound = complex.vertex_bound();
    mesh.nodes.reserve(4 * std::size_t{mesh.vertex_bound});
    mesh.nodes.assign(mesh.vertex_bound, Point<double>(0, 0));
    mesh.triangle_at.assign(mesh.vertex_bound, no_id);
    std::vector<std::uint32_t> compact(complex.triangle_bound(), no_id);
    std::uint32_t count = 0;
    for (const Triangle t : triangles(complex)) {
        compact[t.id] = count++;
    }
    mesh.triangles.resize(count);

    bool is_first = true;
    for (const Vertex v : vertices(complex)) {
        const Point<double> p = complex.position(v);
        mesh.nodes[v.id] = p;
        mesh.domain.low = is_first ? p : Point<double>(mesh.domain.low.cwiseMin(p));
        mesh.domain.high = is_first ? p : Point<double>(mesh.domain.high.cwiseMax(p));
        is_first = false;
        if (complex.is_boundary_feature(v)) {
            mesh.features.push_back(v.id);
        }
    }
    for (const Triangle t : triangles(complex)) {
        SnapshotTriangle& copy = mesh.triangles[compact[t.id]];
        copy.phase = complex.phase(t);
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner corner = corner_of(t.id, i);
            copy.nodes[i] = complex.vertex(corner);
            copy.across[i] = compact[triangle_of(complex.twin(corner))];
            mesh.triangle_at[copy.nodes[i]] = compact[t.id];
        }
    }
    for (const Edge e : edges(complex)) {
        const auto middle = static_cast<std::uint32_t>(mesh.nodes.size());
        const auto [from, to] = complex.vertices_of(e);
        mesh.nodes.emplace_back((complex.position(from) + complex.position(to)) / 2);
        mesh.triangles[compact[triangle_of(e.id)]].nodes[3 + index_of(e.id)] = middle;
        const Corner twin = complex.twin(e.id);
        if (is_border(twin)) {
            continue;
        }
        mesh.triangles[compact[triangle_of(twin)]].nodes[3 + index_of(twin)] = middle;
        const Phase left = complex.phase_at(e.id);
        const Phase right = complex.phase_at(twin);
        if (left != right) {
            mesh.interface.push_back({from.id, to.id, middle, left, right});
        }
    }
    return mesh;
}

double area(const MeshSnapshot& mesh, const SnapshotTriangle& triangle) {
    return area(mesh.nodes[triangle.nodes[0]], mesh.nodes[triangle.nodes[1]],
                mesh.nodes[triangle.nodes[2]]);
}

Eigen::Matrix<double, 2, 3> slopes_of(const MeshSnapshot& mesh, const SnapshotTriangle& t,
                                      double area) {
    Eigen::Matrix<double, 2, 3> slopes;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const Point<double> side = mesh.nodes[t.nodes[prev_index(static_cast<std::uint32_t>(i))]] -
                                   mesh.nodes[t.nodes[next_index(static_cast<std::uint32_t>(i))]];
        slopes.col(i) = Point<double>(-side.y(), side.x()) / (2 * area);
    }
    return slopes;
}

std::uint32_t start_at(const MeshSnapshot& mesh, std::uint32_t vertex) {
    const std::uint32_t found = vertex < mesh.vertex_bound ? mesh.triangle_at[vertex] : no_id;
    return found == no_id ? 0 : found;
}

Spot find_spot(const MeshSnapshot& mesh, Point<double> point, std::uint32_t start) {
    point = point.cwiseMax(mesh.domain.low).cwiseMin(mesh.domain.high);
    std::uint32_t t = start;
    for (std::size_t steps = 0; steps < mesh.triangles.size(); ++steps) {
        const SnapshotTriangle& triangle = mesh.triangles[t];
        const Barycentric at = coordinates(mesh, triangle, point);
        // Continues across the edge behind which the point is farthest, unless that is an edge of
        // the domain.
        std::uint32_t towards = no_id;
        double smallest = inside;
        for (std::uint32_t i = 0; i < 3; ++i) {
            if (at[i] < smallest && triangle.across[i] != no_id) {
                smallest = at[i];
                towards = triangle.across[i];
            }
        }
        if (towards == no_id) {
            return is_beyond(at) ? beside_boundary(mesh, point, {t, at}) : Spot{t, at};
        }
        t = towards;
    }
    return look_everywhere(mesh, point);
}

void archive(Archive& archive, FluidField& field) {
    MeshSnapshot& mesh = field.mesh;
    archive(mesh.domain.low, mesh.domain.high, mesh.vertex_bound, mesh.nodes, mesh.triangle_at,
            mesh.features, field.time, field.velocity, field.side_forces);
    archive.records(mesh.triangles);
    archive.records(mesh.interface);
    archive.records(field.pressure);
    if (archive.is_reading()) {
        archive.expect(has_valid_numbers(field), "contains a flow that does not match its mesh");
    }
}

Point<double> velocity_at(const FluidField& field, const Spot& spot) {
    const SnapshotTriangle& triangle = field.mesh.triangles[spot.triangle];
    const Eigen::Matrix<double, 6, 1> shapes = quadratic_shapes(spot.at);
    Point<double> velocity(0, 0);
    for (int i = 0; const std::uint32_t node : triangle.nodes) {
        velocity += shapes[i++] * field.velocity[node];
    }
    return velocity;
}

Point<double> velocity_along(const FluidField& field, const Spot& spot, const Point<double>& way) {
    const SnapshotTriangle& triangle = field.mesh.triangles[spot.triangle];
    const Eigen::Matrix<double, 2, 6> gradients =
        quadratic_gradients(spot.at, slopes_of(field.mesh, triangle, area(field.mesh, triangle)));
    Point<double> change(0, 0);
    for (Eigen::Index i = 0; const std::uint32_t node : triangle.nodes) {
        change += gradients.col(i++).dot(way) * field.velocity[node];
    }
    return change;
}

double pressure_at(const FluidField& field, const Spot& spot) {
    const std::array<double, 3>& p = field.pressure[spot.triangle];
    return spot.at[0] * p[0] + spot.at[1] * p[1] + spot.at[2] * p[2];
}

} // namespace dsc
