// SPDX-License-Identifier: MIT
// All lines together: they meet at their ends alone, and are cut into the edges of the interface.
#pragma once

#include "dsc/initial/input/line.h"

#include <vector>

namespace dsc::initial {

/// Checks that the lines are apart, leaves out detail that is finer than the mesh, unless it is
/// kept, and cuts each line into pieces that are no longer than the edge length; returns the points
/// of the pieces by line. Throws InputError where lines meet, a curve ends inside the domain, or
/// detail is kept that the mesh cannot carry. O(n log n) for n pieces.
template <class Real>
std::vector<std::vector<Point<double>>> cut_apart(std::vector<Line>& lines, const Lattice& lattice,
                                                  const InitialOptions& options,
                                                  InputReport& report);

} // namespace dsc::initial
