// SPDX-License-Identifier: MIT
// Measures of points, triangles and tets.
#pragma once

#include "dsc3/base/types.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc3 {

/// Six times the signed volume of (a, b, c, d): positive where (b, c, d) turns clockwise as seen
/// from a.
[[nodiscard]] inline Real determinant(const Point& a, const Point& b, const Point& c,
                                      const Point& d) {
    return (b - a).cross(c - a).dot(d - a);
}

/// The signed volume.
[[nodiscard]] inline Real volume(const Point& a, const Point& b, const Point& c, const Point& d) {
    return determinant(a, b, c, d) / 6;
}

/// The squared distance between two points.
[[nodiscard]] inline Real squared_distance(const Point& a, const Point& b) {
    return (b - a).squaredNorm();
}

/// The middle of a and b.
[[nodiscard]] inline Point midpoint(const Point& a, const Point& b) { return 0.5 * (a + b); }

/// The vector in the same direction of length 1; 0 for 0.
[[nodiscard]] inline Point unit(const Point& a) {
    const Real length = a.norm();
    return length > 0 ? Point(a / length) : a;
}

/// Makes the quality of a regular tet 1: sqrt(2) * 6^1.5.
inline constexpr Real quality_scale = 20.784609690826528;

/// The quality of a tet: its volume over the cube of the root mean square of its edges, 1 for a
/// regular one, negative for an inverted one. V. N. Parthasarathy et al., "A comparison of
/// tetrahedron quality measures" (1994).
///
/// Above `quality_floor` the tet is certainly not inverted, although nothing here is exact: the
/// rounding error of the determinant, a few units of 1e-16 of a product of three differences of
/// coordinates (J. R. Shewchuk 1997), is relative to the same lengths.
[[nodiscard]] inline Real quality(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Point u = b - a;
    const Point v = c - a;
    const Point w = d - a;
    const Real squares = u.squaredNorm() + v.squaredNorm() + w.squaredNorm() +
                         (c - b).squaredNorm() + (d - b).squaredNorm() + (d - c).squaredNorm();
    return quality_scale * u.cross(v).dot(w) / (squares * std::sqrt(squares));
}

/// Certifies the orientation of a tet; see `quality`.
inline constexpr Real quality_floor = 1e-10;

/// The angle at a of the triangle (a, b, c), in degrees.
[[nodiscard]] inline Real angle_degrees(const Point& a, const Point& b, const Point& c) {
    const Point u = b - a;
    const Point v = c - a;
    return std::atan2(u.cross(v).norm(), u.dot(v)) * (180 / std::numbers::pi);
}

/// The smallest angle of a triangle, in degrees.
[[nodiscard]] inline Real min_angle_degrees(const Point& a, const Point& b, const Point& c) {
    return std::min({angle_degrees(a, b, c), angle_degrees(b, c, a), angle_degrees(c, a, b)});
}

/// The smallest and the largest of the six dihedral angles, in degrees.
struct DihedralAngles {
    Real smallest = 180; ///< in degrees
    Real largest = 0;    ///< in degrees
};

/// Of one tet.
[[nodiscard]] inline DihedralAngles dihedral_angles(const std::array<Point, 4>& p) {
    DihedralAngles angles;
    for (std::uint32_t i = 0; i < 4; ++i) {
        for (std::uint32_t j = i + 1; j < 4; ++j) {
            const std::uint32_t k = j == i + 1 ? (j + 1) % 4 : i + 1;
            const std::uint32_t l = 6 - i - j - k;
            const Point axis = p[j] - p[i];
            const Point m = axis.cross(p[k] - p[i]);
            const Point n = axis.cross(p[l] - p[i]);
            const Real angle = std::atan2(m.cross(n).norm(), m.dot(n)) * (180 / std::numbers::pi);
            angles.smallest = std::min(angles.smallest, angle);
            angles.largest = std::max(angles.largest, angle);
        }
    }
    return angles;
}

} // namespace dsc3
