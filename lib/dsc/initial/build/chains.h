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

/// Each vertex of the chains once: by its first place, but a chain's own first vertex last.
inline std::vector<std::uint32_t> vertices_on(const Chains& chains, std::uint32_t vertex_bound) {
    std::vector<std::uint32_t> result;
    std::vector<std::uint8_t> seen(vertex_bound, 0);
    const auto add = [&](std::uint32_t v) {
        if (seen[v] == 0) {
            seen[v] = 1;
            result.push_back(v);
        }
    };
    for (const Chain& chain : chains) {
        for (std::size_t i = 1; i < chain.size(); ++i) {
            add(chain[i]);
        }
        add(chain.front());
    }
    return result;
}

} // namespace dsc::initial
