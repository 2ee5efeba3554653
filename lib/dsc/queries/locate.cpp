// SPDX-License-Identifier: MIT
#include "dsc/queries/locate.h"

#include "dsc/base/error.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/ranges.h"
#include "dsc/complex/walk.h"

namespace dsc {

namespace {

template <class Real>
Location found(const Complex<Real>& complex, const WalkEnd& end) {
    const Triangle triangle{triangle_of(end.corner)};
    switch (end.kind) {
    case WalkEnd::Kind::triangle: return {Location::Kind::triangle, triangle, {}, {}};
    case WalkEnd::Kind::edge: return {Location::Kind::edge, triangle, complex.edge(end.corner), {}};
    case WalkEnd::Kind::vertex:
        return {Location::Kind::vertex, triangle, {}, Vertex{complex.vertex(end.corner)}};
    case WalkEnd::Kind::stopped:
    case WalkEnd::Kind::lost: break;
    }
    return {};
}

// Whether the boundary that the edge opposite to `c` belongs to is convex, and all the boundary
// that there is: then nothing of the complex lies beyond the edge. O(length of this boundary).
//
// Euler's formula for V vertices, T triangles, B boundary edges, C components and L boundary loops
// is 2 V - T = B + 4 C - 2 L. If 2 V - T is the number of edges of one loop plus 2, the L - 1 other
// loops have 2 - 4 C + 2 L edges, and at least three each: only C = L = 1 allows that. Vertices
// without triangles raise V, and leave them even fewer.
template <class Real>
bool is_around_all(const Complex<Real>& complex, Corner c) {
    const Corner first = c;
    std::int64_t edges = 0;
    do {
        const Corner following =
            next_along(complex, c, [&](Corner at) { return is_border(complex.twin(at)); });
        if (orientation<Real>(complex.position(Vertex{complex.vertex(next(c))}),
                              complex.position(Vertex{complex.vertex(prev(c))}),
                              complex.position(Vertex{complex.vertex(prev(following))})) < 0) {
            return false;
        }
        c = following;
        ++edges;
    } while (c != first);
    return 2 * std::int64_t{complex.vertex_count()} - complex.triangle_count() == edges + 2;
}

// Tests one triangle; `stopped` if the point is outside.
template <class Real>
WalkEnd look_into(const Complex<Real>& complex, Triangle t, const Point<Real>& point) {
    return walk(complex, t, point, 1, [](Corner) { return false; });
}

} // namespace

template <class Real>
Location locate(const Complex<Real>& complex, const Point<Real>& point, Triangle hint) {
    if (!point.allFinite()) {
        throw InputError({.what = "a coordinate is not finite",
                          .where = "locate",
                          .value = to_text(point),
                          .allowed = "finite coordinates"});
    }
    const auto all = triangles(complex);
    if (all.empty()) {
        return {};
    }
    // A walk that visits each triangle once costs no more than testing them all.
    const WalkEnd end =
        walk(complex, complex.is_alive(hint) ? hint : *all.begin(), point, complex.triangle_count(),
             [&](Corner c) { return !is_border(complex.twin(c)); });
    if (const Location location = found(complex, end); location.kind != Location::Kind::outside) {
        return location;
    }
    if (end.kind == WalkEnd::Kind::stopped && is_around_all(complex, end.corner)) {
        return {};
    }
    for (const Triangle t : all) {
        const Location location = found(complex, look_into(complex, t, point));
        if (location.kind != Location::Kind::outside) {
            return location;
        }
    }
    return {};
}

template Location locate(const Complex<double>&, const Point<double>&, Triangle);
template Location locate(const Complex<float>&, const Point<float>&, Triangle);

} // namespace dsc
