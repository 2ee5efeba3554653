// SPDX-License-Identifier: MIT
// A ray across a film: from the middle of an interface edge, straight into the phase on its left,
// from triangle to triangle, to where that phase ends.
#pragma once

#include "dsc/geometry/points.h"
#include "topology/region.h"

namespace dsc {

/// The end of a ray, where it meets the interface again.
template <class Real>
struct FilmRay {
    Corner opposite = no_id; ///< half-edge there, with the film on its left; no_id: none
    Corner boundary = no_id; ///< the same, if the ray ends on the domain boundary
    Real thickness = 0;      ///< length of the ray
    Point<Real> middle;      ///< halfway
};

/// Follows the ray of the half-edge `sheet` and calls `visit(triangle, from, to)` for each triangle
/// on its way, with the distances at which it enters and leaves. Returns an empty result if the
/// film is not thinner than `longest`. O(longest / length of the edges).
template <class Real, class Visit>
[[nodiscard]] FilmRay<Real> cross_film(const Complex<Real>& complex, Corner sheet, Real longest,
                                       Visit visit) {
    constexpr int max_triangles = 1024; // so that rounding cannot make the ray go in circles
    const Point<Real> along = direction(complex, sheet);
    const Point<Real> start =
        complex.position(Vertex{complex.vertex(next(sheet))}) + along / Real(2);
    const Real length = std::sqrt(along.x() * along.x() + along.y() * along.y());
    const Point<Real> way(-along.y() / length, along.x() / length);
    // Written out, because Eigen would load the point as one vector right after storing its two
    // coordinates, which stalls.
    const auto to_vertex = [&](Corner c) {
        const VertexRecord<Real>& v = complex.vertices[complex.vertex(c)];
        return Point<Real>(v.x - start.x(), v.y - start.y());
    };
    Corner entered = sheet;
    Real from = 0;
    for (int i = 0; i < max_triangles; ++i) {
        // The ray leaves the triangle by the edge opposite to one end of the edge by which it
        // entered.
        const Corner out = cross<Real>(way, to_vertex(entered)) > 0 ? next(entered) : prev(entered);
        const Point<Real> edge = direction(complex, out);
        const Real to = cross<Real>(to_vertex(next(out)), edge) / cross<Real>(way, edge);
        if (!(to < longest)) { // or no number
            return {};
        }
        visit(Triangle{triangle_of(out)}, from, to);
        const Corner across = complex.twin(out);
        if (is_border(across)) {
            return {no_id, out, to, start + way * (to / Real(2))};
        }
        if (complex.phase_at(across) != complex.phase_at(out)) {
            return {out, no_id, to, start + way * (to / Real(2))};
        }
        entered = across;
        from = to;
    }
    return {};
}

} // namespace dsc
