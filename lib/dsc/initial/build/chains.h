// SPDX-License-Identifier: MIT
// The pieces of the interface, strung together: as points before they are inserted, as vertices
// afterwards.
#pragma once

#include "dsc/base/types.h"

#include <span>
#include <vector>

namespace dsc::initial {

/// Two or more points, each joined to the next one by a piece. A closed path repeats its first
/// point at the end.
using Path = std::span<const Point<double>>;

/// The same by the ids of vertices, one chain for each path.
using Chain = std::vector<std::uint32_t>;
using Chains = std::vector<Chain>;

/// The vertices of the chains, the first of each last. A junction comes once for each chain there.
inline std::vector<std::uint32_t> vertices_on(const Chains& chains) {
    std::vector<std::uint32_t> result;
    for (const Chain& chain : chains) {
        result.insert(result.end(), chain.begin() + 1, chain.end());
        if (chain.front() != chain.back()) {
            result.push_back(chain.front());
        }
    }
    return result;
}

} // namespace dsc::initial
