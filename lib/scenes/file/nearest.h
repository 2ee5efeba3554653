// SPDX-License-Identifier: MIT
// The existing name that a misspelt one may have meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace dsc::scenes {

/// The first name that goes on where this one ends, or else the one with the fewest letters to
/// change, if they are few; otherwise empty. Letters may be added, left out, exchanged for others,
/// or swapped with their neighbours.
[[nodiscard]] std::string nearest_name(std::string_view name, std::span<const std::string> names);

/// All names, after the nearest one if there is one: "did you mean h? one of: h, dt".
[[nodiscard]] std::string allowed_names(std::string_view name, std::span<const std::string> names);

} // namespace dsc::scenes
