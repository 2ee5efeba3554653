// SPDX-License-Identifier: MIT
// What the method promises about shapes: flows with an exact solution, each with the edge lengths
// and options to which the promise applies.
#pragma once

#include "checks.h"

namespace dsc::gate {

/// The checks on accuracy; their "scenes" are flows with a size, such as "swirl 2x260 h=0.01".
[[nodiscard]] std::vector<Check> accuracy_checks();

} // namespace dsc::gate
