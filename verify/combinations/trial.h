// SPDX-License-Identifier: MIT
// Runs a row and checks its results.
#pragma once

#include "combinations/row.h"

#include <string>
#include <vector>

namespace dsc::combinations {

/// Runs a row with one, two and three threads (the sequential method: twice), the second time
/// resumed from an archive, the last time, in double precision, in other units of length and time,
/// and without its interruption if that must have no effect; compares the end with the scene's
/// exact result. The row must be meaningful. Edges have the usual length divided by `fineness`.
/// Returns the failures, one sentence each.
[[nodiscard]] std::vector<std::string> problems_of(const Row& row, double fineness = 1);

} // namespace dsc::combinations
