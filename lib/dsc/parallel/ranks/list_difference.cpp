// SPDX-License-Identifier: MIT
#include "dsc/parallel/ranks/list_difference.h"

#include <algorithm>
#include <cstddef>

namespace dsc {

namespace {

/// How far ahead the lists are searched for where they agree again.
constexpr std::size_t window = 12;

/// A run that stays, then entries that go and entries that come.
struct Hunk {
    std::size_t same = 0;
    std::size_t gone = 0;
    std::size_t come = 0;
};

using Ids = std::span<const std::uint32_t>;

// What goes and comes at the beginnings of two lists that begin differently.
Hunk first_change(Ids before, Ids after) {
    if (before.empty() || after.empty()) {
        return {0, before.size(), after.size()};
    }
    for (std::size_t sum = 1; sum <= window; ++sum) {
        for (std::size_t gone = 0; gone <= sum; ++gone) {
            const std::size_t come = sum - gone;
            if (gone < before.size() && come < after.size() && before[gone] == after[come]) {
                return {0, gone, come};
            }
        }
    }
    return {0, std::min(window, before.size()), std::min(window, after.size())};
}

} // namespace

void write_difference(MessageWriter& message, Ids before, Ids after) {
    while (true) {
        const auto [old_end, new_end] = std::ranges::mismatch(before, after);
        const auto same = static_cast<std::size_t>(old_end - before.begin());
        before = before.subspan(same);
        after = after.subspan(same);
        if (before.empty() && after.empty()) {
            break; // the rest stays
        }
        const Hunk hunk = first_change(before, after);
        message.count(1 + same);
        message.count(hunk.gone);
        message.list(after.first(hunk.come));
        before = before.subspan(hunk.gone);
        after = after.subspan(hunk.come);
    }
    message.count(0);
}

void read_difference(MessageReader& message, std::vector<std::uint32_t>& list) {
    std::uint64_t same = message.count();
    if (same == 0) {
        return;
    }
    std::vector<std::uint32_t> after;
    after.reserve(list.size() + 2 * window);
    std::vector<std::uint32_t> come;
    std::size_t at = 0;
    const auto keep = [&](std::size_t count) {
        const auto from = list.begin() + static_cast<std::ptrdiff_t>(at);
        after.insert(after.end(), from, from + static_cast<std::ptrdiff_t>(count));
        at += count;
    };
    for (; same != 0; same = message.count()) {
        const std::uint64_t gone = message.count();
        if (same - 1 > list.size() - at || gone > list.size() - at - (same - 1)) {
            throw InvariantError("another rank has another list of ids");
        }
        keep(same - 1);
        at += gone;
        message.list(come);
        after.insert(after.end(), come.begin(), come.end());
    }
    keep(list.size() - at);
    list = std::move(after);
}

} // namespace dsc
