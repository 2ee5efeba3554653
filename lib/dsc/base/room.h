// SPDX-License-Identifier: MIT
// Room in arrays that a step fills anew. `assign`, a copy, and `insert` after `clear` make room for
// exactly what they are given: while an interface grows by a few vertices in each step, they would
// allocate in each of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <ranges>
#include <vector>

namespace dsc {

/// Makes room for `size` entries: twice the room there was, or more. Amortised O(1) for each entry.
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
