// SPDX-License-Identifier: MIT
#include "dsc3/initial/surfaces.h"

#include "dsc3/geometry/tet.h"
#include "dsc3/queries/interface_star.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsc3::initial {

namespace {

// A vertex that is nearer, in edge lengths, is on a surface.
constexpr Real on_surface = 1e-3;
// Alternating projections onto several surfaces converge fast where these cross at a large angle.
constexpr int rounds_of_several = 30;

} // namespace

Phase phase_inside(const Shape& shape, Phase phase) {
    if (shape.divides.empty()) {
        return shape.phase;
    }
    const auto change = std::find_if(shape.divides.begin(), shape.divides.end(),
                                     [&](const PhaseChange& each) { return each.from == phase; });
    return change == shape.divides.end() ? phase : change->to;
}

Real Surfaces::distance(const Point& p) const {
    Real nearest = std::numeric_limits<Real>::infinity();
    Phase phase = exterior_phase;
    for (const Shape& shape : shapes_) {
        const Phase inside = phase_inside(shape, phase);
        if (inside == phase && !shape.divides.empty()) {
            continue; // the surfaces around the phases that it divides are nearer
        }
        const Real to_shape = shape.distance(p);
        nearest = std::min(nearest, std::abs(to_shape));
        phase = to_shape < 0 ? inside : phase;
    }
    return nearest;
}

bool Surfaces::is_on(const Shape& shape, std::uint32_t vertex) const {
    return std::abs(shape.distance(complex_.at(vertex))) < on_surface * edge_length_;
}

bool Surfaces::is_on(const ShapeList& surfaces, const Point& p) const {
    return std::all_of(surfaces.begin(), surfaces.end(), [&](const Shape* shape) {
        return std::abs(shape->distance(p)) < on_surface * edge_length_;
    });
}

ShapeList Surfaces::at(std::uint32_t vertex) const {
    return complex_.is_interface(Vertex{vertex}) ? between(vertex, vertex) : ShapeList();
}

ShapeList Surfaces::between(std::uint32_t a, std::uint32_t b) const {
    ShapeList surfaces;
    for (const Shape& shape : shapes_) {
        if (is_on(shape, a) && is_on(shape, b)) {
            surfaces.push_back(&shape);
        }
    }
    return surfaces;
}

// By Newton's method.
Point Surfaces::project(const Distance& distance, Point p, std::uint32_t fixed) const {
    const Real e = 1e-5 * edge_length_;
    for (int i = 0; i < 4; ++i) {
        Point gradient;
        for (int k = 0; k < 3; ++k) {
            Point to = p;
            to[k] += e;
            Point from = p;
            from[k] -= e;
            gradient[k] = (distance(to) - distance(from)) / (2 * e);
        }
        keep_on_sides(gradient, Point::Zero(), fixed);
        const Real square = gradient.squaredNorm();
        if (!(square > 1e-6)) {
            break;
        }
        p -= distance(p) / square * gradient;
    }
    return p;
}

Point Surfaces::project(const ShapeList& surfaces, Point p, std::uint32_t fixed) const {
    for (int round = 0; round < (surfaces.size() > 1 ? rounds_of_several : 1); ++round) {
        for (const Shape* shape : surfaces) {
            p = project(shape->distance, p, fixed);
        }
    }
    return p;
}

Point Surfaces::place_between(Workspace& work, std::uint32_t a, std::uint32_t b) const {
    const Point middle = midpoint(complex_.at(a), complex_.at(b));
    const std::uint32_t fixed = complex_.fixed_along(a, b);
    ShapeList surfaces = between(a, b);
    if (surfaces.size() < 2) {
        return surfaces.empty() ? project_nearest(middle, fixed) : project(surfaces, middle, fixed);
    }
    gather(complex_, a, work.star);
    gather(complex_, work.star, work.interface_star);
    classify(work.interface_star);
    const StarEdge* const edge = work.interface_star.edge_to(b);
    if (edge == nullptr || !edge->is_on_curve()) { // a chord between two vertices of curves
        surfaces = {*std::min_element(
            surfaces.begin(), surfaces.end(), [&](const Shape* x, const Shape* y) {
                return std::abs(x->distance(middle)) < std::abs(y->distance(middle));
            })};
    }
    return project(surfaces, middle, fixed);
}

Point Surfaces::project_nearest(const Point& p, std::uint32_t fixed) const {
    const auto nearest =
        std::min_element(shapes_.begin(), shapes_.end(), [&](const Shape& x, const Shape& y) {
            return std::abs(x.distance(p)) < std::abs(y.distance(p));
        });
    if (nearest == shapes_.end()) {
        return p;
    }
    const Point to = project(nearest->distance, p, fixed);
    return (to - p).norm() < 0.5 * edge_length_ ? to : p;
}

} // namespace dsc3::initial
