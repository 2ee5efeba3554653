// SPDX-License-Identifier: MIT
#include "dsc/initial/improve/refinement.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/ranges.h"
#include "dsc/geometry/triangle.h"
#include "dsc/initial/rounding.h"
#include "dsc/operations/edge_split.h"
#include "dsc/queries/phases.h"

#include <algorithm>

namespace dsc::initial {

namespace {

// A triangle across a film is a needle below this smallest angle, in degrees. Edges of half the
// length nearly double it.
constexpr double needle_angle = 8;
constexpr double sharpest_tip = 5;    // no edge length helps at a sharper one; in degrees
constexpr double halved_above = 0.6;  // length of an edge that is halved, over the target
constexpr double refine_below = 0.5;  // quality of a triangle that is broken up
constexpr double split_above = 1.5;   // length of an inner edge that is split, over the target
constexpr double split_quality = 0.4; // smallest quality that a split may leave for smoothing

// The corner opposite to a constrained edge of the triangle whose protection the point lies in;
// no_id if there is none.
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

// The same for the triangle and its neighbours, which an insertion is certain to change.
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

template <class Real>
double quality_of(const Complex<Real>& complex, std::uint32_t triangle) {
    const auto& v = complex.triangles[triangle].v;
    return quality<double>(position_of(complex, v[0]), position_of(complex, v[1]),
                           position_of(complex, v[2]));
}

// The smallest angle of the triangle of a corner, in degrees.
template <class Real>
double smallest_angle(const Complex<Real>& complex, Corner corner) {
    const auto& v = complex.triangles[triangle_of(corner)].v;
    return min_angle_deg<double>(position_of(complex, v[0]), position_of(complex, v[1]),
                                 position_of(complex, v[2]));
}

// Whether a film ends beyond the edge opposite to the corner, in an edge or in a tip.
template <class Real>
bool film_ends_beyond(const Complex<Real>& complex, Corner corner) {
    if (is_constrained(complex, corner)) {
        return true;
    }
    const Corner tip = complex.twin(corner);
    return is_constrained(complex, next(tip)) && is_constrained(complex, prev(tip)) &&
           smallest_angle(complex, tip) >= sharpest_tip;
}

// Whether the triangle is the last one of a film, and a needle with its point at the corner.
template <class Real>
bool is_needle(const Complex<Real>& complex, Corner corner) {
    const auto& v = complex.triangles[triangle_of(corner)].v;
    return is_constrained(complex, next(corner)) != is_constrained(complex, prev(corner)) &&
           smallest_angle(complex, corner) < needle_angle && film_ends_beyond(complex, corner) &&
           std::ranges::all_of(v,
                               [&](std::uint32_t i) { return is_interface(complex, Vertex{i}); });
}

template <class Real>
void push_poor(const Complex<Real>& complex, std::uint32_t vertex,
               std::vector<std::uint32_t>& queue) {
    for (const Triangle t : star_triangles(complex, Vertex{vertex})) {
        if (quality_of(complex, t.id) < refine_below) {
            queue.push_back(t.id);
        }
    }
}

// Splits the edge at its midpoint if that is allowed; returns whether it was.
template <class Real>
bool split(Complex<Real>& complex, Corner corner, std::vector<Corner>& stack) {
    const Point<double> a = position_of(complex, complex.vertex(corner));
    const Point<double> b = position_of(complex, complex.vertex(next(corner)));
    const Point<double> w = position_of(complex, complex.vertex(prev(corner)));
    const Point<double> d = position_of(complex, complex.vertex(complex.twin(corner)));
    const Point<Real> point = narrowed<Real>(midpoint<double>(b, w));
    const Point<double> m = point.template cast<double>();
    const double worst = std::min(std::min(quality<double>(a, b, m), quality<double>(a, m, w)),
                                  std::min(quality<double>(d, w, m), quality<double>(d, m, b)));
    if (worst < split_quality ||
        edge_split_guard<Real>(complex, Region{}, corner, point) != Verdict::legal) {
        return false;
    }
    insert_point(complex, {WalkEnd::Kind::edge, corner}, point, stack);
    return true;
}

} // namespace

template <class Real>
BreakUp break_up(Complex<Real>& complex, std::uint32_t triangle, Protection protection,
                 std::vector<Corner>& stack) {
    const auto& v = complex.triangles[triangle].v;
    const Point<double> centre = circumcentre<double>(
        position_of(complex, v[0]), position_of(complex, v[1]), position_of(complex, v[2]));
    if (!centre.allFinite()) {
        return {};
    }
    const Point<Real> point = narrowed<Real>(centre);
    const WalkEnd place = locate(complex, triangle, point);
    if (place.kind == WalkEnd::Kind::stopped) {
        return {no_id, place.corner};
    }
    if (place.kind == WalkEnd::Kind::vertex) {
        return {};
    }
    const Corner encroached =
        encroached_edge_near(complex, triangle_of(place.corner), centre, protection);
    if (encroached != no_id) {
        return {no_id, encroached};
    }
    return {insert_point(complex, place, point, stack), no_id};
}

template <class Real>
std::size_t refine(Complex<Real>& complex, std::span<const std::uint32_t> zone,
                   Protection protection) {
    std::vector<std::uint32_t> queue;
    std::vector<Corner> stack;
    for (const std::uint32_t v : zone) {
        if (complex.is_alive(Vertex{v})) {
            push_poor(complex, v, queue);
        }
    }
    // New edges are never shorter than old ones. This bounds their number, but not tightly.
    const std::size_t max_inserted = 64 * zone.size() + 1024;
    std::size_t inserted = 0;
    for (std::size_t i = 0; i < queue.size() && inserted < max_inserted; ++i) {
        const std::uint32_t t = queue[i];
        if (!complex.is_alive(Triangle{t}) || quality_of(complex, t) >= refine_below) {
            continue;
        }
        const std::uint32_t v = break_up(complex, t, protection, stack).vertex;
        if (v != no_id) {
            push_poor(complex, v, queue);
            ++inserted;
        }
    }
    return inserted;
}

template <class Real>
std::size_t split_long(Complex<Real>& complex, std::span<const std::uint32_t> zone,
                       double edge_length) {
    std::size_t inserted = 0;
    std::vector<Corner> stack;
    for (const std::uint32_t v : zone) {
        if (!complex.is_alive(Vertex{v})) {
            continue;
        }
        Corner longest = no_id;
        double length = split_above * edge_length;
        for_each_corner(complex, Vertex{v}, [&](Corner c) {
            // The incident edge at the counter-clockwise side of the triangle, opposite to its next
            // corner.
            const double candidate =
                (position_of(complex, complex.vertex(prev(c))) - position_of(complex, v)).norm();
            if (candidate > length && !is_constrained(complex, next(c))) {
                longest = next(c);
                length = candidate;
            }
        });
        if (longest != no_id && split(complex, longest, stack)) {
            ++inserted;
        }
    }
    return inserted;
}

template <class Real>
std::size_t halve_needles(Complex<Real>& complex, std::span<const std::uint32_t> interface_vertices,
                          double edge_length) {
    std::vector<std::array<std::uint32_t, 2>> found;
    for (const std::uint32_t v : interface_vertices) {
        for_each_corner(complex, Vertex{v}, [&](Corner c) {
            if (!is_needle(complex, c)) {
                return;
            }
            const bool is_next = is_constrained(complex, prev(c));
            const std::uint32_t w = complex.vertex(is_next ? next(c) : prev(c));
            const Corner beyond = complex.twin(is_next ? prev(c) : next(c));
            if (!is_border(beyond) && !is_interface(complex, Vertex{complex.vertex(beyond)}) &&
                distance(position_of(complex, v), position_of(complex, w)) >
                    halved_above * edge_length) {
                found.push_back({v, w});
            }
        });
    }
    std::size_t halved = 0;
    std::vector<Corner> stack;
    for (const auto& [v, w] : found) {
        const Corner edge = complex.find_half_edge(Vertex{v}, Vertex{w});
        const Point<Real> middle =
            narrowed<Real>(midpoint<double>(position_of(complex, v), position_of(complex, w)));
        if (edge != no_id && // not halved from its other end yet
            edge_split_guard<Real>(complex, Region{}, edge, middle) == Verdict::legal) {
            insert_point(complex, {WalkEnd::Kind::edge, edge}, middle, stack);
            ++halved;
        }
    }
    return halved;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::size_t halve_needles(Complex<Real>&, std::span<const std::uint32_t>, double);    \
    template BreakUp break_up(Complex<Real>&, std::uint32_t, Protection, std::vector<Corner>&);    \
    template std::size_t refine(Complex<Real>&, std::span<const std::uint32_t>, Protection);       \
    template std::size_t split_long(Complex<Real>&, std::span<const std::uint32_t>, double);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc::initial
