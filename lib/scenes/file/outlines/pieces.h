// SPDX-License-Identifier: MIT
// Lines from input files: closed or open, in any number and orientation.
#pragma once

#include "dsc/base/types.h"

#include <string>
#include <vector>

namespace dsc::scenes {

struct Piece {
    std::vector<Point<double>> points; ///< of a closed one, the first is not repeated
    bool is_closed = true;
};

/// The line through these points. If the last point repeats the first one, it is dropped and the
/// piece is closed; other lines are closed if `close` is true.
[[nodiscard]] Piece piece_of(std::vector<Point<double>> points, bool close);

/// For each piece, 0 if it lies inside an even number of the others, 1 if inside an odd number: by
/// the even-odd rule, an outer outline or a hole. For closed pieces that do not cross. O(pieces *
/// points).
[[nodiscard]] std::vector<int> nesting(const std::vector<Piece>& pieces);

/// A text file of points: "x y" or "x,y" a line, or "x y z" with the same z for all points of a
/// piece, which is dropped; an empty line ends a piece, and # begins a comment. Closed as
/// `piece_of` says. Throws InputError, with the line, for anything else or too many points.
[[nodiscard]] std::vector<Piece> read_points(const std::string& text, bool close,
                                             const std::string& where);

} // namespace dsc::scenes
