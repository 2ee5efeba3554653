// SPDX-License-Identifier: MIT
// Triangulated surfaces from files.
#pragma once

#include "dsc3/initial/shapes.h"

#include <string>

namespace dsc3 {

/// Reads a surface from a file in a format of Assimp: .stl, .ply, .obj and others. Polygons are
/// triangulated, and points with equal coordinates, which have single precision, are merged.
/// `closed_surface` checks whether the surface is closed. Throws FileError if the file cannot be
/// read or has no triangles.
[[nodiscard]] TriangleSurface read_surface(const std::string& path);

} // namespace dsc3
