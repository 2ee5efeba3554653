// SPDX-License-Identifier: MIT
// Few rows in which every combination of a few features occurs: a covering array, made greedily, as
// in D. M. Cohen, S. R. Dalal, M. L. Fredman, G. C. Patton, "The AETG system: an approach to
// testing based on combinatorial design" (1997).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace dsc::combinations {

/// What a cover is made for.
struct CoverTask {
    std::span<const std::size_t> counts; ///< of the values of each feature, the deciding ones first
    std::size_t strength = 2;            ///< so many features at a time
    std::uint64_t seed = 1;              ///< another one gives other rows
    /// Whether those values of `row` that `is_set` names may stand together.
    std::function<bool(std::span<const std::uint8_t> row, std::span<const bool> is_set)>
        makes_sense;
};

struct Cover {
    std::vector<std::vector<std::uint8_t>> rows;
    std::size_t combinations = 0; ///< of values, that make sense
    std::size_t covered = 0;      ///< of these, by the rows
    std::size_t senseless = 0;    ///< combinations that stand in no row
};

/// The same task gives the same rows. O(rows * combinations of features) with a factor of some
/// hundred.
[[nodiscard]] Cover cover(const CoverTask& task);

} // namespace dsc::combinations
