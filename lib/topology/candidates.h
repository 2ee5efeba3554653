// SPDX-License-Identifier: MIT
// Candidates: places where the topology may have to change, and how threads examine them.
#pragma once

#include "dsc/motion/interface_flow.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace dsc {

/// A vertex of the interface, and whether the topology may have to change there.
struct Candidate {
    std::uint32_t vertex; ///< its id
    /// The interface turns sharply or tightly there, has a junction, or is beside the domain
    /// boundary.
    bool is_sharp;
    /// A sharp turn or a junction, other than a turn of two edges inside; or the end of a curve on
    /// the domain boundary, which may have come to a corner.
    bool is_junction;
};

/// Appends what `look(place, found)` appends for each place to `found`, in their order. `look` may
/// only read, since several threads call it at the same time. No allocation if nothing is found.
template <class Place, class Found, class Look>
void find_at(const InShares& in_shares, std::span<const Place> places, std::vector<Found>& found,
             const Look& look) {
    constexpr std::size_t ranges = 16; // for the threads
    constexpr std::size_t few = 64;    // done before another thread has begun
    std::array<std::vector<Found>, ranges> parts;
    const auto look_in = [&](std::size_t range) {
        const std::size_t begin = places.size() * range / ranges;
        const std::size_t end = places.size() * (range + 1) / ranges;
        for (const Place& place : places.subspan(begin, end - begin)) {
            look(place, parts[range]);
        }
    };
    (places.size() < few ? one_by_one : in_shares)(ranges, std::cref(look_in));
    for (const auto& part : parts) {
        found.insert(found.end(), part.begin(), part.end());
    }
}

} // namespace dsc
