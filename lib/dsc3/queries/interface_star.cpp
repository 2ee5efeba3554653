// SPDX-License-Identifier: MIT
#include "dsc3/queries/interface_star.h"

#include "dsc3/geometry/tet.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dsc3 {

bool InterfaceStar::has_edge_to(std::uint32_t vertex) const {
    return std::any_of(faces.begin(), faces.end(),
                       [&](const StarFace& f) { return f.x == vertex || f.y == vertex; });
}

void gather(const Complex& complex, const Star& star, InterfaceStar& interface_star) {
    interface_star.centre = star.centre;
    interface_star.faces.clear();
    interface_star.domain_edges.clear();
    for (const Corner corner : star.corners) {
        const std::uint32_t t = tet_of(corner);
        const TetRecord& tet = complex.tets[t];
        const auto& others = face_indices[index_of(corner)];
        for (std::uint32_t j = 0; j < 3; ++j) {
            const Corner other = tet.n[others[j]];
            const std::uint32_t x = tet.v[others[(j + 2) % 3]];
            const std::uint32_t y = tet.v[others[(j + 1) % 3]];
            // The border's phase is the largest.
            if (complex.phase_at(other) < complex.phases[t]) {
                interface_star.faces.push_back({x, y, t});
            } else if (is_border(other)) {
                interface_star.faces.push_back({y, x, border_tet});
                // Each edge is x of one face and y of another.
                if (std::popcount(complex.fixed_along(star.centre, y)) > 1) {
                    interface_star.domain_edges.push_back(y);
                }
            }
        }
    }
}

bool is_sheet(const InterfaceStar& interface_star) {
    if (interface_star.faces.empty()) {
        return false;
    }
    std::uint32_t met = 0;
    std::uint32_t at = interface_star.faces[0].x;
    do {
        const StarFace* next = nullptr;
        for (const StarFace& face : interface_star.faces) {
            if (face.x == at) {
                if (next != nullptr) {
                    return false;
                }
                next = &face;
            }
        }
        if (next == nullptr) {
            return false;
        }
        at = next->y;
        ++met;
    } while (at != interface_star.faces[0].x && met < interface_star.size());
    return met == interface_star.size() && at == interface_star.faces[0].x;
}

const StarEdge* InterfaceStar::edge_to(std::uint32_t vertex) const {
    const auto at = std::find_if(edges.begin(), edges.end(),
                                 [&](const StarEdge& edge) { return edge.vertex == vertex; });
    return at == edges.end() ? nullptr : &*at;
}

namespace {

// Follows a sheet from a face that begins at an edge on a curve to the next edge on a curve.
// Returns the number of faces and that edge; 0 if there is none.
std::pair<std::uint32_t, const StarEdge*> follow(const InterfaceStar& star, const StarFace& first) {
    const StarFace* face = &first;
    for (std::uint32_t count = 1; count <= star.size(); ++count) {
        const StarEdge* edge = star.edge_to(face->y);
        if (edge->is_on_curve()) {
            return {count, edge};
        }
        if (edge->as_x == no_id) {
            break;
        }
        face = &star.faces[edge->as_x];
    }
    return {0, nullptr};
}

bool is_curve(const InterfaceStar& star) {
    std::array<const StarEdge*, 2> ends{};
    std::size_t count = 0;
    for (const StarEdge& edge : star.edges) {
        if (edge.is_on_curve()) {
            if (count == 2) {
                return false;
            }
            ends[count++] = &edge;
        }
    }
    if (count != 2 || ends[0]->faces != ends[1]->faces) {
        return false;
    }
    std::uint32_t seen = 0; // faces of sheets from one edge to the other
    for (const StarFace& face : star.faces) {
        if (face.x == ends[0]->vertex || face.x == ends[1]->vertex) {
            const auto [size, end] = follow(star, face);
            if (size == 0 || end->vertex == face.x) {
                return false;
            }
            seen += size;
        }
    }
    return seen == star.size();
}

} // namespace

Stratum classify(InterfaceStar& interface_star) {
    auto& edges = interface_star.edges;
    edges.clear();
    for (std::uint32_t i = 0; i < interface_star.size(); ++i) {
        const StarFace& face = interface_star.faces[i];
        for (const bool is_x : {true, false}) {
            const std::uint32_t vertex = is_x ? face.x : face.y;
            auto edge = std::find_if(edges.begin(), edges.end(),
                                     [&](const StarEdge& one) { return one.vertex == vertex; });
            if (edge == edges.end()) {
                edges.push_back({vertex, 0, no_id, no_id});
                edge = edges.end() - 1;
            }
            ++edge->faces;
            (is_x ? edge->as_x : edge->as_y) = i;
        }
    }
    for (StarEdge& edge : edges) {
        edge.is_domain_edge =
            std::find(interface_star.domain_edges.begin(), interface_star.domain_edges.end(),
                      edge.vertex) != interface_star.domain_edges.end();
    }
    const bool has_curve = std::any_of(edges.begin(), edges.end(),
                                       [](const StarEdge& edge) { return edge.is_on_curve(); });
    return interface_star.faces.empty()             ? Stratum::none
           : !has_curve && is_sheet(interface_star) ? Stratum::sheet
           : has_curve && is_curve(interface_star)  ? Stratum::curve
                                                    : Stratum::point;
}

StrataCounts count_strata(const Complex& complex) {
    StrataCounts counts;
    Star star;
    InterfaceStar interface_star;
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        if (!complex.is_alive(Vertex{v}) || !complex.is_interface(Vertex{v})) {
            continue;
        }
        gather(complex, v, star);
        gather(complex, star, interface_star);
        const Stratum stratum = classify(interface_star);
        ++(stratum == Stratum::sheet   ? counts.sheet
           : stratum == Stratum::curve ? counts.curve
                                       : counts.point);
    }
    return counts;
}

SheetNormal normal_at(const Complex& complex, const InterfaceStar& interface_star,
                      const StarEdge& edge) {
    if (is_sheet(interface_star)) {
        return {normal(complex, interface_star), true};
    }
    const Point& centre = complex.at(interface_star.centre);
    Point sum = Point::Zero();
    const auto add = [&](const StarFace& face) {
        const Point a = complex.at(face.x) - centre;
        const Point b = complex.at(face.y) - centre;
        sum += a.cross(b) / (a.squaredNorm() * b.squaredNorm());
    };
    for (const bool forward : {true, false}) {
        const std::uint32_t first = forward ? edge.as_x : edge.as_y;
        for (std::uint32_t i = first; i != no_id;) {
            const StarFace& face = interface_star.faces[i];
            add(face);
            const StarEdge& next = *interface_star.edge_to(forward ? face.y : face.x);
            if (next.is_on_curve()) {
                break;
            }
            i = forward ? next.as_x : next.as_y;
            if (i == first) {
                return {unit(sum), true};
            }
        }
    }
    return {unit(sum), false};
}

namespace {

// Normal equations of a least squares problem. Eigen's solver of this size would fuse
// multiplications with additions, which other machines do not.
struct Equations {
    static constexpr std::size_t n = 5;
    using Row = std::array<Real, n>;
    std::array<Row, n> matrix{};
    Row right{};

    void add(const Row& row, Real value) {
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j <= i; ++j) {
                matrix[i][j] += row[i] * row[j];
            }
            right[i] += row[i] * value;
        }
    }
    // By Cholesky's method; an unknown that the others leave undetermined is 0.
    [[nodiscard]] Row solve() {
        constexpr Real undetermined = 1e-10;
        for (std::size_t j = 0; j < n; ++j) {
            Real pivot = matrix[j][j];
            for (std::size_t k = 0; k < j; ++k) {
                pivot -= matrix[j][k] * matrix[j][k];
            }
            const bool is_determined = pivot > undetermined * matrix[j][j];
            matrix[j][j] = is_determined ? std::sqrt(pivot) : 0;
            for (std::size_t i = j + 1; i < n; ++i) {
                Real sum = matrix[i][j];
                for (std::size_t k = 0; k < j; ++k) {
                    sum -= matrix[i][k] * matrix[j][k];
                }
                matrix[i][j] = is_determined ? sum / matrix[j][j] : 0;
            }
        }
        Row x = right;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                x[i] -= matrix[i][k] * x[k];
            }
            x[i] = matrix[i][i] > 0 ? x[i] / matrix[i][i] : 0;
        }
        for (std::size_t i = n; i-- > 0;) {
            for (std::size_t k = i + 1; k < n; ++k) {
                x[i] -= matrix[k][i] * x[k];
            }
            x[i] = matrix[i][i] > 0 ? x[i] / matrix[i][i] : 0;
        }
        return x;
    }
};

} // namespace

Point normal(const Complex& complex, const InterfaceStar& interface_star) {
    const Point& centre = complex.at(interface_star.centre);
    Point sum = Point::Zero();
    for (const StarFace& face : interface_star.faces) {
        const Point a = complex.at(face.x) - centre;
        const Point b = complex.at(face.y) - centre;
        sum += a.cross(b) / (a.squaredNorm() * b.squaredNorm());
    }
    const Point up = unit(sum); // exact on spheres (N. Max, "Weights for computing vertex normals")
    const Point first = complex.at(interface_star.faces[0].x) - centre;
    const Real size = first.norm(); // the unit of lengths below
    const Point x_axis = unit(first - first.dot(up) * up);
    const Point y_axis = up.cross(x_axis);
    // height = slope . (x, y) + (x^2 + y^2 + height^2) / diameter + saddle, by least squares; the
    // weight of a neighbour is the inverse square of its distance.
    Equations equations;
    for (const StarFace& face : interface_star.faces) {
        const Point d = complex.at(face.x) - centre;
        const Real length = d.norm();
        const Real x = d.dot(x_axis) / length;
        const Real y = d.dot(y_axis) / length;
        const Real l = length / size;
        equations.add({x, y, l, (x * x - y * y) * l, x * y * l}, d.dot(up) / length);
    }
    equations.matrix[3][3] += 2e-3 * equations.matrix[2][2]; // neighbours may be few
    equations.matrix[4][4] += 2e-3 * equations.matrix[2][2];
    const auto slopes = equations.solve();
    return unit(up - slopes[0] * x_axis - slopes[1] * y_axis);
}

} // namespace dsc3
