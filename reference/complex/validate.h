// SPDX-License-Identifier: MIT
// Is K a simplicial complex (thesis 3), a discrete manifold with boundary (3.2), and not inverted?
#pragma once

#include "reference/complex/complex.h"

#include <string>
#include <vector>

namespace dsc::reference {

/// One sentence for each fault, which names the simplex; empty if there is none. Checks the
/// whole complex: O(n log n).
std::vector<std::string> validate(const Complex& K);

} // namespace dsc::reference
