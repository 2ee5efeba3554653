// SPDX-License-Identifier: MIT
// Parallel DSC in one line: `Simulation simulation(complex, options, Parallel{.threads = 2})`.
#pragma once

#include "dsc/base/names.h"
#include "dsc3/complex/ownership.h"

#include <array>
#include <cstdint>

namespace dsc3 {

/// How the first colour divides the mesh; the later ones always cut cells, where the submeshes of
/// the colours before meet.
enum class Division : std::uint8_t {
    cells,  ///< cuts in any direction, where they cost least
    fixed,  ///< slabs of equal width, across the longest extent of the work
    active, ///< slabs of equal work
    blocks, ///< blocks of equal work in two directions
};

inline constexpr std::array division_names{
    dsc::Named{Division::cells, "cells"},
    dsc::Named{Division::fixed, "fixed"},
    dsc::Named{Division::active, "active"},
    dsc::Named{Division::blocks, "blocks"},
};

/// The result depends on the division and the number of submeshes, and not on the number of
/// threads.
struct Parallel {
    std::uint32_t threads = 1; ///< largest number of threads, 1 to 1024
    /// Into how many submeshes the mesh is divided at most: a power of two up to 64. 0: by the
    /// work, from 4 on: cells up to 64, slabs, blocks and partitions up to 8.
    std::uint32_t submeshes = 0;
    Division division = Division::cells;
    /// In place of `division`; its numbers count modulo `submeshes`, or modulo 8 if that is 0.
    Partition partition{};
    bool profile = false; ///< measure times: see `Simulation::profile`
};

} // namespace dsc3
