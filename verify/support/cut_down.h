// SPDX-License-Identifier: MIT
// A failed run is kept as its first complex and its log, and reduced by leaving out records.
#pragma once

#include "dsc/io/replay.h"

#include <functional>
#include <utility>
#include <vector>

namespace dsc::test {

/// Leaves out records for as long as `fails(first complex with the rest replayed)` stays true, in
/// ever smaller pieces (A. Zeller, R. Hildebrandt, "Simplifying and isolating failure-inducing
/// input", 2002). Returns the remaining records: all of them if `fails` is false to begin with.
/// O(edits^2) replays at worst, usually O(edits log edits).
template <class Real>
[[nodiscard]] std::vector<Edit>
cut_down(const Complex<Real>& first, std::vector<Edit> edits,
         const std::function<bool(const Complex<Real>& replayed)>& fails) {
    const auto still_fails = [&](const std::vector<Edit>& some) {
        Complex<Real> complex = first;
        replay<Real>(complex, some);
        return fails(complex);
    };
    if (!still_fails(edits)) {
        return edits;
    }
    for (std::size_t piece = (edits.size() + 1) / 2; piece > 0; piece /= 2) {
        // From the end: later records depend on earlier ones.
        for (std::size_t end = edits.size(); end > 0;) {
            const std::size_t begin = end > piece ? end - piece : 0;
            std::vector<Edit> fewer(edits.begin(),
                                    edits.begin() + static_cast<std::ptrdiff_t>(begin));
            fewer.insert(fewer.end(), edits.begin() + static_cast<std::ptrdiff_t>(end),
                         edits.end());
            if (still_fails(fewer)) {
                edits = std::move(fewer);
            }
            end = begin;
        }
    }
    return edits;
}

} // namespace dsc::test
