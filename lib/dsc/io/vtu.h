// SPDX-License-Identifier: MIT
// Files for ParaView (thesis, section 8.11): a complex as a VTK unstructured grid (.vtu), and the
// collection (.pvd) that gives a series of them their times. The formats are those of Kitware's
// "VTK file formats": numbers are appended in binary, compressed by zlib.
#pragma once

#include "dsc/complex/complex.h"

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace dsc {

/// An array to be written beside the complex's own data.
struct VtuArray {
    std::string name;                       ///< in the file
    SimplexKind kind = SimplexKind::vertex; ///< or triangle; the format has no data of edges
    std::uint32_t components = 1;           ///< 1, or 2 for vectors of the plane
    /// By id: those of id i begin at i * components. Entries of free ids are left out.
    std::variant<std::vector<double>, std::vector<std::int32_t>> values;
};

/// Writes all living vertices and triangles; for each vertex its `position`, for each triangle its
/// `phase` and its `quality` (equation 4 of the thesis); the attributes of vertices and triangles
/// whose entries are numbers (double, float, integers of 8 to 64 bits) or points; and `more`. An
/// attribute whose name is already taken is left out. Numbers read back bit by bit; vectors get a
/// third component of 0. The file exists as a whole or not at all. O(n). Throws FileError;
/// InputError where the length or the components of an array are wrong.
template <class Real>
void write_vtu(const Complex<Real>& complex, const std::string& path,
               std::span<const VtuArray> more = {});

/// One file of a series.
struct PvdEntry {
    double time = 0;    ///< in the units of the simulation
    std::string file{}; ///< relative to the folder of the .pvd file
};

/// Writes the collection. Throws FileError.
void write_pvd(std::span<const PvdEntry> entries, const std::string& path);

} // namespace dsc
