// SPDX-License-Identifier: MIT
// The vertices that a flow moves: those of the interface, derived from the phases (thesis, section
// 8.6), and those inside the phases that are advected (`Options::advected_phases`). Also finds the
// features of the interface.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/passes/options.h"

#include <span>
#include <vector>

namespace dsc {

/// Shuffles the list if `seed` is not 0, to see how much results depend on the order of operations;
/// the same seed gives the same order. O(list).
void shuffle_interface(std::vector<std::uint32_t>& list, std::uint64_t seed);

/// All interface vertices of a complex, curve by curve. O(n), once at the start.
template <class Real>
std::vector<std::uint32_t> collect_interface(const Complex<Real>& complex);

/// Restores the order along the curve in a list of interface vertices, starting at its first
/// vertex. O(list). Uses the stamps `epoch` and epoch + 1, which no vertex may have before.
template <class Real>
void order_interface(Complex<Real>& complex, std::vector<std::uint32_t>& list, std::uint32_t epoch);

/// The turn of a curve is measured between chords of arcs of this share of the edge length: finer
/// detail is no feature at the scale of the mesh.
inline constexpr double feature_arc = 0.2;

/// Marks as features those interface vertices of `list` at which the curve turns by more than
/// `degrees`, measured over arcs of at least this length on both sides; of several on one arc, the
/// one with the sharpest turn, or all at the blunt end of a strip. Marks are permanent: a feature
/// whose angle opens stays one, and a tip that becomes sharp later does not become one. O(list)
/// where edges are no shorter than the arc.
template <class Real>
void mark_features(Complex<Real>& complex, const std::vector<std::uint32_t>& list, double degrees,
                   Real arc);

/// Whether a living vertex lies inside one of these phases, away from the domain boundary.
/// O(degree).
template <class Real>
[[nodiscard]] bool is_advected(const Complex<Real>& complex, std::span<const Phase> phases,
                               Vertex vertex);

/// All vertices that a flow moves: the interface curve by curve, then the others by id; shuffled if
/// the options say so. O(n), once at the start.
template <class Real>
[[nodiscard]] std::vector<std::uint32_t> collect_moved(const Complex<Real>& complex,
                                                       const Options<Real>& options);

/// Whether a flow moves this vertex now: it lives, in a triangle, on the interface or advected.
/// O(degree).
template <class Real>
[[nodiscard]] bool is_moved(const Complex<Real>& complex, const Options<Real>& options,
                            Vertex vertex);

} // namespace dsc
