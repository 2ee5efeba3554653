// SPDX-License-Identifier: MIT
#include "dsc3/operations/smoothing.h"

#include "dsc3/geometry/tet.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsc3 {

Verdict smooth(Complex& complex, Workspace& work, Vertex vertex, int iterations) {
    VertexRecord& record = complex.vertices[vertex.id];
    if ((record.flags & vertex_interface) != 0) {
        return Verdict::on_interface;
    }
    if ((record.flags & vertex_boundary) != 0) {
        return Verdict::on_boundary;
    }
    if ((record.flags & vertex_settled) != 0) {
        return Verdict::no_gain;
    }
    record.flags |= vertex_settled;
    gather(complex, vertex.id, work.star);
    StarQuality& star = work.quality;
    star.gather(complex, work.star);
    Point best = record.position;
    const Real before = star.worst(best);
    Real quality = before;
    const Point mean = star.mean();
    if (const Real there = star.worst(mean); there > quality) {
        quality = there;
        best = mean;
    } else {
        star.worst(best);
    }
    Real step = 0.2 * star.length();
    for (int iteration = 0; iteration < iterations; ++iteration) {
        const Point gradient = star.gradient(star.worst_tet(star.size()), best);
        const Real slope = gradient.norm();
        if (!(slope > 1e-30)) {
            break;
        }
        bool is_better = false;
        for (int attempt = 0; attempt < 3 && !is_better; ++attempt) {
            const Point to = best + (step / slope) * gradient;
            const Real there = star.worst(to);
            if (there > 1.0001 * quality) {
                quality = there;
                best = to;
                is_better = true;
            } else {
                step *= 0.4;
            }
        }
        if (!is_better) {
            break;
        }
        step *= 1.3;
    }
    if (!(quality > 1.001 * before + 1e-12)) {
        return Verdict::no_gain;
    }
    record.position = best;
    note_edit(complex, work.rewiring);
    ++work.counts.smoothings;
    for (const Corner corner : work.star.corners) {
        for (const std::uint32_t v : complex.tets[tet_of(corner)].v) {
            complex.vertices[v].flags &= ~static_cast<std::uint32_t>(vertex_settled);
        }
    }
    record.flags |= vertex_settled;
    return Verdict::legal;
}

namespace {

constexpr Real interface_gain = 1.2;

// The interface at a vertex: height = form . (x^2, x y, y^2) over its tangent plane.
struct Quadric {
    Point origin;
    Point normal;
    Point x_axis = Point::Zero();
    Point y_axis = Point::Zero();
    Point form = Point::Zero();

    [[nodiscard]] static Point squares(Real x, Real y) { return {x * x, x * y, y * y}; }
    [[nodiscard]] Point at(Real x, Real y) const {
        return origin + x * x_axis + y * y_axis + form.dot(squares(x, y)) * normal;
    }
    // Coordinates along the axes.
    [[nodiscard]] Point local(const Point& p) const {
        const Point d = p - origin;
        return {d.dot(x_axis), d.dot(y_axis), d.dot(normal)};
    }
};

// By least squares.
Quadric fit(const Complex& complex, const InterfaceStar& interface_star) {
    Quadric quadric{.origin = complex.at(interface_star.centre),
                    .normal = normal(complex, interface_star)};
    const Point first = complex.at(interface_star.faces[0].x) - quadric.origin;
    quadric.x_axis = unit(first - first.dot(quadric.normal) * quadric.normal);
    quadric.y_axis = quadric.normal.cross(quadric.x_axis);
    Eigen::Matrix<Real, 3, 3> matrix = Eigen::Matrix<Real, 3, 3>::Zero();
    Point right = Point::Zero();
    Real size = 0;
    for (const StarFace& face : interface_star.faces) {
        const Point p = quadric.local(complex.at(face.x));
        const Point row = Quadric::squares(p.x(), p.y());
        matrix += row * row.transpose();
        right += p.z() * row;
        size += p.x() * p.x() + p.y() * p.y();
    }
    size /= interface_star.size();
    matrix.diagonal().array() += 1e-3 * size * size; // neighbours may lie on few lines
    quadric.form = matrix.ldlt().solve(right);
    return quadric;
}

Real distance_to_segment(const Point& p, const Point& a, const Point& b) {
    const Point edge = b - a;
    const Real along = std::clamp((p - a).dot(edge) / edge.squaredNorm(), Real(0), Real(1));
    return (p - a - along * edge).norm();
}

// The distance of p from the faces of the star, with its centre at `centre`.
Real distance_to_faces(const Complex& complex, const InterfaceStar& interface_star,
                       const Point& centre, const Point& p) {
    Real least = std::numeric_limits<Real>::infinity();
    for (const StarFace& face : interface_star.faces) {
        const Point& x = complex.at(face.x);
        const Point& y = complex.at(face.y);
        const Point plane = (x - centre).cross(y - centre);
        const Real square = plane.squaredNorm();
        const Real of_centre = (x - p).cross(y - p).dot(plane);
        const Real of_x = (y - p).cross(centre - p).dot(plane);
        const bool is_beside = of_centre >= 0 && of_x >= 0 && of_centre + of_x <= square;
        least = std::min(
            least, square > 0 && is_beside
                       ? std::abs((p - centre).dot(plane)) / std::sqrt(square)
                       : std::min({distance_to_segment(p, centre, x), distance_to_segment(p, x, y),
                                   distance_to_segment(p, y, centre)}));
    }
    return least;
}

} // namespace

Verdict smooth_along_interface(Complex& complex, Workspace& work, Vertex vertex,
                               const AlongRules& rules) {
    if (!complex.is_interface(vertex)) {
        return Verdict::on_interface;
    }
    if (complex.is_boundary(vertex)) {
        return Verdict::on_boundary;
    }
    gather(complex, vertex.id, work.star);
    gather(complex, work.star, work.interface_star);
    if (!is_sheet(work.interface_star)) {
        return Verdict::changes_topology;
    }
    StarQuality& star = work.quality;
    star.gather(complex, work.star);
    Point best = complex.position(vertex);
    const Real before = star.worst(best);
    if (before >= rules.enough) {
        return Verdict::no_gain;
    }
    const Quadric quadric = fit(complex, work.interface_star);
    const auto is_allowed = [&](Real x, Real y, const Point& to) {
        return x * x + y * y <= rules.farthest * rules.farthest &&
               distance_to_faces(complex, work.interface_star, to, quadric.origin) <=
                   rules.deviation &&
               distance_to_faces(complex, work.interface_star, quadric.origin, to) <=
                   rules.deviation;
    };
    Real quality = before;
    Real step = 0.3 * rules.farthest;
    Real x = 0;
    Real y = 0;
    for (int iteration = 0; iteration < 20 && quality < rules.enough; ++iteration) {
        const Point gradient = star.gradient(star.worst_tet(star.size()), best);
        const Real along_x = gradient.dot(quadric.x_axis);
        const Real along_y = gradient.dot(quadric.y_axis);
        const Real slope = std::hypot(along_x, along_y);
        if (!(slope > 1e-30)) {
            break;
        }
        bool is_better = false;
        for (int attempt = 0; attempt < 4 && !is_better; ++attempt) {
            const Real to_x = x + step / slope * along_x;
            const Real to_y = y + step / slope * along_y;
            const Point to = quadric.at(to_x, to_y);
            if (star.worst(to) > 1.0001 * quality && is_allowed(to_x, to_y, to)) {
                quality = star.worst(to);
                best = to;
                x = to_x;
                y = to_y;
                is_better = true;
            } else {
                step *= 0.4;
            }
        }
        if (!is_better) {
            break;
        }
        step *= 1.3;
    }
    if (!(quality > interface_gain * before + 1e-9)) {
        return Verdict::no_gain;
    }
    complex.vertices[vertex.id].position = best;
    note_edit(complex, work.rewiring);
    ++work.counts.smoothings;
    for (const Corner corner : work.star.corners) {
        work.rewiring.changed.push_back(tet_of(corner));
        for (const std::uint32_t v : complex.tets[tet_of(corner)].v) {
            complex.vertices[v].flags &= ~static_cast<std::uint32_t>(vertex_settled);
        }
    }
    return Verdict::legal;
}

} // namespace dsc3
