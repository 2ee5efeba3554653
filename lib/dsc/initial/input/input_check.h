// SPDX-License-Identifier: MIT
// Checks and prepares the input of the initial complex: outlines and curves, rounded to the scalar
// and cut into pieces.
#pragma once

#include "dsc/initial/build/lattice.h"
#include "dsc/initial/initial_complex.h"

#include <optional>
#include <string>

namespace dsc::initial {

/// The interface may come as close to the sides of the domain as this share of the edge length.
inline constexpr double min_margin = 1e-3;
/// Complexes with more triangles than this are refused as a mistake; ids would end at 2^30.
inline constexpr double max_triangles = 5e8;
/// The largest number of pieces of the interface.
inline constexpr double max_pieces = max_triangles / 4;
/// Qualities compare products of four lengths, and quotients of these: they must stay within the
/// range of doubles. The limit of a simulation is stricter: `min_edge_length` in triangle.h.
inline constexpr double min_initial_edge_length = 1e-100;
/// Detail is kept in edges that are at least this times the edge length long.
inline constexpr double shortest_kept_edge = 0.05;
/// The edge length must be at least this many steps of the scalar at the largest coordinate.
inline constexpr double min_steps = 64;

/// A path of the interface without an edge longer than the target; a closed one repeats its first
/// point at the end. Two paths, or two parts of one, have no points in common but ends.
struct CheckedPath {
    std::string name; ///< in messages: "shape 2"
    Phase left = exterior_phase;
    std::optional<Phase> right; ///< none for an outline, which runs counter-clockwise
    /// Representable in the scalar of the complex.
    std::vector<Point<double>> points;
};

struct CheckedInput {
    Lattice lattice;
    std::vector<CheckedPath> paths{};
    Phase background = exterior_phase; ///< phase of the domain, if there is no path
    bool has_outside = false;          ///< triangles of `border_phase` do not belong to the domain
};

/// A shape of `border_phase` is the surroundings of the domain: its outline is the rectangle, and
/// its holes are the rings of the domain.
[[nodiscard]] inline bool is_outside(const Shape& shape) { return shape.phase == border_phase; }

/// `Drawn` is `Shape` or `Curve`. Throws InputError as `initial_complex` documents, except for
/// phases that contradict each other: `fill_phases` finds these. Counts left-out detail in
/// `report`. O(n log n) for n pieces.
template <class Real, class Drawn>
CheckedInput check_input(const Rectangle& domain, std::span<const Drawn> drawn,
                         const InitialOptions& options, InputReport& report);

} // namespace dsc::initial
