// SPDX-License-Identifier: MIT
// Surfaces of triangles from files.
#pragma once

#include "dsc3/initial/shapes.h"

#include <string>

namespace dsc3 {

/// Reads a surface from a file of a kind that Assimp knows: .stl, .ply, .obj and others. Faces of
/// more corners are cut into triangles, and points with the same coordinates, which have single
/// precision, become one. Whether it is closed, `closed_surface` says. Throws FileError if the file
/// cannot be read or has no triangles.
[[nodiscard]] TriangleSurface read_surface(const std::string& path);

} // namespace dsc3
