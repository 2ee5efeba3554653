// SPDX-License-Identifier: MIT
// Initial shapes, as signed distances.
#pragma once

#include "dsc3/initial/initial_complex.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace dsc3 {

/// A box with sides parallel to the axes. The first complex has no feature lines, so it rounds
/// sharp edges, here and in all other shapes, over an edge length.
[[nodiscard]] Distance box(const Box& box);

/// An ellipsoid with axes parallel to the coordinate axes. The distance is exact to first order
/// near the surface.
[[nodiscard]] Distance ellipsoid(const Point& centre, const Point& radii);

/// A torus: a tube around a circle. Throws InputError for an axis of no length.
[[nodiscard]] Distance torus(const Point& centre, const Point& axis, Real circle_radius,
                             Real tube_radius);

/// Voronoi cells, which fill the domain: points nearest to site i have phase i. Each cell divides
/// the cells before it, so its distance takes O(sites). Throws InputError if a site is not finite
/// or two are equal.
[[nodiscard]] std::vector<Shape> voronoi_cells(std::span<const Point> sites);

/// A surface of triangles.
struct TriangleSurface {
    std::vector<Point> points;
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices into `points`
    std::string name = "surface";                        ///< used in error messages
};

/// Figures of a closed surface, to compare with a first complex: there, parts thinner than two
/// edge lengths or so are lost, break, or merge.
struct SurfaceFigures {
    Real volume = 0;                       ///< without hollows
    std::int64_t euler_characteristic = 0; ///< of the surface: 2 for each ball, 0 for a torus
};

/// The signed distance to a closed surface, which may have several parts; a part inside an odd
/// number of others is a hollow. Triangles may be oriented either way, but each part must be
/// orientable. A query is O(log n) on average. (J. A. Baerentzen and H. Aanaes, "Signed distance
/// computation using the angle weighted pseudonormal", 2005.)
///
/// \throw InputError, with the place, if an edge does not have two triangles, two triangles cross
/// each other, a coordinate is not finite, a part cannot be oriented, or no volume is enclosed.
/// O(n log n), and O(n) more for each part.
[[nodiscard]] Distance closed_surface(TriangleSurface surface, SurfaceFigures* figures = nullptr);

} // namespace dsc3
