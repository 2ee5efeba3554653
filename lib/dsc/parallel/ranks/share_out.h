// SPDX-License-Identifier: MIT
// Which rank runs which submesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace dsc {

/// Submeshes begin to end - 1.
struct ShareOfRank {
    std::size_t begin = 0; ///< the first
    std::size_t end = 0;   ///< after the last

    /// Whether it has this one.
    [[nodiscard]] bool has(std::size_t submesh) const { return begin <= submesh && submesh < end; }
};

/// Gives each rank submeshes next to each other, of about the same work in all; whole ones, so that
/// a rank may have none. O(submeshes + ranks).
[[nodiscard]] std::vector<ShareOfRank> share_out(std::span<const std::uint64_t> work,
                                                 std::uint32_t ranks);

} // namespace dsc
