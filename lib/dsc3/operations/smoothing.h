// SPDX-License-Identifier: MIT
// Smoothing: a vertex inside a phase moves to where the worst tet of its star is better.
#pragma once

#include "dsc3/operations/workspace.h"

namespace dsc3 {

/// Ascends the worst quality of the star by at most so many gradients, from where the vertex is or
/// from the mean of its neighbours. A vertex for which nothing was found is not tried again until
/// its star changes. O(degree).
Verdict smooth(Complex& complex, Workspace& work, Vertex vertex, int iterations = 6);

} // namespace dsc3
