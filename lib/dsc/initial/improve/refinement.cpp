// SPDX-License-Identifier: MIT
#include "dsc/initial/improve/refinement.h"

#include "dsc/complex/ranges.h"
#include "dsc/operations/edge_split.h"
#include "dsc/quality/measures.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dsc::initial {

namespace {

constexpr double refine_below = 0.5;  // quality of a triangle that is broken up
constexpr double split_above = 1.5;   // length of an inner edge that is split, over the target
constexpr double split_quality = 0.4; // of the triangles that a split may leave for smoothing

template <class Real>
double quality_of(const Complex<Real>& complex, std::uint32_t triangle) {
    const auto& v = complex.triangles[triangle].v;
    return quality<double>(position_of(complex, v[0]), position_of(complex, v[1]),
                           position_of(complex, v[2]));
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
    insert_point(complex, Location{Place::edge, corner}, point, stack);
    return true;
}

} // namespace

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
    const std::size_t most = 64 * zone.size() + 1024;
    std::size_t inserted = 0;
    for (std::size_t i = 0; i < queue.size() && inserted < most; ++i) {
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
            // The spoke at the counter-clockwise side of the triangle, opposite to its next corner.
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

template std::size_t refine(Complex<double>&, std::span<const std::uint32_t>, Protection);
template std::size_t refine(Complex<float>&, std::span<const std::uint32_t>, Protection);
template std::size_t split_long(Complex<double>&, std::span<const std::uint32_t>, double);
template std::size_t split_long(Complex<float>&, std::span<const std::uint32_t>, double);

} // namespace dsc::initial
