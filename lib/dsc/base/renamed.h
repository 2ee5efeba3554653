// SPDX-License-Identifier: MIT
// Options that had another name in release 0.1. The old names work for one more release.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace dsc {

/// An option's name in release 0.1 and its name now, in scene files and Python.
struct RenamedOption {
    std::string_view old;
    std::string_view now;

    [[nodiscard]] std::string warning() const {
        std::string text = "'";
        text += old;
        text += "' is now called '";
        text += now;
        return text + "'; the next release will refuse the old name";
    }
};

inline constexpr std::array renamed_options{
    RenamedOption{"corner", "feature"},      RenamedOption{"corner_degrees", "feature_degrees"},
    RenamedOption{"carried", "advected"},    RenamedOption{"carried_phases", "advected_phases"},
    RenamedOption{"least_area", "min_area"}, RenamedOption{"least_pixels", "min_pixels"},
    RenamedOption{"least", "min"},           RenamedOption{"most", "max"}};

/// The entry with this old name; null if there is none.
[[nodiscard]] constexpr const RenamedOption* renamed_option(std::string_view old) {
    const auto* found = std::ranges::find(renamed_options, old, &RenamedOption::old);
    return found == renamed_options.end() ? nullptr : found;
}

} // namespace dsc
