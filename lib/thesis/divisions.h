// SPDX-License-Identifier: MIT
// The ways to divide a mesh, those of the thesis and the library's own, in one list: for programs
// that let their user choose one by its name.
#pragma once

#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"
#include "thesis/copies/copy_executor.h"
#include "thesis/divisions/blocks.h"
#include "thesis/divisions/slabs.h"

#include <array>

namespace dsc {

/// The divisions in submeshes of the mesh itself.
inline constexpr std::array<const Division*, 5> in_place_divisions{
    &fixed_division, &counting_division, &active_division, &blocks_division, &cells_division};

/// All of these, and create and merge.
inline constexpr std::array<const Division*, 6> all_divisions{&fixed_division,  &counting_division,
                                                              &active_division, &blocks_division,
                                                              &cells_division,  &copy_division};

} // namespace dsc
