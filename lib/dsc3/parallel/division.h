// SPDX-License-Identifier: MIT
// Where the cuts of all colours run.
#pragma once

#include "dsc3/complex/ownership.h"
#include "dsc3/parallel/parallel.h"

#include <array>
#include <cstdint>
#include <vector>

namespace dsc3 {

/// The largest default number of slabs, of blocks, and of submeshes of an application's own
/// partition.
inline constexpr std::uint32_t default_slabs = 8;

/// The number of submeshes of an application's own partition.
[[nodiscard]] inline std::uint32_t partition_size(const Parallel& parallel) {
    return parallel.submeshes == 0 ? default_slabs : parallel.submeshes;
}
/// No colour gets more submeshes.
[[nodiscard]] inline std::uint32_t largest_division(const Parallel& parallel) {
    return parallel.submeshes == 0 ? submesh_limit : parallel.submeshes;
}

/// Cuts space into up to `parallel.submeshes` parts in each colour; 0: by the number of places.
/// The first colour divides all places, by the division or the partition; each later one cuts cells
/// of the places near the cuts of all colours before. Each cut of cells runs where it costs least:
/// few places near it, and shares nearly equal. Deterministic. O(places + log^2 of the sample);
/// reorders the places.
[[nodiscard]] std::array<CutTree, colour_count>
cut_colours(std::vector<Point>& places, const Parallel& parallel, Real edge_length);

} // namespace dsc3
