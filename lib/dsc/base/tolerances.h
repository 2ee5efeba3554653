// SPDX-License-Identifier: MIT
// Tolerances that several parts of the library share, with the reasons for their values.
#pragma once

namespace dsc {

/// Relative slack of the Delaunay test: an edge is flipped only where the sine of the sum of its
/// opposite angles is below -slack times the size of its two terms, so that cocircular points do
/// not flip back and forth. Rounding is some 1e-15 (float: 1e-6) of that size.
template <class Real>
inline constexpr Real delaunay_slack = Real(1e-7);
/// `delaunay_slack` for float.
template <>
inline constexpr float delaunay_slack<float> = 1e-4F;

/// A move leaves each triangle an altitude of at least this share of the base that does not move...
inline constexpr double altitude_floor = 0.02;
/// ...or, if its altitude was lower than that before the move, this share of that altitude.
inline constexpr double altitude_keep = 0.5;

/// Rounding bound of a doubled area computed from differences of coordinates, relative to the sum
/// of the magnitudes of its two products: a doubled area of a larger magnitude has the right sign.
/// (3 + 16 eps) eps with eps = 2^-53 (Shewchuk 1997), and 2^-24 for float.
template <class Real>
inline constexpr Real area_bound = Real(3.3306690738754716e-16);
/// `area_bound` for float.
template <>
inline constexpr float area_bound<float> = 1.7881411e-7F;

/// The smallest target edge length of a simulation.
///
/// The squared quality divides products of six lengths. They keep full precision for triangles of
/// a quality above 1e-4 while h^6 is at least 1e8 times the smallest normal number, and edges of up
/// to 16 h do not overflow while h^6 is at most 1e-8 times the largest. A scene of another size is
/// run in the coordinates of a `Frame`.
template <class Real>
inline constexpr double least_edge_length = 1e-50;
/// `least_edge_length` for float.
template <>
inline constexpr double least_edge_length<float> = 1e-5;
/// The largest target edge length of a simulation; the reasons are those above.
template <class Real>
inline constexpr double most_edge_length = 1e50;
/// `most_edge_length` for float.
template <>
inline constexpr double most_edge_length<float> = 1e5;

} // namespace dsc
