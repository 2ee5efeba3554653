// SPDX-License-Identifier: MIT
#include "dsc/queries/locate.h"

#include "dsc/base/error.h"
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

// Tests one triangle; `stopped` if the point is outside.
template <class Real>
WalkEnd locate_in(const Complex<Real>& complex, Triangle t, const Point<Real>& point) {
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
    for (const Triangle t : all) {
        const Location location = found(complex, locate_in(complex, t, point));
        if (location.kind != Location::Kind::outside) {
            return location;
        }
    }
    return {};
}

template Location locate(const Complex<double>&, const Point<double>&, Triangle);
template Location locate(const Complex<float>&, const Point<float>&, Triangle);

} // namespace dsc
