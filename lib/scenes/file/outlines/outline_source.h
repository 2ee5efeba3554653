// SPDX-License-Identifier: MIT
// Where a scene file's outlines and curves come from. A [[shape]] or a [[curve]] has one of
//
//     points    = [[x, y], ...]
//     file      = "NAME": a text file with lines of x y; an empty line ends a piece
//     circle    = { centre = [x, y], radius }
//     ellipse   = { centre = [x, y], radii = [a, b], angle in degrees }
//     rectangle = { low = [x, y], high = [x, y] }
//
// and optionally `scale = [a, b]` and `move = [x, y]`: coordinates are multiplied first and then
// moved.
#pragma once

#include "scenes/file/outlines/pieces.h"
#include "scenes/file/table_reader.h"
#include "shapes/curve.h"

#include <functional>

namespace dsc::scenes {

struct OutlineSource {
    /// For the target length of edges. Throws InputError for more than a million points.
    std::function<std::vector<Piece>(double edge_length)> pieces;
    std::optional<ParametricCurve>
        curve{}; ///< the exact one, if there is one piece and it is known
};

/// The keys of a source and of what is done to it, for `TableReader::allow`.
[[nodiscard]] std::vector<std::string> source_keys();

/// Reads the source of a table, and the file that it names: relative to the scene file. Texts of
/// points are closed if `close`. Throws InputError or FileError.
[[nodiscard]] OutlineSource read_outline_source(const TableReader& reader, bool close);

} // namespace dsc::scenes
