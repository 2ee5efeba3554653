// SPDX-License-Identifier: MIT
// Grids of velocities from files of other programs.
#pragma once

#include "scenes/file/grid/grid_field.h"

#include <string>
#include <string_view>

namespace dsc::scenes {

/// A NumPy array (.npy, format 1 or 2; float64 or float32, little-endian, C order) of the shape
/// (rows, columns, 2), or (times, rows, columns, 2) with those times; rows go upwards. The box is
/// to be set by the caller. Throws InputError for any other file, and for a number of times that
/// does not fit.
[[nodiscard]] GridValues read_npy(std::string_view bytes, const std::vector<double>& times,
                                  const std::string& where);

/// Lines of `x,y,u,v` or `t,x,y,u,v`, in any order: all points of a grid with equal steps in x and
/// in y, at each time. # begins a comment; a first line of names is skipped. Throws InputError,
/// with the line, for anything else, and for a point that is missing or there twice.
[[nodiscard]] GridValues read_grid_csv(std::string_view text, const std::string& where);

} // namespace dsc::scenes
