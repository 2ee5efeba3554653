// SPDX-License-Identifier: MIT
#include "scenes/file/nearest.h"

#include <algorithm>
#include <vector>

namespace dsc::scenes {

namespace {

/// A longer name is hardly a misspelling.
constexpr std::size_t longest_name = 64;

// The distance of V. I. Levenshtein, with swaps (F. J. Damerau, "A technique for computer detection
// and correction of spelling errors", 1964).
std::size_t letters_to_change(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                d[i][j] = i + j;
                continue;
            }
            const bool same = a[i - 1] == b[j - 1];
            d[i][j] =
                std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (same ? 0U : 1U)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
            }
        }
    }
    return d[a.size()][b.size()];
}

} // namespace

std::string nearest_name(std::string_view name, std::span<const std::string> names) {
    std::string nearest;
    if (name.size() > longest_name) {
        return nearest;
    }
    if (name.size() > 2) {
        const auto longer = std::ranges::find_if(
            names, [&](const std::string& one) { return one.starts_with(name); });
        if (longer != names.end()) {
            return *longer;
        }
    }
    std::size_t fewest = name.size() / 3 + 1; // of "stpes" two may be wrong
    for (const std::string& one : names) {
        const std::size_t changes = letters_to_change(name, one);
        if (changes < one.size() && (changes < fewest || (changes == fewest && nearest.empty()))) {
            fewest = changes;
            nearest = one;
        }
    }
    return nearest;
}

std::string allowed_names(std::string_view name, std::span<const std::string> names) {
    std::string all;
    for (const std::string& one : names) {
        all += (all.empty() ? "" : ", ") + one;
    }
    const std::string nearest = nearest_name(name, names);
    return nearest.empty() ? all : "did you mean " + nearest + "? one of: " + all;
}

} // namespace dsc::scenes
