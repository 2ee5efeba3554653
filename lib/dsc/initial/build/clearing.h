// SPDX-License-Identifier: MIT
// Makes room in the lattice for the interface: its vertices near the pieces go away.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/initial/build/chains.h"
#include "dsc/initial/build/lattice.h"

namespace dsc::initial {

/// Removes the lattice's inner vertices that are closer to a piece of a path than `clearance` times
/// the length of that piece. Only for a lattice as written. O(1) per piece. Returns how many.
template <class Real>
std::size_t clear_lattice(Complex<Real>& complex, const Lattice& lattice,
                          std::span<const Path> paths, double clearance);

} // namespace dsc::initial
