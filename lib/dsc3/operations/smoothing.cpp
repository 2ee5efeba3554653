// SPDX-License-Identifier: MIT
#include "dsc3/operations/smoothing.h"

#include "dsc3/geometry/tet.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsc3 {

namespace {

struct AscentRules {
    Real step;   // the first one, in units of the domain
    Real enough; // the ascent ends at this quality
    int iterations;
    int attempts; // to find a better place, of each iteration
};

// Gradient ascent of the worst quality, which is `quality`, over parameters of the centre: the
// centre is `place(parameters)`, and `slope` maps a gradient to a direction of the parameters. The
// star was evaluated last at the first place. Returns the new worst quality.
template <class Place, class Slope, class Allowed>
Real ascend(StarQuality& star, Real quality, Point& parameters, const AscentRules& rules,
            Place place, Slope slope, Allowed is_allowed) {
    Real step = rules.step;
    Point best = place(parameters);
    for (int iteration = 0; iteration < rules.iterations && quality < rules.enough; ++iteration) {
        const Point way = slope(star.gradient(star.worst_tet(), best));
        const Real length = way.norm();
        if (!(length > 0)) {
            break;
        }
        bool is_better = false;
        for (int attempt = 0; attempt < rules.attempts && !is_better; ++attempt) {
            const Point next = parameters + (step / length) * way;
            const Point to = place(next);
            const Real needed = (quality > 0 ? 1.0001 : 0.9999) * quality;
            const Real there = star.worst_above(to, needed);
            if (there > needed && is_allowed(next, to)) {
                quality = there;
                parameters = next;
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
    return quality;
}

// Lists the tets of the star as changed: all but the worst may have got worse.
void unsettle(Complex& complex, Workspace& work) {
    for (const Corner corner : work.star.corners) {
        work.rewiring.changed.push_back(tet_of(corner));
        for (const std::uint32_t v : complex.tets[tet_of(corner)].v) {
            complex.vertices[v].flags &= ~static_cast<std::uint32_t>(vertex_settled);
        }
    }
}

} // namespace

// Stars of this quality are not improved further, which saves a tenth of a step.
constexpr Real smooth_enough = 0.4;

Real raise_worst(StarQuality& star, Real quality, Point& place, int iterations,
                 std::uint32_t fixed) {
    const Point start = place;
    Point mean = star.mean();
    keep_on_sides(mean, start, fixed);
    if (star.is_above(mean, quality)) {
        quality = star.worst(mean);
        place = mean;
    }
    const AscentRules rules{.step = 0.2 * star.length(),
                            .enough = smooth_enough,
                            .iterations = iterations,
                            .attempts = 3};
    return ascend(
        star, quality, place, rules, [](const Point& p) { return p; },
        [&](Point gradient) {
            keep_on_sides(gradient, Point::Zero(), fixed);
            return gradient;
        },
        [](const Point&, const Point&) { return true; });
}

Verdict smooth(Complex& complex, Workspace& work, Vertex vertex, int iterations) {
    VertexRecord& record = complex.vertices[vertex.id];
    if ((record.flags & vertex_interface) != 0) {
        return Verdict::on_interface;
    }
    const std::uint32_t fixed = record.flags & vertex_boundary;
    if ((record.flags & vertex_settled) != 0) {
        return Verdict::no_gain;
    }
    record.flags |= vertex_settled;
    work.rewiring.stars.gather(complex, vertex.id, work.star);
    StarQuality& star = work.quality;
    star.gather(complex, work.star);
    Point best = record.position;
    const Real before = star.worst(best);
    const Real quality = raise_worst(star, before, best, iterations, fixed);
    if (!(quality > 1.001 * before + 1e-12)) {
        return Verdict::no_gain;
    }
    record.position = best;
    note_edit(complex, work.rewiring);
    ++work.counts.smoothings;
    unsettle(complex, work);
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
    const Real before = star.worst(complex.position(vertex));
    if (before >= rules.enough) {
        return Verdict::no_gain;
    }
    const Quadric quadric = fit(complex, work.interface_star);
    const auto is_allowed = [&](const Point& p, const Point& to) {
        return p.squaredNorm() <= rules.farthest * rules.farthest &&
               distance_to_faces(complex, work.interface_star, to, quadric.origin) <=
                   rules.deviation &&
               distance_to_faces(complex, work.interface_star, quadric.origin, to) <=
                   rules.deviation;
    };
    const AscentRules ascent{
        .step = 0.3 * rules.farthest, .enough = rules.enough, .iterations = 20, .attempts = 4};
    Point parameters = Point::Zero();
    const Real quality = ascend(
        star, before, parameters, ascent, [&](const Point& p) { return quadric.at(p.x(), p.y()); },
        [&](const Point& gradient) {
            return Point(gradient.dot(quadric.x_axis), gradient.dot(quadric.y_axis), 0);
        },
        is_allowed);
    if (!(quality > interface_gain * before + 1e-9)) {
        return Verdict::no_gain;
    }
    complex.vertices[vertex.id].position = quadric.at(parameters.x(), parameters.y());
    note_edit(complex, work.rewiring);
    ++work.counts.smoothings;
    unsettle(complex, work);
    return Verdict::legal;
}

} // namespace dsc3
