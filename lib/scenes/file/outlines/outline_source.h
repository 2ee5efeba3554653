// SPDX-License-Identifier: MIT
// The sources of outlines and curves in a scene file. A [[shape]] or a [[curve]] has one of
//
//     points    = [[x, y], ...]
//     file      = "NAME": a text file with lines of x y; an empty line ends a piece
//     circle    = { centre = [x, y], radius }
//     ellipse   = { centre = [x, y], radii = [a, b], angle in degrees }
//     rectangle = { low = [x, y], high = [x, y] }
//
// and optionally `scale = [a, b]` and `move = [x, y]`: coordinates are first scaled and then moved.
#pragma once

#include "scenes/file/outlines/pieces.h"
#include "scenes/file/table_reader.h"
#include "shapes/curve.h"

#include <functional>

namespace dsc::scenes {

struct OutlineSource {
    /// For the target length of edges. Throws InputError for more than a million points.
    std::function<std::vector<Piece>(double edge_length)> pieces;
    std::optional<ParametricCurve> curve{}; ///< the exact curve, if known; for a single piece
};

/// The keys of a source with `scale` and `move`, for `TableReader::allow`.
[[nodiscard]] std::vector<std::string> source_keys();

/// Reads the source of a table, and the file that it names, relative to the scene file. If `close`,
/// lines of points are closed. Throws InputError or FileError.
[[nodiscard]] OutlineSource read_outline_source(const TableReader& reader, bool close);

} // namespace dsc::scenes
