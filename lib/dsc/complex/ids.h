// SPDX-License-Identifier: MIT
// Free ids. They are part of a complex's value, including those lent to submeshes that run in
// parallel, so that a complex can be copied, renumbered, replaced or restored at any time. A
// borrower records the generation in which its pool was lent; in a later generation that pool no
// longer exists.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

namespace dsc {

/// A pool of free ids. The complex grows its arrays when its own pool is empty. A submesh that runs
/// in parallel may not grow them: an edit that finds its pool empty is refused
/// (`Verdict::out_of_ids`).
struct IdPool {
    std::vector<std::uint32_t> vertices;  ///< ids without a vertex
    std::vector<std::uint32_t> triangles; ///< ids without a triangle
    bool may_grow = true;                 ///< false: an empty pool refuses
};

/// All free ids of a complex: its own pool, and those lent to submeshes.
struct FreeIds : IdPool {
    /// The pool of one submesh. Pools share no cache line, because different threads use them.
    struct alignas(64) Lent : IdPool {};

    std::deque<Lent> lent;        ///< addresses stay when pools are added
    std::uint64_t generation = 1; ///< pools lent in an earlier one no longer exist

    FreeIds() = default;
    /// The same pools, lent to nobody.
    FreeIds(const FreeIds&) = default;
    /// Moves the ids; the other object has none afterwards and begins a new generation.
    FreeIds(FreeIds&& other) noexcept;
    /// Begins a new generation.
    FreeIds& operator=(const FreeIds& other);
    /// Begins a new generation in both; leaves no id in the other.
    FreeIds& operator=(FreeIds&& other) noexcept;
    ~FreeIds() = default;

    /// The pool with this number; missing pools up to it are created.
    [[nodiscard]] IdPool& lend(std::size_t number);
    /// Takes all ids back into the pool of the complex, and begins a new generation. O(lent ids).
    void collect();
    /// Drops all ids and begins a new generation. O(pools).
    void clear();
    /// Free vertices, lent ones included. O(pools).
    [[nodiscard]] std::uint32_t vertex_total() const;
    /// The same for triangles.
    [[nodiscard]] std::uint32_t triangle_total() const;
};

/// Moves ids from the end of `from` to `to` until at most these numbers are left.
void move_ids(IdPool& from, IdPool& to, std::size_t vertices, std::size_t triangles);

} // namespace dsc
