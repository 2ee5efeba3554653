// SPDX-License-Identifier: MIT
// Shapes to begin with, by their distances.
#pragma once

#include "dsc3/initial/initial_complex.h"

#include <array>
#include <string>
#include <vector>

namespace dsc3 {

/// A box with sides parallel to the axes. The first complex rounds its edges over an edge length,
/// since it has no feature lines; so do all functions here for shapes with edges.
[[nodiscard]] Distance box(const Box& box);

/// An ellipsoid with axes parallel to those of space. The distance is exact to first order near the
/// surface.
[[nodiscard]] Distance ellipsoid(const Point& centre, const Point& radii);

/// A torus: a tube around a circle. Throws InputError for an axis of no length.
[[nodiscard]] Distance torus(const Point& centre, const Point& axis, Real circle_radius,
                             Real tube_radius);

/// A surface of triangles.
struct TriangleSurface {
    std::vector<Point> points;
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices into `points`
    std::string name = "surface";                        ///< what errors call it
};

/// The signed distance to a closed surface, which may have several parts; triangles may be oriented
/// either way as long as each part can be oriented. A query is O(log n) in the mean. (J. A.
/// Baerentzen and H. Aanaes, "Signed distance computation using the angle weighted pseudonormal",
/// 2005.)
///
/// \throw InputError, with the place, where an edge has not two triangles, two triangles cross each
/// other, a coordinate is not finite, a part cannot be oriented, or nothing is enclosed. O(n log
/// n).
[[nodiscard]] Distance closed_surface(TriangleSurface surface);

} // namespace dsc3
