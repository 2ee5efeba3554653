// SPDX-License-Identifier: MIT
#include "dsc/parallel/ranks/share_out.h"

#include <algorithm>
#include <numeric>

namespace dsc {

std::vector<ShareOfRank> share_out(std::span<const std::uint64_t> work, std::uint32_t ranks) {
    // One is added to each, so that those without work are shared out as well.
    const std::uint64_t total =
        std::accumulate(work.begin(), work.end(), std::uint64_t{0}) + work.size();
    std::vector<ShareOfRank> shares(ranks);
    std::size_t at = 0;
    std::uint64_t before = 0;
    for (std::uint32_t rank = 0; rank < ranks; ++rank) {
        shares[rank].begin = at;
        // A submesh belongs to the share in which its middle lies.
        while (at < work.size() &&
               (2 * before + work[at] + 1) * ranks < 2 * total * (std::uint64_t{rank} + 1)) {
            before += work[at] + 1;
            ++at;
        }
        shares[rank].end = at;
    }
    shares.back().end = work.size();
    return shares;
}

} // namespace dsc
