// SPDX-License-Identifier: MIT
// The hard cases by what is hard about them; `all_cases` puts them together.
#pragma once

#include "result.h"

#include <vector>

namespace dsc::hard {

void append_coordinates(std::vector<HardCase>& cases); ///< offsets, sizes, the ends of a scalar
void append_long_steps(std::vector<HardCase>& cases);  ///< many edges a step; filaments
void append_contacts(std::vector<HardCase>& cases);    ///< interface on interface, wall, junction
void append_degenerate(std::vector<HardCase>& cases);  ///< needles, caps, near-degenerate grids
void append_numbers(std::vector<HardCase>& cases);     ///< denormals, NaN, infinity
void append_long_runs(std::vector<HardCase>& cases);   ///< 100 revolutions, a million steps

} // namespace dsc::hard
