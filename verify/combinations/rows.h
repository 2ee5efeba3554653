// SPDX-License-Identifier: MIT
// Which rows are run: those that make sense, drawn at random until each combination of a few values
// stands in one of them; and those that have failed once, or still do.
#pragma once

#include "combinations/row.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace dsc::combinations {

/// Why a row makes no sense: no simulation could be asked for it, or nobody knows its answer. Empty
/// if it makes sense.
[[nodiscard]] std::string_view nonsense_in(const Row& row);

struct Cover {
    std::vector<Values> rows;
    std::size_t combinations = 0; ///< of values, each of which stands in one of the rows
    std::size_t senseless = 0;    ///< combinations that stand in no row that makes sense
};

/// Rows in which every combination of so many values stands that makes sense. The same seed gives
/// the same rows on every machine. O(rows * combinations) with a factor of some ten.
[[nodiscard]] Cover cover_features(std::size_t strength, std::uint64_t seed = 1);

/// The rows of found.txt: they failed once, and are cut down to the features that they needed for
/// it.
[[nodiscard]] std::vector<Values> found_rows();

/// The rows of open.txt: they still fail.
[[nodiscard]] std::vector<Values> open_rows();

} // namespace dsc::combinations
