// SPDX-License-Identifier: MIT
// The interface as a surface, for programs that show or process surfaces.
#pragma once

#include "dsc3/complex/complex.h"

#include <string>

namespace dsc3 {

/// Writes the faces of the interface, counter-clockwise as seen from the lower phase, as binary
/// PLY. The write is atomic. Throws FileError. O(mesh).
void write_ply(const Complex& complex, const std::string& path);

/// The same as binary STL, which has single precision and no shared vertices: for programs that
/// read nothing else.
void write_stl(const Complex& complex, const std::string& path);

} // namespace dsc3
