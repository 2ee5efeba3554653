// SPDX-License-Identifier: MIT
// Files for ParaView (thesis, section 8.11): a complex as an ASCII VTK unstructured grid (.vtu),
// and the collection (.pvd) that gives a series of them their times. The formats are those of
// Kitware's "VTK file formats".
#pragma once

#include "dsc/complex/complex.h"

#include <span>
#include <string>

namespace dsc {

/// Writes all living vertices and triangles, the phase of each triangle, and the attributes of type
/// double of vertices and triangles (the format has no data of edges). Numbers read back bit by
/// bit. The file exists as a whole or not at all. O(n). Throws FileError.
template <class Real>
void write_vtu(const Complex<Real>& complex, const std::string& path);

/// One file of a series.
struct PvdEntry {
    double time = 0;    ///< in the units of the simulation
    std::string file{}; ///< relative to the folder of the .pvd file
};

/// Writes the collection. Throws FileError.
void write_pvd(std::span<const PvdEntry> entries, const std::string& path);

} // namespace dsc
