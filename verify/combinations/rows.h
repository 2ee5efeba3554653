// SPDX-License-Identifier: MIT
// The rows to be run: meaningful ones, drawn at random until each combination of a few values
// occurs in one of them; and rows that have failed before or still fail.
#pragma once

#include "combinations/row.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace dsc::combinations {

/// Why a row is meaningless: its options are not allowed, or its result is unknown. Empty if it is
/// meaningful.
[[nodiscard]] std::string_view nonsense_in(const Row& row);

struct Cover {
    std::vector<Values> rows;
    std::size_t combinations =
        0;                     ///< number of combinations of values, each of which occurs in a row
    std::size_t senseless = 0; ///< number of combinations that occur in no meaningful row
};

/// Rows with every meaningful combination of `strength` values. The same seed gives the same rows
/// on every machine. O(rows * combinations), with a factor of a few tens.
[[nodiscard]] Cover cover_features(std::size_t strength, std::uint64_t seed = 1);

/// The rows of found.txt: they failed before, and are reduced to the features that the failure
/// needed.
[[nodiscard]] std::vector<Values> found_rows();

/// The rows of open.txt: they still fail.
[[nodiscard]] std::vector<Values> open_rows();

} // namespace dsc::combinations
