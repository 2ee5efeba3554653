// SPDX-License-Identifier: MIT
// Checks that K is a simplicial complex (thesis 3), a discrete manifold with boundary (3.2), and
// not inverted.
#pragma once

#include "reference/complex/complex.h"

#include <string>
#include <vector>

namespace dsc::reference {

/// One sentence for each error, which names the simplex; empty if K is valid. Checks the whole
/// complex: O(n log n).
std::vector<std::string> validate(const Complex& K);

} // namespace dsc::reference
