// SPDX-License-Identifier: MIT
// Smoothing: moves a vertex inside a phase to improve the worst tet of its star.
#pragma once

#include "dsc3/operations/workspace.h"

namespace dsc3 {

/// Increases the worst quality of the star by at most `iterations` steps of gradient ascent, from
/// the vertex's position or from the mean of its neighbours. A vertex that could not be improved is
/// not tried again until its star changes. O(degree).
Verdict smooth(Complex& complex, Workspace& work, Vertex vertex, int iterations = 6);

} // namespace dsc3
