// SPDX-License-Identifier: MIT
// Vectors that every step refills. `std::vector::assign`, a copy, or `insert` after `clear` may
// allocate exactly as much as they need: while an interface grows by a few vertices per step, they
// would allocate in every step.
#pragma once

#include <algorithm>
#include <cstddef>
#include <ranges>
#include <vector>

namespace dsc {

/// Reserves room for `size` entries; where it must grow, the capacity at least doubles. Amortised
/// O(1) for each entry.
template <class T>
void have_room(std::vector<T>& list, std::size_t size) {
    if (size > list.capacity()) {
        list.reserve(std::max(size, 2 * list.capacity()));
    }
}

/// Appends the entries of another list.
template <class T, std::ranges::sized_range Entries>
void append(std::vector<T>& list, const Entries& entries) {
    have_room(list, list.size() + std::ranges::size(entries));
    list.insert(list.end(), std::ranges::begin(entries), std::ranges::end(entries));
}

/// Replaces all entries by those of another list.
template <class T, std::ranges::sized_range Entries>
void assign(std::vector<T>& list, const Entries& entries) {
    list.clear();
    append(list, entries);
}

} // namespace dsc
