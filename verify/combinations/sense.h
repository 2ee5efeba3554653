// SPDX-License-Identifier: MIT
// Which values make no sense together: no simulation could be asked for them, or nobody knows the
// answer. And which the library refuses, with a sentence.
#pragma once

#include "combinations/covering.h"
#include "combinations/row.h"

#include <span>
#include <string_view>

namespace dsc::combinations {

/// Why the features that are set make no sense together; empty if they may.
[[nodiscard]] std::string_view nonsense_in(const Values& values, std::span<const bool> is_set);

/// The same for a whole row.
[[nodiscard]] std::string_view nonsense_in(const Values& values);

/// Rows in which every combination of so many values stands that makes sense.
[[nodiscard]] Cover cover_features(std::size_t strength, std::uint64_t seed = 1);

/// Rows that failed once, cut down to the features that they needed for that.
[[nodiscard]] std::span<const std::string_view> found_rows();

/// Rows that the library must refuse by an InputError, each with two features that contradict
/// each other.
[[nodiscard]] std::span<const std::string_view> refused_rows();

} // namespace dsc::combinations
