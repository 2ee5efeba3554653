// SPDX-License-Identifier: MIT
// Runs a row and says what does not hold.
#pragma once

#include "combinations/row.h"

#include <string>
#include <vector>

namespace dsc::combinations {

/// Runs a row with one, two and three threads (the sequential method: twice), the second time
/// resumed from an archive, the last time, in double precision, in other units of length and time,
/// and without its interruption where that must leave no trace; and compares the end with the
/// scene's answer. The row must make sense. Edges are of the usual length over `fineness`. Returns
/// what does not hold, a sentence each.
[[nodiscard]] std::vector<std::string> problems_of(const Row& row, double fineness = 1);

} // namespace dsc::combinations
