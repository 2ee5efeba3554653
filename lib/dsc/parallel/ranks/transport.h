// SPDX-License-Identifier: MIT
// How processes that share the work of one simulation, its ranks, reach each other. The library
// knows no more of it than this: dsc::mpi (lib/mpi) is one transport, threads of one process are
// another.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace dsc {

/// The bytes of every rank, in the order of the ranks.
using RankBytes = std::span<const std::span<const std::byte>>;

/// Carries bytes between the ranks. All of them make the same calls in the same order.
class Transport {
public:
    virtual ~Transport() = default;
    Transport() = default;
    Transport(const Transport&) = delete;
    Transport& operator=(const Transport&) = delete;
    Transport(Transport&&) = delete;
    Transport& operator=(Transport&&) = delete;

    /// The number of this rank: 0 to size() - 1.
    [[nodiscard]] virtual std::uint32_t rank() const = 0;
    /// How many ranks there are.
    [[nodiscard]] virtual std::uint32_t size() const = 0;
    /// Gives `mine` to all ranks and returns the bytes of all of them, this one included; valid
    /// until the next call. Returns when every rank has called it. Throws where the connection is
    /// lost.
    [[nodiscard]] virtual RankBytes all_gather(std::span<const std::byte> mine) = 0;
};

} // namespace dsc
