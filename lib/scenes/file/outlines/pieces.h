// SPDX-License-Identifier: MIT
// Lines as they come from outside: closed or open, in any number and orientation.
#pragma once

#include "dsc/base/types.h"

#include <string>
#include <vector>

namespace dsc::scenes {

struct Piece {
    std::vector<Point<double>> points; ///< of a closed one, the first is not repeated
    bool is_closed = true;
};

/// The line through these points. Where it ends at the point at which it begins, that one is not
/// repeated, and the piece is closed; others are if `close` is true.
[[nodiscard]] Piece piece_of(std::vector<Point<double>> points, bool close);

/// Whether a piece lies inside an even number of the others (0) or an odd one (1): with the
/// even-odd rule, the outer outlines of a region and its holes. For closed pieces that do not
/// cross. O(pieces * points).
[[nodiscard]] std::vector<int> nesting(const std::vector<Piece>& pieces);

/// A text file of points: "x y" or "x,y" a line; an empty line ends a piece, and # begins a
/// comment. Closed as `piece_of` says. Throws InputError, with the line, for anything else or too
/// many points.
[[nodiscard]] std::vector<Piece> read_points(const std::string& text, bool close,
                                             const std::string& where);

} // namespace dsc::scenes
