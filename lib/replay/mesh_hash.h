// SPDX-License-Identifier: MIT
// A fingerprint of a mesh, to find out whether two meshes are bitwise identical.
#pragma once

#include "dsc/complex/complex.h"

#include <cstdint>

namespace dsc {

/// A fingerprint of the mesh: a 64-bit hash of the living triangles, of the bits of their corners'
/// coordinates and their phases. Independent of ids, of the order of triangles and of which corner
/// comes first; the order of corners (orientation) counts; -0.0 counts as 0. Coordinates are hashed
/// as doubles: a float complex and its double copy agree. Unused vertices, attributes and locks do
/// not count. O(n).
template <class Real>
[[nodiscard]] std::uint64_t mesh_hash(const Complex<Real>& complex);

} // namespace dsc
