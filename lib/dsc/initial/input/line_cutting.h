// SPDX-License-Identifier: MIT
// Checks all lines together (they may meet only at their ends) and cuts them into the edges of the
// interface.
#pragma once

#include "dsc/initial/input/line.h"

#include <vector>

namespace dsc::initial {

/// Checks that the lines are apart, leaves out detail that is finer than the mesh, unless it is
/// kept, and cuts each line into pieces that are no longer than the edge length; returns the points
/// of the pieces by line. Throws InputError if lines meet, a curve ends inside the domain, or
/// detail that must be kept is too fine for the mesh. O(n log n) for n pieces.
template <class Real>
std::vector<std::vector<Point<double>>> cut_apart(std::vector<Line>& lines, const Lattice& lattice,
                                                  const InitialOptions& options,
                                                  InputReport& report);

} // namespace dsc::initial
