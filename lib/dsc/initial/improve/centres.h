// SPDX-License-Identifier: MIT
// New vertices at the centres of the circles about triangles (L. P. Chew, "Guaranteed-quality mesh
// generation for curved surfaces", 1993), kept off the pieces of the interface and the sides of the
// domain.
#pragma once

#include "dsc/geometry/triangle.h"
#include "dsc/initial/build/insertion.h"
#include "dsc/initial/rounding.h"

#include <cmath>
#include <vector>

namespace dsc::initial {

/// What no new vertex may enter, about a piece of the interface or of a side of the domain.
enum class Protection : std::uint8_t {
    circle, ///< the smallest circle: the piece is seen at an angle of at most 90 degrees
    /// The part of it where the piece is seen at more than 120 degrees, so that triangles may have
    /// angles of 30 at its ends. Where curves meet, short pieces next to long ones need that.
    lens,
};

template <class Real>
Point<double> position_of(const Complex<Real>& complex, std::uint32_t vertex) {
    return complex.position(Vertex{vertex}).template cast<double>();
}

/// The edge opposite to the corner is a piece of the interface or of a side.
template <class Real>
bool is_constrained(const Complex<Real>& complex, Corner corner) {
    return complex.phase_at(corner) != complex.phase_at(complex.twin(corner));
}

/// The corner opposite to a constrained edge of the triangle whose protection the point lies in;
/// no_id if there is none.
template <class Real>
Corner encroached_edge(const Complex<Real>& complex, std::uint32_t triangle,
                       const Point<double>& point, Protection protection) {
    constexpr double cosine_of_lens = -0.5; // of the angle at which a piece is seen from its rim
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Corner c = corner_of(triangle, i);
        if (!is_constrained(complex, c)) {
            continue;
        }
        const Point<double> p = position_of(complex, complex.vertex(next(c))) - point;
        const Point<double> q = position_of(complex, complex.vertex(prev(c))) - point;
        const double dot = p.dot(q);
        if (dot < 0 &&
            (protection == Protection::circle || dot < cosine_of_lens * p.norm() * q.norm())) {
            return c;
        }
    }
    return no_id;
}

/// The same for the triangle and its neighbours, which an insertion is certain to change.
template <class Real>
Corner encroached_edge_near(const Complex<Real>& complex, std::uint32_t triangle,
                            const Point<double>& point, Protection protection) {
    Corner found = encroached_edge(complex, triangle, point, protection);
    for (const Corner c : complex.triangles[triangle].n) {
        if (found == no_id && !is_border(c)) {
            found = encroached_edge(complex, triangle_of(c), point, protection);
        }
    }
    return found;
}

/// What came of breaking up a triangle.
struct BreakUp {
    std::uint32_t vertex = no_id; ///< the new vertex, or none
    Corner in_the_way = no_id; ///< opposite to the constrained edge that prevented it, if one did
};

/// Inserts the centre of the circle about a triangle, unless it lies beyond a constrained edge or
/// too near to one.
template <class Real>
BreakUp break_up(Complex<Real>& complex, std::uint32_t triangle, Protection protection,
                 std::vector<Corner>& stack) {
    const auto& v = complex.triangles[triangle].v;
    const Point<double> centre = circumcentre<double>(
        position_of(complex, v[0]), position_of(complex, v[1]), position_of(complex, v[2]));
    if (!std::isfinite(centre.x()) || !std::isfinite(centre.y())) {
        return {};
    }
    const Point<Real> point = narrowed<Real>(centre);
    const Location location = locate(complex, triangle, point);
    if (location.place == Place::beyond) {
        return {no_id, location.corner};
    }
    if (location.place == Place::vertex) {
        return {};
    }
    const Corner encroached =
        encroached_edge_near(complex, triangle_of(location.corner), centre, protection);
    if (encroached != no_id) {
        return {no_id, encroached};
    }
    return {insert_point(complex, location, point, stack), no_id};
}

} // namespace dsc::initial
