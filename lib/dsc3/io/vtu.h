// SPDX-License-Identifier: MIT
// Files for ParaView and other readers of VTK's XML format.
#pragma once

#include "dsc3/complex/complex.h"

#include <string>

namespace dsc3 {

/// Writes all tets with their phase and quality, and all attributes of numbers and points. The
/// write is atomic. Throws FileError. O(mesh).
void write_vtu(const Complex& complex, const std::string& path);

/// Writes the faces of the interface, counter-clockwise as seen from the lower phase, with the
/// phases on both sides (`inside`: the higher one), and the attributes of vertices. Throws
/// FileError. O(mesh).
void write_interface_vtu(const Complex& complex, const std::string& path);

} // namespace dsc3
